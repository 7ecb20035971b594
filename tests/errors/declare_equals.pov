#declare A 5;
#declare B = 6;
#declare = 7;
