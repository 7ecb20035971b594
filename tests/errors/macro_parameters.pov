#macro A(x, y) #end
#macro B(P Q) #end
#macro C #end
