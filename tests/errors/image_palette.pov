#version 3.7;
plane { z, 0 pigment { image_map { ppm "colors.ppm" filter 0, 0.5 transmit all 0.5 } } }
plane { z, 0 pigment { image_map { ppm "colors.ppm" transmit -1, 0.5 } } }
plane { z, 0 pigment { image_map { png "palette.png" filter 1, 0.5 transmit 2, 0.5 } } }
plane { z, 0 pigment { image_map { png "palette.png" interpolate 2 } } }
plane { z, 0 pigment { image_map { png "palette.png" interpolate 1 } } }
