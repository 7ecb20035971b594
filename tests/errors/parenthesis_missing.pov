#declare A = (1 + 2;
#declare B = sin(1;
