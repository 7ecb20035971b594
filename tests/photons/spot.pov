// A lens in a spotlight that fades with the square of the distance, with tinted fading glass.
#version 3.7;
// Photons 1 leaves the scene without its caustic: what photons bring is the difference.
#ifndef (Photons) #declare Photons = 200000; #end
global_settings { assumed_gamma 1 max_trace_level 12 photons { count #if (Photons = 1) 2000 radius 1e-9 #else Photons #end } }
camera { orthographic location <0, 3, 0> look_at 0 right 1.6*x up 1.6*z }
light_source { <0, 20, 0>, 0.01 spotlight point_at 0 radius 5 falloff 8 fade_distance 6 fade_power 2 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
intersection {
  sphere { -3*y, 3.2 } sphere { 3*y, 3.2 } translate 4*y
  pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
  interior { ior 1.5 fade_distance 0.5 fade_power 1001 fade_color <0.4, 0.8, 0.6> }
  photons { target refraction on reflection off collect off }
}
