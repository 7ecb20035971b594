#declare A = sqrt(-1);
#declare B = ln(0);
#declare C = acos(2);
#declare D = mod(1, 0);
