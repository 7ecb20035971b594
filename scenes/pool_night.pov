// A pool indoors at night, lit by a strong lamp under water: the waves throw their net on walls and ceiling.
// The water is a mesh. Plain POV-Ray 3.7; one unit is a metre. Declare=Photon_Count=N for more photons.
#version 3.7;

#ifndef (Photon_Count) #declare Photon_Count = 800000; #end

global_settings {
  assumed_gamma 1.0
  max_trace_level 6
  photons { count Photon_Count autostop 0 }
}

camera {
  location <-3.2, 1.75, -6.2>
  look_at <0.7, 1.25, 1.0>
  right x * image_width / image_height
  angle 70
}

// The lamp stands on the basin's floor.
#declare Lamp = <0.4, -1.2, 0.9>;
light_source {
  Lamp
  color rgb <0.80, 0.95, 1.0> * 3.6
  fade_distance 2.0 fade_power 2
  photons { refraction on reflection on }
}
sphere {
  Lamp, 0.14
  pigment { color rgb 1 }
  finish { ambient 0 diffuse 0 emission <0.9, 1, 1> * 2 }
  no_shadow
  photons { pass_through }
}

// Moonlight through a window that is not seen.
light_source {
  <6, 9, -8>
  color rgb <0.25, 0.32, 0.5> * 0.16
  shadowless
  photons { refraction off reflection off }
}

#declare Steps = 96;
#declare Height = function(x, z) {
  0.016 * sin(5.1 * x + 2.3 * z) + 0.012 * sin(-3.6 * x + 6.7 * z + 1.3) + 0.006 * sin(9.8 * x - 7.9 * z + 2.0)
};
#declare Slope = 0.001;

#macro At(I, J)
  #local X = -3.01 + 6.02 * I / Steps;
  #local Z = -2.51 + 5.02 * J / Steps;
  <X, Height(X, Z), Z>
#end
#macro Upright(I, J)
  #local X = -3.01 + 6.02 * I / Steps;
  #local Z = -2.51 + 5.02 * J / Steps;
  vnormalize(<Height(X - Slope, Z) - Height(X + Slope, Z), 2 * Slope, Height(X, Z - Slope) - Height(X, Z + Slope)>)
#end

// From the edge of the waves down to below the floor.
#macro Down(P)
  <P.x, -1.6, P.z>
#end
#macro Side(P, Q)
  triangle { P, Q, Down(Q) }
  triangle { P, Down(Q), Down(P) }
#end

// The water: its waves, closed by sides and a bottom within the walls so that there is an inside.
mesh {
  #for (I, 0, Steps - 1)
    #for (J, 0, Steps - 1)
      smooth_triangle {
        At(I, J), Upright(I, J), At(I + 1, J), Upright(I + 1, J), At(I + 1, J + 1), Upright(I + 1, J + 1)
      }
      smooth_triangle {
        At(I, J), Upright(I, J), At(I + 1, J + 1), Upright(I + 1, J + 1), At(I, J + 1), Upright(I, J + 1)
      }
    #end
  #end
  #for (I, 0, Steps - 1)
    Side(At(I, 0), At(I + 1, 0))
    Side(At(I, Steps), At(I + 1, Steps))
    Side(At(0, I), At(0, I + 1))
    Side(At(Steps, I), At(Steps, I + 1))
  #end
  triangle { Down(At(0, 0)), Down(At(Steps, 0)), Down(At(Steps, Steps)) }
  triangle { Down(At(0, 0)), Down(At(Steps, Steps)), Down(At(0, Steps)) }
  inside_vector y
  pigment { color rgbt <0.93, 0.98, 0.99, 1> }
  finish {
    ambient 0 diffuse 0
    reflection { 0, 1 fresnel on } conserve_energy
  }
  interior { ior 1.33 fade_distance 4 fade_power 1001 fade_color rgb <0.40, 0.80, 0.85> }
  photons { target refraction on reflection on collect off }
}

// The hall, with the basin cut into its floor.
difference {
  box { <-6, -2, -8>, <6, 5, 6> }
  box { <-5, 0.15, -7>, <5, 3.4, 5> }
  box {
    <-3, -1.5, -2.5>, <3, 1, 2.5>
    pigment {
      brick color rgb <0.66, 0.70, 0.70>, color rgb <0.52, 0.80, 0.86>
      brick_size <0.3, 0.3, 0.3> mortar 0.012
      translate <0.15, 0.15, 0.15>
    }
    finish { ambient 0 diffuse 0.8 }
  }
  pigment { color rgb <0.84, 0.82, 0.78> }
  finish { ambient 0 diffuse 0.85 }
  hollow
}
