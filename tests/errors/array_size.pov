#declare A = array[0];
#declare B = array[2] { 1, 2, 3 }
