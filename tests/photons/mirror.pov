// A flat mirror throws a point light's and a cylinder light's beam on a wall.
#version 3.7;
// Photons 1 leaves the scene without its caustic: what photons bring is the difference.
#ifndef (Photons) #declare Photons = 200000; #end
global_settings { assumed_gamma 1 max_trace_level 12 photons { count #if (Photons = 1) 2000 radius 1e-9 #else Photons #end } }
camera { orthographic location <-6, 2.5, 0> look_at <4, 2.5, 0> right 5*z up 5*y }
light_source { <-4, 6, 1>, 0.2 }
light_source { <-3, 4, -1>, <0.1, 0.2, 0.3> cylinder point_at 0 radius 0.7 falloff 1 tightness 0 }
plane { x, 4 pigment { rgb 1 } finish { ambient 0 diffuse 1 brilliance 2 } }
box {
  <-1, -0.1, -1>, <1, 0, 1> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.8 }
  photons { target reflection on refraction off collect off }
}
