# Unit tests of src/density: one program a module.
