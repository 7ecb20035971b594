# Unit tests of src/light: one program a module.
