#version 3.7;
global_settings { assumed_gamma 1 }
// isosurfaces with all_intersections in CSG, parametric, superellipsoid, julia, lathe, sor
camera { location <0, 3, -8> look_at <0, .2, 0> angle 48 }
light_source { <5, 9, -7>, 1 }
plane { y, -1.4 pigment { rgb .7 } }
#include "functions.inc"
difference {
  isosurface { function { f_sphere(x, y, z, 1) - f_noise3d(x * 4, y * 4, z * 4) * .3 }
      max_gradient 3 contained_by { sphere { 0, 1.3 } } all_intersections }
  box { <0, -2, -2>, <2, 2, 0> } pigment { rgb <.9, .6, .3> } translate -2.4 * x }
isosurface { function { abs(x) + abs(y) + abs(z) - 1 } threshold 0 max_gradient 2 contained_by {
    box { -.8, .8 } } open pigment { rgb <.3, .7, .9> } translate <0, 0, 0> }
parametric { function { cos(u) * (1 + .3 * cos(v)) } function { .4 * sin(v) } function {
    sin(u) * (1 + .3 * cos(v)) } <0, 0>, <2 * pi, 2 * pi> contained_by { box { -1.5, 1.5 } }
        accuracy .001 max_gradient 1 precompute 12 x, y, z pigment { rgb <.8, .3, .5> } translate
        <2.4, -.5, 0> }
superellipsoid { <.3, 2.2> scale .7 translate <2.3, .9, 0> pigment { rgb <.5, .9, .4> } }
lathe { cubic_spline 6, <0, -1>, <.4, -.9>, <.2, 0>, <.5, .4>, <.1, .8>, <0, 1> scale .6
    translate <-.9, -.8, -2> pigment { rgb <.9, .9, .4> } finish { phong 1 } }
sor { 6, <.1, -.2>, <.5, 0>, <.2, .5>, <.4, .9>, <.2, 1.2>, <.1, 1.4> open translate <.9, -1.4,
    -2> pigment { rgb <.4, .5, 1> } }
julia_fractal { <-.083, 0, -.83, -.025> quaternion sqr max_iteration 6 precision 40 scale .7
    translate <0, 1.5, 1> pigment { rgb <1, .5, .5> } }
