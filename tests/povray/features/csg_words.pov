#version 3.7;
global_settings { assumed_gamma 1 }
// cutaway_textures, interior_texture, double_illuminate, no_image, no_reflection, inverse,
// clipped_by, bounded_by, merge, hollow
camera { location <0, 4, -9> look_at <0, 0, 0> angle 48 }
light_source { <5, 8, -8>, 1 }
plane { y, -1.3 pigment { checker rgb .8 rgb .6 } finish { reflection .3 } }
difference { sphere { 0, 1.1 pigment { rgb <1, .3, .2> } } box { <0, 0, -2>, <2, 2, 0> }
    cutaway_textures translate -3 * x }
sphere { 0, 1 clipped_by { plane { y, .3 } } pigment { rgb <.2, .6, 1> } interior_texture {
    pigment { checker rgb 1 rgb <1, .8, 0> scale .2 } } translate <-.7, 0, 0> }
disc { <1.6, .2, 0>, <.5, .4, 1>, .9 pigment { rgb <.9, .9, .3> } double_illuminate }
sphere { <3.3, 0, 0>, .9 pigment { rgb <.4, .9, .4> } no_image }
sphere { <1, -.6, -2>, .6 pigment { rgb <.9, .4, .9> } no_reflection }
sphere { <-2, -.7, -2>, .5 pigment { rgb <.9, .9, .9> } no_shadow }
intersection { box { -.8, .8 } sphere { 0, .9 inverse } pigment { rgb <1, .6, .1> } translate
    <3.2, -.3, -1.5> }
merge { sphere { -.3 * x, .5 } sphere { .3 * x, .5 } pigment { rgbf <.8, .9, 1, .8> } interior {
    ior 1.2 } translate <-.5, -.5, -3> }
union { box { -.3, .3 } sphere { .5 * y, .3 } split_union off pigment { rgb <.3, .3, .9> }
    bounded_by { box { <-.4, -.4, -.4>, <.4, .9, .4> } } translate <2.4, 1.6, 0> }
quadric { <1, 0, 1>, <0, 0, 0>, <0, -.5, 0>, 0 clipped_by { box { <-1, 0, -1>, <1, 1.4, 1> } }
    bounded_by { clipped_by } pigment { rgb .9 } translate <-1, .6, 2.5> }
