// A halogen lamp over a chair: each facet of its reflector throws a patch of light of its own.
// All of its light has passed the lamp's pane of glass, so all of it is caustic.
// Plain POV-Ray 3.7; one unit is ten centimetres. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 800000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 8
  photons { count Photon_Count autostop 0 gather 20, 80 }
}

camera {
  location <-14, 12.5, -26>
  look_at <-0.6, 6.8, 0>
  right x * image_width / image_height
  angle 46
}

background { color rgb 0.01 }

#declare Lamp = <1.2, 16, -1.5>; // the reflector's apex
#declare Focus = 0.9;
#declare Rings = 3;
#declare Facets = 9;
#declare Depth = 1.3;
#declare Rim = 2 * sqrt(Focus * Depth);

// The point of the reflector on ring I at corner J; it opens downwards and its apex is the origin.
#macro Corner(I, J)
  #local Q = 0.25 + (Rim - 0.25) * I / Rings;
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

// A shade of metal around the reflector, and the pane that closes it.
#declare Shade = difference {
  cylinder { <0, -Depth - 0.35, 0>, <0, 0.25, 0>, Rim + 0.25 }
  cylinder { <0, -Depth - 0.45, 0>, <0, 0.12, 0>, Rim + 0.12 }
};
#declare Pane = cylinder { <0, -Depth - 0.26, 0>, <0, -Depth - 0.14, 0>, Rim + 0.1 };

union {
  object {
    Reflector
    pigment { color rgb 0.95 }
    finish { ambient 0 diffuse 0.03 reflection 0.92 }
    photons { target reflection on collect off }
  }
  object {
    Shade
    pigment { color rgb <0.10, 0.11, 0.12> }
    finish { ambient 0.02 diffuse 0.5 specular 0.5 roughness 0.02 }
  }
  object {
    Pane
    pigment { color rgbt <1, 1, 1, 1> }
    finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior 1.5 }
    photons { target refraction on reflection on collect off }
  }
  rotate <4, 0, -8>
  translate Lamp
}
cylinder {
  Lamp + y * 0.1, Lamp + y * 12, 0.06
  pigment { color rgb 0.1 }
}

// The filament stands a little below the focus, so that the patches spread.
light_source {
  Lamp - y * (Focus + 0.35)
  color rgb <1.0, 0.88, 0.70> * 0.07
  photons { reflection on refraction on }
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
