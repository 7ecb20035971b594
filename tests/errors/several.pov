sphere { A, 1 }
box { B, 1 }
#declare D = C;
cylinder { D, y, 1 }
union { sphere { 0 1 ) } }
