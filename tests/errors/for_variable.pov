#for (I, 1, 3)
	#declare I = "a";
#end
