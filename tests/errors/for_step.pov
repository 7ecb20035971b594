#for (I, 1, 10, 0) #end
#for (I, 1) #end
#for (1, 2, 3) #end
