// Tilings have numbers from 1 to 27, of which the last three are missing.
plane { y, 0 pigment { tiling 0 } }
plane { y, 1 pigment { tiling 28 } }
plane { y, 2 pigment { tiling } }
plane { y, 3 pigment { tiling 25 color_map { [0 rgb 0] [1 rgb 1] } } }
