#declare A = 1;
#declare A[0] = 2;
