# Unit tests of src/surface: one program a module.
