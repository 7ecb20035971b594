#version 3.7;
global_settings { assumed_gamma 1 }
// groups in groups: the outermost says whether the scene's other lights reach in
camera { orthographic location <0, 0, -10> look_at 0 right x * 8 up y * 6 }
light_source { <0, 6, -6>, rgb .6 }
plane { -z, -2 pigment { rgb .8 } }
#macro Pair(Y, Inner, Outer)
light_group { light_source { <4, Y, -5>, rgb <.7, 0, 0> } sphere { <2, Y, 0>, .9 pigment { rgb 1 } }
    light_group { light_source { <-4, Y, -5>, rgb <0, .5, 0> } sphere { <-2, Y, 0>, .9 pigment {
        rgb 1 } } global_lights Inner } global_lights Outer }
#end
Pair(2, on, off)
Pair(0, off, on)
Pair(-2, on, on)
sphere { 0, .6 pigment { rgb 1 } }
