#version 3.7;
global_settings { assumed_gamma 1 }
// Fog weakens a light with media_attenuation, but not within what is not hollow; turbulent fog.
camera { location <0, 4, -14> look_at <0, 0, 0> angle 40 }
fog { distance 20 color rgbft <.3, .4, .6, .3, .1> turbulence <.5, .3, .2> turb_depth 1.5
    octaves 3 omega .4 lambda 2.5 }
fog { fog_type 2 fog_offset -1 fog_alt .5 distance 8 color rgb <.6, .6, .5> turbulence .6 }
light_source { <4, 9, -6>, rgb 6 media_attenuation on }
light_source { <-6, 5, -6>, rgb <.3, .2, .1> media_attenuation on media_interaction off }
plane { y, -1 pigment { checker rgb .9 rgb .4 } hollow }
box { <-3, -.5, -1>, <-1, 2, 1> pigment { rgbf <.9, 1, .9, .9> } }
box { <1, -.5, -1>, <3, 2, 1> pigment { rgbf <1, .9, .9, .9> } hollow }
sphere { <0, .5, 3>, 1 pigment { rgb <.8, .3, .2> } }
