#declare S = sphere { 0, 1 }
#declare A = trace(S, 1);
#declare B = trace(1, 0, z);
