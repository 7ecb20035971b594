// An assumed_gamma stays, a light may lack its colour, elements of arrays are undefined one by one.
global_settings { assumed_gamma 1 }
global_settings { assumed_gamma 2.2 }
light_source { <1, 2, 3> }
#declare A = array[2] { 1, 2 }
#undef A[0]
#declare B = A[0];
#undef A[2];
#undef B[1];
