#version 3.7;
julia_fractal { <0.3, 0.2, 0.1, -0.2> hypercomplex pwr(2.5, 0.3) max_iteration 6 }
julia_fractal { <0.3, 0.2, 0.1, -0.2> hypercomplex pwr 2.5, 0.3 }
julia_fractal { <0.3, 0.2, 0.1, -0.2> hypercomplex pwr(2.5) }
sphere { 0, 1 pigment { gradient x color_map { (0, rgb 1) [1 rgb 0] } } }
