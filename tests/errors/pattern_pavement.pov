// Which tiles there are, and words that belong to pavements alone.
plane { y, 0 pigment { pavement number_of_sides 5 } }
plane { y, 1 pigment { pavement number_of_sides 6 number_of_tiles 6 } }
plane { y, 2 pigment { pavement pattern 3 number_of_tiles 3 number_of_sides 4 } }
plane { y, 3 pigment { pavement number_of_tiles } }
plane { y, 4 pigment { checker number_of_sides 4 } }
