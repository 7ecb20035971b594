#version 3.7;
global_settings { assumed_gamma 1 }
// fogs, rainbow, sky_sphere with transforms, background under them, ground fog with turbulence
camera { location <0, 2, -12> look_at <0, 2, 0> angle 70 }
light_source { <-20, 12, -40>, 1 }
background { rgb <.1, .1, .3> }
sky_sphere { pigment { gradient y color_map { [0 rgb <.9, .7, .5>] [.5 rgb <.3, .4, .8>] [1 rgb
    <.1, .1, .4>] } scale 2 translate -1 } rotate 15 * z emission .8 }
fog { fog_type 2 distance 12 color rgbft <.7, .7, .8, .2, .1> fog_offset .3 fog_alt .6 up <.1, 1,
    0> turbulence <1, .2, 1> turb_depth .4 }
fog { distance 120 rgb <.6, .5, .7> }
rainbow { angle 30 width 6 direction <.3, -.15, 1> arc_angle 140 falloff_angle 100 distance 200
    color_map { [0 rgbt <1, 0, 0, 1>] [.3 rgbt <1, .5, 0, .6>] [.6 rgbt <0, 1, 0, .6>] [1 rgbt
        <.5, 0, 1, 1>] } }
plane { y, 0 pigment { checker rgb <.5, .7, .3> rgb <.3, .5, .2> scale 3 } }
#for (I, 0, 6) cone { <I * 4 - 12, 0, I * 6>, 1, <I * 4 - 12, 4, I * 6>, .1 pigment { rgb <.3,
    .5, .3> } } #end
