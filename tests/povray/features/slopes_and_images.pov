#version 3.7;
global_settings { assumed_gamma 1 }
// slope and aoi patterns, altitude, image_map interpolation and once, object pattern, cells,
// cubic, planar
camera { location <0, 4, -8> look_at <0, .5, 0> angle 50 }
light_source { <4, 9, -6>, 1 }
plane { y, 0 pigment { image_map { png "map.png" once interpolate 2 } rotate 90 * x scale 6
    translate <-3, 0, -2> } }
sphere { <-2.5, 1, 0>, 1 pigment { slope { y, .3, .9 } color_map { [0 rgb <.3, .2, .1>] [.5 rgb
    <0, .6, 0>] [1 rgb 1] } } }
sphere { <0, 1, 0>, 1 pigment { slope { <1, 1, 0>, 0, .5 altitude y, 0, 2 } color_map { [0 rgb
    <1, 0, 0>] [1 rgb <0, 0, 1>] } } }
sphere { <2.5, 1, 0>, 1 pigment { aoi color_map { [0 rgb <1, 1, 0>] [.6 rgb <0, .5, .5>] [1 rgb
    0] } } }
box { <-4, 0, 2>, <-2, 2, 4> pigment { object { sphere { <-3, 1, 2>, .7 } rgb .2, rgb <1, .6, .2>
    } } }
box { <-1, 0, 2>, <1, 2, 4> pigment { image_map { png "map.png" map_type 0 interpolate 4 } scale
    2 translate x } }
box { <2, 0, 2>, <4, 2, 4> pigment { image_pattern { png "bump.png" interpolate 3 } scale <2, 2,
    1> translate 2 * x color_map { [0 rgb <.1, 0, .3>] [1 rgb <1, 1, .6>] } } normal { bump_map {
        png "bump.png" bump_size 3 interpolate 2 } scale <2, 2, 1> translate 2 * x } }
