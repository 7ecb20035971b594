// A dragon of green glass, coiled on marble. Its mesh is made by dragon.py: python3 dragon.py > dragon.inc
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 400000; #end

#if (file_exists("dragon.inc"))
  #include "dragon.inc"
#else
  #error "dragon.inc is missing; make it by: python3 dragon.py > dragon.inc (make pictures/dragon.png does)\n"
#end

global_settings {
  assumed_gamma 1.0
  max_trace_level 10
  photons { count Photon_Count autostop 0 }
}

camera {
  location <1.5, 8.5, -14>
  look_at <0.7, 1.6, 0>
  right x * image_width / image_height
  angle 35
}

sky_sphere {
  pigment {
    gradient y
    color_map { [0 color rgb <0.08, 0.08, 0.10>] [0.5 color rgb <0.30, 0.36, 0.46>] [1 color rgb <0.6, 0.62, 0.66>] }
  }
}

light_source {
  <-18, 26, 20>
  color rgb <1.0, 0.95, 0.86> * 1.0
  photons { refraction on reflection on }
}

object {
  Dragon
  pigment { color rgbt <0.96, 0.99, 0.97, 0.97> }
  finish {
    ambient 0 diffuse 0
    specular 0.5 roughness 0.002
    reflection { 0, 1 fresnel on } conserve_energy
  }
  interior { ior 1.5 fade_distance 0.8 fade_power 1001 fade_color rgb <0.35, 0.85, 0.55> }
  photons { target reflection on refraction on collect off }
}

plane {
  y, 0
  pigment {
    marble turbulence 0.9 lambda 2.2
    color_map { [0 color rgb <0.86, 0.85, 0.83>] [0.8 color rgb <0.78, 0.77, 0.75>] [1 color rgb <0.55, 0.54, 0.54>] }
    scale 3
  }
  finish { ambient 0.05 diffuse 0.85 }
}
