#declare F = function(a, b) { a + b }
#declare B = F(1);
