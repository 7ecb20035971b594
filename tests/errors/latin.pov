// café
#declare A = "café"; #debug A
sphere { café, 1 }
