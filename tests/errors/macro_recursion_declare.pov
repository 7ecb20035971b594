#macro A(N)
	#local B = A(N + 1);
	B
#end
#declare C = A(0);
