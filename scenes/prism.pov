// A glass prism in the light of a small strong lamp, through a slit: a spectrum across the table.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 400000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 8
  photons { count Photon_Count autostop 0 }
}

camera {
  location <5.0, 12, -12>
  look_at <4.0, 0.2, -1.2>
  right x * image_width / image_height
  angle 48
}

sky_sphere {
  pigment {
    gradient y
    color_map { [0 color rgb <0.05, 0.06, 0.08>] [0.5 color rgb <0.22, 0.26, 0.32>] [1 color rgb <0.45, 0.48, 0.55>] }
  }
}

// The lamp. Its light meets the prism so that inside it runs along the base: the least deviation.
#declare Way = vnormalize(<0.943, 0, 0.333>);
#declare Entry = <-1.0, 1.9, 0.577>;
#declare Lamp = Entry - 12 * Way + y * 2.0;

light_source {
  Lamp
  color rgb 4.0
  photons { refraction on reflection on }
}

light_source {
  <6, 30, -20>
  color rgb <0.6, 0.7, 0.9> * 0.10
  shadowless
  photons { refraction off reflection off }
}

// Its housing: a box, black inside, open towards the plate.
difference {
  box { <-1.5, -1.5, -1.0>, <1.5, 1.5, 3> }
  box { <-1.4, -1.4, -0.9>, <1.4, 1.4, 4> }
  rotate y * (90 - degrees(atan2(Way.z, Way.x)))
  translate Lamp
  pigment { color rgb 0.08 }
  finish { ambient 0 diffuse 0.5 }
}

// The plate with its slit, half way between lamp and prism.
#declare Slit = 0.11;
difference {
  box { <-9, 0, -0.05>, <9, 12, 0.05> }
  box { <-Slit / 2, 0.3, -1>, <Slit / 2, 6, 1> }
  rotate y * (90 - degrees(atan2(Way.z, Way.x)))
  translate Entry - 5 * Way - y * Entry.y
  pigment { color rgb 0.12 }
  finish { ambient 0 diffuse 0.7 }
}

#declare R = 4 / sqrt(3);
prism {
  linear_sweep linear_spline
  0.02, 4, 4,
  <0, R>, <-2, -R / 2>, <2, -R / 2>, <0, R>
  pigment { color rgbt <0.98, 0.99, 0.99, 0.98> }
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
  pigment { color rgb 0.92 }
  finish { ambient 0 diffuse 0.9 }
}
