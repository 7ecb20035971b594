#version 3.7;
global_settings { assumed_gamma 1 }
// functions with splines, pattern functions, #while, recursion; normals by functions
camera { location <0, 3, -7> look_at <0, .3, 0> angle 45 }
light_source { <4, 8, -6>, 1 }
#declare S = spline { natural_spline 0, <0, 0, 0> .3, <1, .5, 0> .6, <0, 1, 1> 1, <-1, 0, 0> }
#declare FS = function { spline { cubic_spline -1, 0 0, .1 .5, .8 1, .2 2, 0 } }
#declare FP = function { pattern { agate scale .7 } }
#declare FC = function { pigment { bozo color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 1, 1>] } scale
    .4 } }
#declare F = function (x, y, z, k) { sin(k * x) * cos(k * z) * exp(-x * x - z * z) }
height_field { function 60, 60 { F(x * 4 - 2, 0, y * 4 - 2, 5) * .5 + .5 } smooth translate <-.5,
    0, -.5> scale <6, 1, 6> pigment { function { FP(x, y, z) } color_map { [0 rgb <.2, .3,
        .1>] [1 rgb <.8, .9, .6>] } } }
#declare I = 0;
#while (I <= 1) sphere { S(I) + y, .1 + FS(I).x * .2 pigment { rgb FC(I * 3, 0, 0) } }
    #declare I = I + .06; #end
#macro Tree(D, L) #if (D > 0) cylinder { 0, L * y, L * .08 } #local A = -35; #while (A <= 35)
    object { union { Tree(D - 1, L * .7) } rotate A * z rotate 40 * D * y translate L * y }
        #local A = A + 35; #end #end #end
union { Tree(4, 1) translate <2, .3, .5> pigment { rgb <.6, .4, .2> } }
sphere { <-2, 1.4, 0>, .8 pigment { rgb .8 } normal { function { FP(x * 3, y * 3, z * 3) } 1.2 }
    finish { phong .8 } }
