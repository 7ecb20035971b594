#declare A = 0;
#declare B = 1 / A;
sphere { <0, 1/0, 0>, 1 }
