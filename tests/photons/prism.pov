// A glass prism in a parallel light.
#version 3.7;
// Photons 1 leaves the scene without its caustic: what photons bring is the difference.
#ifndef (Photons) #declare Photons = 200000; #end
global_settings { assumed_gamma 1 max_trace_level 12 photons { count #if (Photons = 1) 2000 radius 1e-9 #else Photons #end } }
camera { orthographic location <1, 10, 0> look_at <1, 0, 0> right 4*x up 4*z }
light_source { <-6, 6, 0>, 0.1 parallel point_at 0 }
plane { y, 0 pigment { rgb <0.8, 0.6, 0.4> } finish { ambient 0 diffuse 0.8 } }
prism {
  linear_sweep -1, 1, 4, <-0.6, 0.4>, <0.6, 0.4>, <0, 1.4>, <-0.6, 0.4> rotate -90*x
  pigment { rgbf <0.9, 1, 0.95, 1> } finish { ambient 0 diffuse 0 }
  interior { ior 1.45 } photons { target refraction on reflection off collect off }
}
