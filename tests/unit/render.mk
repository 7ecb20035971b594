# Unit tests of src/render: one program a module.
