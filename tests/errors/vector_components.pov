#declare V = <1>;
#declare W = <1, "2", 3>;
#declare U = <1,2,3,4,5,6>;
