#declare A = 1 + ;
#declare B = * 2;
#declare C = (1, 2);
