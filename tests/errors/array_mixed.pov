#declare A = array[2] { 1, "two" }
