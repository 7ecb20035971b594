sphere { 0, 1 box { ) } pigment { rgb 1 } }
box { 0, undeclared }
