// A glass prism lit from behind by a small strong lamp: shards of light, torn from one another, with spectra at their edges.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 1200000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 10
  photons { count Photon_Count autostop 0 }
}

camera {
  location <5.2, 10.5, -13>
  look_at <2.3, 0.7, -0.9>
  right x * image_width / image_height
  angle 45
}

sky_sphere {
  pigment {
    gradient y
    color_map { [0 color rgb <0.03, 0.035, 0.045>] [0.5 color rgb <0.14, 0.17, 0.22>] [1 color rgb <0.40, 0.44, 0.52>] }
  }
}

// The lamp, behind and to the left.
light_source {
  <-8, 9, 7.5>
  color rgb <1.0, 0.97, 0.92> * 0.62
  photons { refraction on reflection on }
}

light_source {
  <6, 30, -20>
  color rgb <0.6, 0.7, 0.9> * 0.06
  shadowless
  photons { refraction off reflection off }
}

#declare R = 4 / sqrt(3);
prism {
  linear_sweep linear_spline
  0.01, 4.4, 4,
  <0, R>, <-2, -R / 2>, <2, -R / 2>, <0, R>
  rotate y * 32
  pigment { color rgbt <0.98, 0.99, 0.99, 0.98> }
  normal { bumps 0.06 scale 1.2 } // cast by hand, not ground: its faces are not quite flat
  finish {
    ambient 0 diffuse 0
    specular 0.4 roughness 0.001
    reflection { 0, 1 fresnel on } conserve_energy
  }
  interior { ior 1.52 dispersion 1.05 dispersion_samples 24 }
  photons { target reflection on refraction on collect off }
}

plane {
  y, 0
  pigment { color rgb <0.90, 0.89, 0.87> }
  finish { ambient 0 diffuse 0.9 }
}
