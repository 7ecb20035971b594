// A loop with a mistake goes round once, though it would never end.
#local I = 0;
#while (I < 3)
  sphere { Q, 1 }
  #local I = I + ;
#end
#for (J, 0, 1e9)
  sphere { <J, 0>, -R }
  #local J = 0;
#end
