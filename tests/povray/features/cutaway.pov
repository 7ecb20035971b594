#version 3.7;
global_settings { assumed_gamma 1 }
// Faces without a texture show those of what they cut: of one part, of two, of none.
camera { location <3, 5, -10> look_at <0, -.2, 0> angle 42 }
light_source { <5, 8, -8>, 1 }
#declare Corner = box { <0, 0, -2>, <2, 2, 0> }
#declare Red = sphere { 0, 1.1 pigment { rgb <1, .3, .2> } }
difference { object { Red } object { Corner } cutaway_textures translate <-3, 1.2, 0> }
difference { union { object { Red } sphere { .3 * x, .9 pigment { checker rgb <0, .3, .2> rgb 1
    scale .2 } } } object { Corner } cutaway_textures translate <0, 1.2, 0> }
difference { difference { object { Red } cylinder { -2 * y, 2 * y, .3 pigment { rgb z } } }
    object { Corner } cutaway_textures translate <3, 1.2, 0> }
intersection { object { Red } box { -.9, .9 } cutaway_textures translate <-3, -1.4, 0> }
difference { merge { object { Red } sphere { .3 * x, 1 } } object { Corner } cutaway_textures
    rotate 10 * y translate <0, -1.4, 0> }
union { difference { sphere { 0, 1.1 pigment { bozo scale .2 } } object { Corner }
    cutaway_textures } pigment { rgb <.2, .4, .9> } translate <3, -1.4, 0> }
