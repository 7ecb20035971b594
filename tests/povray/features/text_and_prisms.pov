#version 3.7;
global_settings { assumed_gamma 1 charset utf8 }
// text with unicode, align by extents, prisms of every spline with holes, conic sweep
#include "shapes.inc"
camera { location <0, 3, -9> look_at <0, .4, 0> angle 48 }
light_source { <3, 9, -8>, 1 }
plane { y, -1 pigment { rgb .8 } }
#declare T = text { ttf "cyrvetic.ttf" "a\u0416\u042fb \u00e9" .3, <.05, 0, 0> }
object { T translate -(min_extent(T) + max_extent(T)) / 2 scale 1.2 translate <0, 1.9, 0> pigment
    { rgb <.8, .2, .2> } }
Center_Object(text { ttf "crystal.ttf" "q%Z" .2, .1 pigment { rgb <.1, .5, .2> } translate y * .8
    }, x)
prism { linear_spline 0, .5, 10, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <-.5, -.5>, <.5,
    -.5>, <.5, .5>, <-.5, .5>, <-.5, -.5> translate <-3, -1, 0> pigment { rgb <.9, .7, .3> } }
prism { bezier_spline linear_sweep 0, .4, 8, <0, -1>, <.8, -1>, <.8, 1>, <0, 1>, <0, 1>, <-.3,
    .3>, <-.3, -.3>, <0, -1> translate <-.6, -1, -1> pigment { rgb <.3, .7, .9> } }
prism { conic_sweep quadratic_spline 0, 1, 7, <-.5, -1>, <-1, -1>, <1, -1>, <1.3, .5>, <0, 1.2>,
    <-1, .6>, <-1, -1> rotate 180 * x translate <1.8, .2, 0> pigment { rgb <.6, .9, .5> } }
prism { cubic_spline 0, .6, 8, <-1, 0>, <0, -1>, <1, 0>, <.6, .9>, <0, .4>, <-1, 0>, <0, -1>, <1,
    0> open scale .8 translate <3.5, -1, 0> pigment { rgb <.9, .4, .9> } }
