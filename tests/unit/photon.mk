# Unit tests of src/photon: one program a module.
