# Unit tests of lang: one program a module.
