#version 3.7;
global_settings { assumed_gamma 1 }
// normals: slope_map, accuracy, normal_map, bump_size, uv, average; facets; wrinkles
camera { location <0, 3, -9> look_at <0, 0, 0> angle 46 }
light_source { <6, 8, -7>, 1 }
plane { y, -1.2 pigment { rgb .8 } normal { ripples .4 frequency 2 turbulence .2 scale .7 } }
#macro B(X, Y, N) sphere { <X, Y, 0>, .9 pigment { rgb <.8, .8, .9> } normal { N } finish { phong
    .7 } } #end
B(-3, 1, normal { gradient y slope_map { [0 <0, 1>] [.5 <1, 1>] [.5 <1, -1>] [1 <0, -1>] } scale
    .3 accuracy .005 })
B(-1, 1, normal { gradient x normal_map { [0 bumps .8 scale .1] [.5 wrinkles 1 scale .3] [1 dents
    1 scale .2] } scale 1.5 })
B(1, 1, normal { facets coords .3 scale 1 })
B(3, 1, normal { average normal_map { [1 waves .7 scale .2] [2 quilted 1 scale .4] } })
B(-3, -.9, normal { bump_map { png "bump.png" bump_size 4 interpolate 2 } translate -.5 scale 2 })
B(-1, -.9, normal { uv_mapping bump_map { png "bump.png" bump_size 2 } })
B(1, -.9, normal { crackle .8 scale .3 accuracy .05 })
B(3, -.9, normal { leopard 1 scale .1 bump_size .5 no_bump_scale })
