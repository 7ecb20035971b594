#version 3.7;
global_settings { assumed_gamma 1 }
// How wide the lens is, what is in focus, and the pixel's own share of the blur.
camera {
  location <0, 2, -7> look_at <0, 0, 0> angle 50
  aperture .6 blur_samples 200 focal_point <0, 0, -1> variance 0
}
light_source { <5, 8, -7>, 1 }
plane { y, -1 pigment { checker rgb .8 rgb .5 scale 2 } }
#for (I, -2, 2)
  sphere { <I * 1.3, 0, I * 1.5>, .8 pigment { rgb <.5 + I * .2, .5, .5 - I * .2> } }
#end
