#macro A(P) #declare P = 1; #end
A(New)
