#declare A = sum(i, 1, 3, i);
