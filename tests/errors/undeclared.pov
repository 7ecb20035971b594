sphere { <0, Height, 0>, 1 }
Call(1, 2)
texture { Stone }
