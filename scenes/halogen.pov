// A halogen lamp over a chair: each facet of its reflector throws a patch of light of its own.
// Plain POV-Ray 3.7; one unit is ten centimetres. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 250000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 6
  photons { count Photon_Count autostop 0 gather 10, 40 }
}

camera {
  location <-12, 12, -24>
  look_at <0.4, 6.6, 0>
  right x * image_width / image_height
  angle 48
}

background { color rgb 0.01 }

#declare Lamp = <1.5, 15, -1.5>;
#declare Focus = 0.55;  // of the paraboloid that the facets follow
#declare Rings = 5;
#declare Facets = 14;
#declare Depth = 1.3;   // of the reflector

// The point of the reflector on ring I at corner J; it opens downwards and its apex is the origin.
#macro Corner(I, J)
  #local Q = 0.25 + (2 * sqrt(Focus * Depth) - 0.25) * I / Rings;
  #local A = 2 * pi * J / Facets;
  <Q * cos(A), -Q * Q / (4 * Focus), Q * sin(A)>
#end

#declare Reflector = mesh {
  #for (I, 0, Rings - 1)
    #for (J, 0, Facets - 1)
      #local K = J + mod(I, 2) / 2;
      triangle { Corner(I, K), Corner(I + 1, K), Corner(I + 1, K + 1) }
      triangle { Corner(I, K), Corner(I + 1, K + 1), Corner(I, K + 1) }
    #end
  #end
};

union {
  object {
    Reflector
    pigment { color rgb 0.95 }
    finish { ambient 0 diffuse 0.05 reflection 0.9 }
    photons { target reflection on collect off }
  }
  object {
    Reflector
    scale 1.04
    pigment { color rgb 0.2 }
    finish { ambient 0 diffuse 0.6 specular 0.3 }
  }
  rotate <0, 0, -6>
  translate Lamp
}
cylinder {
  Lamp + y * 0.1, Lamp + y * 12, 0.06
  pigment { color rgb 0.1 }
}

// The filament stands a little below the focus, so that the patches spread.
light_source {
  Lamp - y * (Focus + 0.62)
  color rgb <1.0, 0.9, 0.75> * 0.13
  photons { reflection on }
}

// The chair.
#declare Leg = cylinder { 0, y * 4.4, 0.22 };
union {
  box { <-2.2, 4.3, -2.2>, <2.2, 4.7, 2.2> }
  object { Leg translate <-1.9, 0, -1.9> }
  object { Leg translate <1.9, 0, -1.9> }
  cylinder { <-1.9, 0, 1.9>, <-1.9, 9.4, 2.5>, 0.22 }
  cylinder { <1.9, 0, 1.9>, <1.9, 9.4, 2.5>, 0.22 }
  #for (I, 0, 3)
    box { <-1.9, 5.9 + I * 0.95, -0.1>, <1.9, 6.4 + I * 0.95, 0.1> translate z * (2.32 + I * 0.06) }
  #end
  cylinder { <-1.9, 1.6, -1.9>, <1.9, 1.6, -1.9>, 0.14 }
  cylinder { <-1.9, 1.9, -1.9>, <-1.9, 1.9, 1.98>, 0.14 }
  cylinder { <1.9, 1.9, -1.9>, <1.9, 1.9, 1.98>, 0.14 }
  rotate y * -28
  pigment { color rgb <0.62, 0.36, 0.18> }
  finish { ambient 0 diffuse 0.8 specular 0.15 roughness 0.03 }
}

plane {
  y, 0
  pigment { checker color rgb <0.82, 0.79, 0.74>, color rgb <0.72, 0.69, 0.65> scale 4 }
  finish { ambient 0.02 diffuse 0.9 }
}
plane {
  -z, -9
  pigment { color rgb <0.80, 0.80, 0.78> }
  finish { ambient 0.02 diffuse 0.9 }
}
