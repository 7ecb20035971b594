#macro Inner(P)
	sphere { P, Undeclared }
#end
#macro Outer()
	Inner(<1,2,3>)
#end
#include "chain.inc"
