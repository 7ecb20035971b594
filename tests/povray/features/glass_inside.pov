#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 25 }
// Fresnel's mirrors of glass within other objects: a hollow ball, a wall's inside, water.
camera { location <0, 1, -7> look_at 0 angle 52 }
light_source { <3, 6, -6>, 1 }
#declare Glass = texture { pigment { rgbf 1 } finish { diffuse .1 specular .5 reflection { .1, 1
    fresnel } conserve_energy } }
plane { -z, -9 pigment { checker rgb .9 rgb <.3, .5, .8> } finish { ambient .6 diffuse .3 } }
plane { y, -1.2 pigment { checker rgb .8 rgb <.7, .5, .3> } hollow }
sphere { 0, 40 pigment { rgb <.7, .8, 1> } finish { ambient 1 diffuse 0 } hollow }
sphere { <-2.3, 0, 0>, 1.1 texture { Glass } interior { ior 1.5 fade_distance 2 fade_power 1001
    fade_color <.35, .65, .85> } }
box { -1, 1 rotate 30 * y scale .9 texture { Glass } interior { ior 1.7 } }
union {
  box { -1.1, 1.1 texture { Glass } interior { ior 1.33 } }
  sphere { 0, .7 texture { Glass } interior { ior 1.6 } }
  rotate -20 * y translate 2.6 * x
}
