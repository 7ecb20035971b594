// A prism of glass, cast with faintly wavy faces, before a strong small lamp: shards of light that
// lie over one another.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 400000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 10
  photons { count Photon_Count autostop 0 }
}

camera {
  location <-0.4, 11, -11.0>
  look_at <-0.3, 0, -2.9>
  right x * image_width / image_height
  angle 38
}

light_source {
  <-2.5, 7, 9>
  color rgb <1.0, 0.93, 0.80> * 0.6
  photons { refraction on reflection on }
}

#declare Waves = function(x, y, z) {
  0.012 * sin(3.1 * x + 1.3 * y) + 0.010 * sin(2.3 * y - 2.9 * z) + 0.008 * sin(4.7 * z + 2 * x)
};

isosurface {
  function {
    max(max(0.8660254 * abs(x) - 0.5 * z, z) - 1.0, abs(y - 1.6) - 1.6) + Waves(x, y, z)
  }
  contained_by { box { <-2.6, -0.1, -2.6>, <2.6, 3.4, 2.6> } }
  max_gradient 1.4
  accuracy 0.0005
  rotate y * 18
  translate y * 0.15
  pigment { color rgbt <0.98, 0.99, 0.99, 0.98> }
  finish {
    ambient 0 diffuse 0
    specular 0.4 roughness 0.001
    reflection { 0, 1 fresnel on } conserve_energy
  }
  interior { ior 1.52 }
  photons { target reflection on refraction on collect off }
}

plane {
  y, 0
  pigment { color rgb 0.85 }
  finish { ambient 0.02 diffuse 0.9 }
}
