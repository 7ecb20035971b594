#declare V = <1,2,3>;
#declare A = V.w;
#declare B = V.red;
