#declare A = val("abc") + asc("");
#declare B = substr("abc", 5, 2);
