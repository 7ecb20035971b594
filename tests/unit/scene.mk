# Unit tests of src/scene: one program a module.
