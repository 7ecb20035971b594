// A glass of cognac on a table, and the light it gathers: the classic scene for caustics.
// Plain POV-Ray 3.7; one unit is a centimetre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 400000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 12
  photons { count Photon_Count autostop 0 jitter 0.4 }
}

camera {
  location <2.5, 14, -33>
  look_at <3.0, 4.1, -1>
  right x * image_width / image_height
  angle 36
}

background { color rgb <0.012, 0.010, 0.009> }

// The evening sun through a window behind, to the left: strong, small, low.
light_source {
  <-42, 46, 38>
  color rgb <1.00, 0.90, 0.74> * 2.4
  spotlight point_at <1, 2, 0> radius 14 falloff 26
  photons { refraction on reflection on }
}

// The room's own light, from the front, too soft to throw shadows.
light_source {
  <38, 42, -60>
  color rgb <0.55, 0.63, 0.80> * 0.6
  shadowless
  photons { refraction off reflection off }
}

// A wide pane that only the glass and the varnish see.
box {
  <-1, -1, 0>, <1, 1, 0.1>
  pigment { color rgb 1 }
  finish { ambient 0 diffuse 0 emission rgb <0.95, 0.97, 1.0> * 0.9 }
  scale <9, 15, 1>
  rotate y * 35
  translate <-44, 24, -16>
  no_shadow
  no_image
  photons { pass_through }
}

#declare Clear_Glass = material {
  texture {
    pigment { color rgbt <0.985, 0.995, 0.990, 0.97> }
    finish {
      ambient 0 diffuse 0 conserve_energy
      specular 0.8 roughness 0.0006
      reflection { 0.0, 1.0 fresnel on }
    }
  }
  interior { ior 1.5 }
};

#declare Spirit = material {
  texture {
    pigment { color rgbf <0.93, 0.46, 0.09, 0.95> }
    finish {
      ambient 0 diffuse 0 conserve_energy
      specular 0.35 roughness 0.002
      reflection { 0.0, 1.0 fresnel on }
    }
  }
  interior { ior 1.36 fade_distance 7 fade_power 1001 fade_color rgb <0.85, 0.33, 0.03> }
};

// The glass, from its foot's centre up the outside, over the rim, down the inside to the axis.
#declare Snifter = lathe {
  cubic_spline
  30,
  <-0.8, 0.02>, <0.00, 0.02>, <1.50, 0.04>, <2.90, 0.00>, <3.18, 0.04>, <3.22, 0.14>, <3.05, 0.23>,
  <2.10, 0.33>, <1.10, 0.56>, <0.58, 1.00>, <0.44, 1.70>, <0.46, 2.40>, <0.80, 2.95>, <1.70, 3.42>,
  <2.90, 4.20>, <3.75, 5.35>, <4.08, 6.70>, <3.93, 8.20>, <3.48, 9.70>, <3.02, 11.02>, <2.95, 11.10>,
  <2.88, 11.02>, <3.33, 9.68>, <3.78, 8.18>, <3.93, 6.70>, <3.60, 5.42>, <2.78, 4.34>, <1.60, 3.60>,
  <0.00, 3.26>, <-1.60, 3.60>
};

// What is in it: the inside, grown by a trifle so that glass and liquid touch without a gap, up to its level. The glass
// has just been shaken: rings run over the liquid and a second wave crosses them.
#declare Waves = function(x, z) {
  6.05 + 0.075 * cos(5.0 * sqrt(pow(x - 0.7, 2) + pow(z + 0.3, 2) + 0.01)) + 0.05 * sin(2.3 * x - 1.6 * z) + 0.04 * x
};

#declare Filling = intersection {
  lathe {
    cubic_spline
    10,
    <-1.60, 3.59>, <0.00, 3.25>, <1.605, 3.59>, <2.785, 4.33>, <3.605, 5.41>, <3.935, 6.70>, <3.785, 8.18>,
    <2.60, 8.90>, <0.00, 9.00>, <-2.60, 8.90>
  }
  isosurface {
    function { y - Waves(x, z) }
    contained_by { box { <-4.4, 2.9, -4.4>, <4.4, 6.5, 4.4> } }
    max_gradient 1.2
    accuracy 0.002
  }
};

union {
  object {
    Snifter
    material { Clear_Glass }
    photons { target reflection on refraction on collect off }
  }
  object {
    Filling
    material { Spirit }
    photons { target reflection off refraction on collect off }
  }
  rotate y * 20
}

// The table: dark varnished boards.
#declare Board_Wood = pigment {
  wood
  turbulence 0.045
  octaves 4
  scale <0.11, 0.11, 1>
  rotate <2, 87, 0>
  scale 14
  color_map {
    [0.00 color rgb <0.235, 0.105, 0.045>]
    [0.45 color rgb <0.300, 0.140, 0.062>]
    [0.80 color rgb <0.170, 0.072, 0.030>]
    [1.00 color rgb <0.235, 0.105, 0.045>]
  }
};

#macro Board(Row, Shift)
  box {
    <-120, -2, 0.03>, <120, 0, 11.97>
    texture {
      pigment { Board_Wood translate <Shift * 31, Shift * 1.7, Shift * 3> }
      finish {
        ambient 0.02 diffuse 0.9
        specular 0.25 roughness 0.012
        reflection { 0.01, 0.30 fresnel on } conserve_energy
      }
    }
    interior { ior 1.45 }
    translate z * (Row * 12 - 6)
  }
#end

union {
  #for (Row, -4, 12)
    Board(Row, mod(Row * 7 + 40, 5) + Row * 0.31)
  #end
  rotate y * -8
}

// A wall far behind, lost in the dark but for a warm breath.
plane {
  z, 150
  hollow
  pigment {
    spherical
    scale 150
    translate <-35, 25, 150>
    color_map {
      [0.0 color rgb <0.016, 0.012, 0.011>]
      [0.6 color rgb <0.075, 0.047, 0.034>]
      [1.0 color rgb <0.190, 0.115, 0.070>]
    }
  }
  finish { ambient 0 diffuse 0 emission 1 }
}
