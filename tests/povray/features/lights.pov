#version 3.7;
global_settings { assumed_gamma 1 }
// lights: fading, looks_like, projected_through, light_group, cylinder, area orient, spot
camera { location <0, 5, -10> look_at <0, 0, 0> angle 46 }
plane { y, -1 pigment { rgb .9 } }
plane { -z, -6 pigment { rgb .7 } }
light_source { <-4, 1, 2>, rgb <1, .8, .5> * 2 fade_distance 1 fade_power 2 looks_like { sphere {
    0, .2 pigment { rgb <1, .9, .6> } finish { emission 1 ambient 0 } } } }
light_source { <3, 6, -2>, rgb .7 projected_through { torus { .6, .2 translate <3, 2, 0> } } }
light_source { <0, 6, 0>, rgb <.2, .5, 1> spotlight radius 8 falloff 16 tightness 3 point_at <0,
    -1, 0> }
light_source { <-2, 5, -6>, rgb <.7, .2, .2> cylinder radius .6 falloff 1.2 tightness 1 point_at
    <-2, -1, -1> }
light_group { light_source { <4, 3, -5>, rgb <0, 1, .3> } sphere { <2.5, -.2, -2>, .7 pigment {
    rgb 1 } } global_lights off }
light_group { light_source { <-4, 3, -5>, rgb <1, 0, 1> } box { <-1, -1, -3>, <0, 0, -2> pigment
    { rgb 1 } } global_lights on }
sphere { <0, 0, 1>, .8 pigment { rgb 1 } }
sphere { <-3.5, -.3, -1>, .6 pigment { rgb 1 } finish { phong 1 } }
