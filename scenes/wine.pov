// A glass of red wine on a white cloth.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 400000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 14
  photons { count Photon_Count autostop 0 }
}

camera {
  location <5, 19, -38>
  look_at <4.2, 6.2, -1>
  right x * image_width / image_height
  angle 36
}

// A room at dusk, for the glass to mirror.
sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.00 color rgb <0.09, 0.07, 0.07>] [0.30 color rgb <0.16, 0.13, 0.12>] [0.55 color rgb <0.42, 0.38, 0.36>]
      [0.75 color rgb <0.20, 0.21, 0.25>] [1.00 color rgb <0.06, 0.07, 0.10>]
    }
  }
}

light_source {
  <-34, 40, 18>
  color rgb <1.0, 0.92, 0.78> * 1.15
  photons { refraction on reflection on }
}

light_source {
  <30, 40, -50>
  color rgb <0.6, 0.7, 0.9> * 0.14
  shadowless
  photons { refraction off reflection off }
}

#declare Bowl = lathe {
  cubic_spline
  22,
  <-1.0, 0.02>, <0.00, 0.02>, <2.00, 0.02>, <3.35, 0.00>, <3.48, 0.10>, <3.30, 0.20>, <1.60, 0.36>, <0.50, 0.90>,
  <0.36, 2.50>, <0.36, 5.60>, <0.62, 6.60>, <2.20, 7.60>, <3.60, 9.60>, <3.75, 11.60>, <3.20, 14.60>, <3.10, 14.72>,
  <3.02, 14.60>, <3.58, 11.58>, <3.42, 9.70>, <2.06, 7.82>, <0.00, 6.95>, <-2.06, 7.82>
};

// The wine fills the bowl's inside, grown by a trifle so that no gap is left.
#declare Wine = intersection {
  lathe {
    cubic_spline
    8,
    <-2.065, 7.81>, <0.00, 6.94>, <2.065, 7.81>, <3.425, 9.695>, <3.585, 11.58>, <3.20, 12.60>, <0.00, 13.00>,
    <-3.20, 12.60>
  }
  plane { y, 10.6 }
};

object {
  Bowl
  pigment { color rgbt <0.98, 0.99, 0.99, 0.98> }
  finish {
    ambient 0 diffuse 0
    specular 0.8 roughness 0.0008
    reflection { 0, 1 fresnel on } conserve_energy
  }
  interior { ior 1.5 }
  photons { target reflection on refraction on collect off }
}

object {
  Wine
  pigment { color rgbf <0.92, 0.22, 0.24, 0.98> }
  finish {
    ambient 0 diffuse 0
    reflection { 0, 1 fresnel on } conserve_energy
  }
  interior { ior 1.34 fade_distance 8 fade_power 1001 fade_color rgb <0.97, 0.30, 0.35> }
  photons { target reflection off refraction on collect off }
}

plane {
  y, 0
  pigment { color rgb <0.90, 0.89, 0.87> }
  finish { ambient 0.06 diffuse 0.85 }
}
