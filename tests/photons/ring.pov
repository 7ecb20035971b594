// A metal ring on a plane, point light: the nephroid.
#version 3.7;
// Photons 1 leaves the scene without its caustic: what photons bring is the difference.
#ifndef (Photons) #declare Photons = 200000; #end
global_settings { assumed_gamma 1 max_trace_level 12 photons { count #if (Photons = 1) 2000 radius 1e-9 #else Photons #end } }
camera { orthographic location <0, 10, 0> look_at 0 right 2.4*x up 2.4*z }
light_source { <-6, 4, 0>, 0.1 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
difference {
  cylinder { 0, 0.6*y, 1.1 } cylinder { -y, y, 1 }
  pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection <0.9, 0.7, 0.4> }
  photons { target reflection on refraction off collect off }
}
