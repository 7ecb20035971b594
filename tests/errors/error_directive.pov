#declare A = 1;
#error concat("stopped at ", str(A, 0, 0))
sphere { undeclared, 1 }
