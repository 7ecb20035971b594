#version 3.7;
global_settings { assumed_gamma 2.2 ambient_light rgb <1.2, 1, .8> max_trace_level 8
    noise_generator 3 }
// texture maps, layered textures, material_map, gamma 2.2 ambient
#default { finish { ambient .2 diffuse .7 } }
camera { fisheye location <0, 3, -5> look_at <0, .3, 0> angle 110 }
light_source { <5, 8, -7>, rgb <1, .95, .9> }
#declare A = texture { pigment { bozo color_map { [0 srgb <.9, .7, .3>] [1 srgb <.5, .3, .1>] }
    scale .3 } finish { specular .5 } }
#declare B = texture { pigment { granite color_map { [0 rgb .1] [1 rgb .9] } } normal { bumps .5
    scale .1 } }
sphere { <-2, .5, 0>, 1 texture { gradient y texture_map { [.3 A] [.6 B] [.8 pigment { rgb <.2,
    .2, .9> } finish { reflection .3 }] } scale 1.5 } }
sphere { <0, .5, 0>, 1 texture { A } texture { pigment { marble turbulence .5 color_map { [0 rgbt
    <0, 0, 0, .2>] [.5 rgbt <1, 1, 1, 1>] [1 rgbf <.8, .2, .2, .6>] } scale .4 } finish { phong
        .8 } } }
box { -.8, .8 translate <2, .3, 0> texture { material_map { png "palette.png" texture { A }
    texture { B } texture { pigment { rgb <1, 0, 0> } } } translate -.5 scale 1.6 translate <2,
        .3, 0> } }
plane { y, -.5 texture { checker texture { A scale .5 } texture { B } } }
sphere { <-.9, 0, -2>, .5 texture { tiles { texture { A } tile2 texture { B } } scale .3 } }
sphere { <.9, 0, -2>, .5 pigment { average pigment_map { [1 checker rgb 1 rgb 0 scale .2] [2
    gradient x color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 0, 1>] } scale .3] } } }
