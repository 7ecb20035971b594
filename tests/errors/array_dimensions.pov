#declare A = array[2][2] { {1, 2}, {3, 4} }
#declare B = A[1];
#declare C = A[0][1][1];
