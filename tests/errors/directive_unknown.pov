#foo
#declere A = 1;
#sphere
