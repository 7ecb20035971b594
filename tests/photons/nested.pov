// Liquid in a glass, an area light, a receiver with highlights.
#version 3.7;
// Photons 1 leaves the scene without its caustic: what photons bring is the difference.
#ifndef (Photons) #declare Photons = 200000; #end
global_settings { assumed_gamma 1 max_trace_level 15 photons { count #if (Photons = 1) 2000 radius 1e-9 #else Photons #end } }
camera { orthographic location <0.8, 10, 0> look_at <0.8, 0, 0> right 4*x up 4*z }
light_source { <-6, 7, 0>, 0.02 area_light 0.4*z, 0.4*y, 4, 4 adaptive 1 photons { area_light } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.8 specular 0.3 roughness 0.05 } }
union {
  difference {
    cylinder { 0.05*y, 2*y, 0.8 } cylinder { 0.2*y, 3*y, 0.7 }
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 }
  }
  cylinder { 0.201*y, 1.5*y, 0.699 pigment { rgbf <1, 0.5, 0.3, 0.9> } finish { ambient 0 diffuse 0 } interior { ior 1.33 } }
  photons { target refraction on reflection off collect off }
}
