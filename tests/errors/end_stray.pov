#declare A = 1;
#end
