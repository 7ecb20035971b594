#declare F = function(a, b) { a + c }
#declare G = function { x + ) }
