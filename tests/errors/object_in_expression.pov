#declare S = sphere { 0, 1 }
#declare A = S + 1;
#declare B = sin(S);
