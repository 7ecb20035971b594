// A glass ball over a plane, point light.
#version 3.7;
// Photons 1 leaves the scene without its caustic: what photons bring is the difference.
#ifndef (Photons) #declare Photons = 200000; #end
global_settings { assumed_gamma 1 max_trace_level 12 photons { count #if (Photons = 1) 2000 radius 1e-9 #else Photons #end } }
camera { orthographic location <0.6, 0.25, 0> look_at <0.6, 0, 0> right 5*x up 5*z }
light_source { <-4, 8, 0>, 0.002 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
sphere {
  <0, 1.3, 0>, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy }
  interior { ior 1.5 } photons { target refraction on reflection on collect off }
}
