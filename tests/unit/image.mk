# Unit tests of src/image: one program a module.
