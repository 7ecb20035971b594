# Unit tests of src/geom: one program a module.
