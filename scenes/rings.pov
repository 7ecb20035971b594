// Rings and coins in low light on a desk: chains of reflections, and caustics that cross one another.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 500000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 8
  photons { count Photon_Count autostop 0 }
}

camera {
  location <1, 10.5, -11>
  look_at <0.3, 0, -0.1>
  right x * image_width / image_height
  angle 37
}

// A dim room, for the metal to mirror.
sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.00 color rgb <0.04, 0.04, 0.05>] [0.35 color rgb <0.10, 0.10, 0.12>] [0.62 color rgb <0.55, 0.52, 0.48>]
      [0.80 color rgb <0.30, 0.32, 0.36>] [1.00 color rgb <0.08, 0.09, 0.12>]
    }
  }
}

light_source {
  <-22, 13, 13>
  color rgb <1.0, 0.86, 0.66> * 1.15
  photons { reflection on }
}

light_source {
  <20, 30, -20>
  color rgb <0.5, 0.6, 0.8> * 0.10
  shadowless
  photons { reflection off refraction off }
}

#macro Metal(Tint)
  pigment { color rgb Tint }
  finish {
    ambient 0.02 diffuse 0.12
    specular 0.6 roughness 0.008 metallic
    reflection { 0.82 metallic }
  }
#end

// A band with rounded edges, as a ring for a finger.
#macro Ring(Where, Radius, Width, Tint)
  difference {
    cylinder { y * 0, y * Width, Radius + 0.13 }
    cylinder { y * -1, y * (Width + 1), Radius }
    translate Where
    Metal(Tint)
    photons { target reflection on collect off }
  }
#end

// A coin: a disc with a raised rim and a milled edge.
#macro Coin(Where, Radius, Tint)
  union {
    cylinder { y * 0, y * 0.16, Radius * 0.93 }
    difference {
      cylinder { y * 0, y * 0.20, Radius }
      cylinder { y * 0.1, y * 1, Radius * 0.91 }
    }
    torus { Radius * 0.5, 0.06 translate y * 0.15 }
    sphere { 0, 0.22 * Radius scale <1, 0.25, 1> translate y * 0.16 }
    translate Where
    Metal(Tint)
    photons { target reflection on collect off }
  }
#end

#declare Gold = <1.00, 0.76, 0.34>;
#declare Silver = <0.93, 0.93, 0.95>;
#declare Copper = <0.95, 0.58, 0.42>;

Ring(<-1.9, 0, 0.9>, 1.35, 0.85, Gold)
Ring(<1.1, 0, -0.6>, 1.05, 0.60, Silver)
Ring(<2.5, 0, 1.7>, 0.95, 0.75, Gold)

Coin(<-1.4, 0, -2.0>, 1.1, Copper)
Coin(<-3.6, 0, -0.9>, 1.2, Silver)
Coin(<-3.3, 0.2, -1.1>, 1.0, Copper)
Coin(<3.6, 0, -0.9>, 1.15, Gold)
Coin(<0.7, 0, 2.2>, 0.95, Silver)

plane {
  y, 0
  pigment { color rgb <0.72, 0.66, 0.60> }
  finish { ambient 0.05 diffuse 0.85 }
}
