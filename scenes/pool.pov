// A tiled pool in the sun. The water is an isosurface; its waves draw the net of light on the floor.
// Plain POV-Ray 3.7; one unit is a metre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 300000; #end

#include "functions.inc"

global_settings {
  assumed_gamma 1.0
  max_trace_level 6
  photons { count Photon_Count autostop 0 }
}

camera {
  location <-1.6, 3.6, -5.6>
  look_at <0.15, -1.05, 0.0>
  right x * image_width / image_height
  angle 46
}

sky_sphere {
  pigment {
    gradient y
    color_map { [0 color rgb <0.62, 0.72, 0.85>] [0.6 color rgb <0.16, 0.34, 0.68>] }
  }
}

light_source {
  <-60, 100, 30>
  color rgb <1.0, 0.96, 0.90> * 0.8
  parallel point_at 0
  photons { refraction on reflection off }
}

#declare Ripples = function(x, z) {
  0.030 * sin(2.6 * x + 1.1 * z) + 0.022 * sin(-1.7 * x + 3.4 * z + 1.0) + 0.016 * sin(4.6 * x - 3.3 * z + 2.1)
  + 0.010 * sin(6.3 * x + 5.4 * z + 0.4) + 0.05 * (f_noise3d(1.3 * x, 0.7, 1.3 * z) - 0.5)
};

isosurface {
  function { y - Ripples(x, z) }
  contained_by { box { <-3.05, -1.55, -2.55>, <3.05, 0.2, 2.55> } }
  max_gradient 1.35
  accuracy 0.002
  pigment { color rgbt <0.93, 0.98, 0.99, 1> }
  finish {
    ambient 0 diffuse 0
    specular 0.3 roughness 0.002
    reflection { 0, 1 fresnel on } conserve_energy
  }
  interior { ior 1.33 fade_distance 3 fade_power 1001 fade_color rgb <0.45, 0.80, 0.85> }
  photons { target refraction on reflection off collect off }
}

#declare Tiles = texture {
  pigment {
    brick color rgb <0.72, 0.78, 0.78>, color rgb <0.42, 0.74, 0.82>
    brick_size <0.3, 0.3, 0.3> mortar 0.012
    translate <0.15, 0.15, 0.15>
  }
  finish { ambient 0.08 diffuse 0.8 }
};

// The basin, cut into the ground, with steps of stone around it.
difference {
  box { <-12, -2, -12>, <12, 0.12, 12> }
  box { <-3, -1.5, -2.5>, <3, 1, 2.5> texture { Tiles } }
  pigment {
    brick color rgb <0.55, 0.52, 0.48>, color rgb <0.80, 0.76, 0.70>
    brick_size <0.9, 0.4, 0.9> mortar 0.015
    translate <0.3, 0.2, 0.1>
  }
  finish { ambient 0.08 diffuse 0.8 }
}
