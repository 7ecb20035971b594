// A crab of polished copper in the lid of a tin: its wall throws a cusp of light over the crab's shadows. Through a lens wide
// open.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons, Lens_Samples=N for a smoother blur.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 300000; #end
#ifndef (Lens_Samples) #declare Lens_Samples = 12; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 6
  photons { count Photon_Count autostop 0 }
}

camera {
  location <-4.5, 8.2, -13>
  look_at <0, 0.2, -0.6>
  right x * image_width / image_height
  angle 40
  aperture 1.2
  blur_samples Lens_Samples
  focal_point <-0.4, 0.9, -1.6>
  variance 0
}

sky_sphere {
  pigment {
    gradient y
    color_map { [0 color rgb <0.20, 0.16, 0.12>] [0.4 color rgb <0.45, 0.50, 0.58>] [1 color rgb <0.10, 0.14, 0.22>] }
  }
}

light_source {
  <20, 17, 17>
  color rgb <1.0, 0.94, 0.84> * 0.95
  photons { reflection on }
}

// One side's limbs; the other side is its mirror image.
#macro Limb(A, B, C, Thick)
  sphere_sweep {
    linear_spline
    4,
    A, Thick, A * 0.45 + B * 0.55 + y * 0.12, Thick * 1.15, B, Thick * 0.8, C, Thick * 0.3
  }
#end

#declare Side = union {
  #for (I, 0, 3)
    Limb(<1.1, 0.7, 0.8 - I * 0.5>, <2.6, 1.5, 1.6 - I * 1.0>, <3.6, -0.15, 2.1 - I * 1.25>, 0.17)
  #end
  // The arm and the two fingers of its claw.
  Limb(<1.1, 0.8, -0.9>, <2.2, 1.0, -2.0>, <1.4, 0.9, -3.2>, 0.24)
  difference {
    sphere { 0, 1 scale <0.55, 0.36, 0.85> }
    cylinder { <0.1, -1, -0.75>, <0.1, 1, -0.75>, 0.42 }
    rotate y * 18
    translate <1.25, 0.85, -3.1>
  }
  // The eye on its stalk.
  cone { <0.35, 0.9, -1.1>, 0.09, <0.42, 1.45, -1.45>, 0.06 }
  sphere { <0.42, 1.48, -1.47>, 0.16 }
};

union {
  // The shell: flat below, wider in front.
  blob {
    threshold 0.5
    sphere { <0, 0, 0>, 2.2, 1 scale <1.15, 0.48, 0.95> translate <0, 0.9, -0.1> }
    sphere { <0, 0, 0>, 1.0, 0.6 scale <1, 0.5, 1> translate <0.8, 1.25, -0.5> }
    sphere { <0, 0, 0>, 1.0, 0.6 scale <1, 0.5, 1> translate <-0.8, 1.25, -0.5> }
    sphere { <0, 0, 0>, 0.9, 0.5 scale <1, 0.5, 1> translate <0, 1.3, 0.6> }
  }
  object { Side }
  object { Side scale <-1, 1, 1> }
  rotate y * -24
  pigment { color rgb <0.98, 0.58, 0.40> }
  finish {
    ambient 0.01 diffuse 0.1
    specular 0.7 roughness 0.004 metallic
    reflection { 0.8 metallic }
  }
  photons { target reflection on collect off }
}

// The lid lies on its back.
difference {
  cylinder { <0, 0.02, 0>, <0, 1.15, 0>, 4.78 }
  cylinder { <0, -1, 0>, <0, 2, 0>, 4.70 }
  torus { 4.74, 0.09 translate y * 0.5 }
  translate <0, 0, -0.4>
  pigment { color rgb <0.95, 0.86, 0.66> }
  finish {
    ambient 0.01 diffuse 0.1
    specular 0.6 roughness 0.006 metallic
    reflection { 0.82 metallic }
  }
  photons { target reflection on collect off }
}

plane {
  y, 0
  pigment { color rgb <0.76, 0.68, 0.55> }
  finish { ambient 0.04 diffuse 0.85 }
}
