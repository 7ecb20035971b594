# Unit tests of parser: one program a module.
