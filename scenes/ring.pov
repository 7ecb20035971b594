// A metal ring on a table in slanting parallel light: the nephroid, best seen of all caustics.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 200000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 8
  photons { count Photon_Count autostop 0 }
}

camera {
  location <0, 15, -11>
  look_at <0, 0, 0>
  right x * image_width / image_height
  angle 36
}

background { color rgb <0.02, 0.02, 0.03> }

light_source {
  <-30, 26, 10>
  color rgb <1.0, 0.95, 0.86> * 0.8
  parallel point_at <0, 0, 0>
  photons { reflection on }
}

difference {
  cylinder { <0, 0, 0>, <0, 1.6, 0>, 3.1 }
  cylinder { <0, -1, 0>, <0, 2, 0>, 3.0 }
  pigment { color rgb <1.0, 0.80, 0.42> }
  finish {
    ambient 0 diffuse 0.1
    specular 0.5 roughness 0.01 metallic
    reflection { 0.85 metallic }
  }
  photons { target reflection on refraction off collect off }
}

plane {
  y, 0
  pigment { color rgb <0.92, 0.90, 0.87> }
  finish { ambient 0.06 diffuse 0.8 }
}
