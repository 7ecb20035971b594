#macro A() 1 #end
sphere { 0, A }
