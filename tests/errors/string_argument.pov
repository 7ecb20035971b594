#declare A = strlen(5);
#declare B = concat("a", 1);
#declare C = sin("x");
