// What is told in a loop is told once for each place.
#macro Half(A) (A / 2 + 1 / 0) #end
#local Sum = 0;
#for (I, 1, 100)
  #local Sum = Sum + Half(I)
#end
sphere { Sum 1 }
camera { }
