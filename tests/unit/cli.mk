# Unit tests of cli: one program a module.
