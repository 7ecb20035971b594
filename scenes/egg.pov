// A glass egg on a cloth, with the light that it focuses.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 300000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 10
  photons { count Photon_Count autostop 0 }
}

camera {
  location <2, 9, -15>
  look_at <1.2, 1.4, 0>
  right x * image_width / image_height
  angle 32
}

sky_sphere {
  pigment {
    gradient y
    color_map { [0 color rgb <0.10, 0.11, 0.13>] [1 color rgb <0.35, 0.42, 0.55>] }
  }
}

light_source {
  <-24, 26, 8>
  color rgb <1.0, 0.96, 0.88> * 0.9
  photons { refraction on reflection on }
}

// The outline: two arcs joined by one that touches both, turned about the axis.
sor {
  9,
  <0.00, -0.30>, <0.02, 0.00>, <1.16, 0.50>, <1.70, 1.40>, <1.76, 2.10>, <1.44, 3.30>, <0.82, 4.25>, <0.02, 4.62>,
  <0.00, 4.70>
  rotate z * -74
  translate <-1.8, 1.76, 0>
  rotate y * 24
  pigment { color rgbt <0.97, 0.99, 0.98, 0.98> }
  finish {
    ambient 0 diffuse 0
    specular 0.7 roughness 0.0008
    reflection { 0, 1 fresnel on } conserve_energy
  }
  interior { ior 1.5 fade_distance 6 fade_power 1 fade_color rgb <0.6, 0.9, 0.8> }
  photons { target reflection on refraction on collect off }
}

plane {
  y, 0
  pigment { color rgb <0.80, 0.76, 0.68> }
  finish { ambient 0.05 diffuse 0.85 }
}
