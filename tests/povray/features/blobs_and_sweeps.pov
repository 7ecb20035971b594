#version 3.7;
global_settings { assumed_gamma 1 }
// blobs with own textures and negative parts, sphere sweeps, patches, quartics
camera { location <0, 3, -9> look_at <0, .3, 0> angle 50 }
light_source { <6, 9, -6>, 1 } light_source { <-6, 2, -8>, .3 shadowless }
plane { y, -1.5 pigment { checker rgb .8 rgb .6 } }
blob { threshold .4
  sphere { <-3, 0, 0>, 1.4, 1 pigment { rgb <1, 0, 0> } scale <1, .8, 1> }
  sphere { <-2, .5, 0>, 1.2, 1 pigment { checker rgb 1 rgb 0 scale .2 } }
  cylinder { <-3.5, -1, 0>, <-1.6, -1, 0>, .7, .9 texture { pigment { rgb <0, 0, 1> } finish {
      phong 1 } } }
  sphere { <-2.5, 0, -.9>, .7, -1.2 pigment { rgb <1, 1, 0> } } sturm }
sphere_sweep { cubic_spline 6, <-1, -1, 1>, .2 <0, -1, 0>, .25 <.5, 0, .5>, .15 <0, 1, 0>, .3 <1,
    1.4, 0>, .1 <2, 1, 0>, .2 pigment { rgb <.3, .8, .4> } finish { specular .6 } }
sphere_sweep { linear_spline 4, <1, -1, -1>, .1 <1.5, -.5, -1>, .3 <2, -1, -1.5>, .05 <2.4, -.2,
    -1>, .2 pigment { rgb <.9, .5, .1> } }
sphere_sweep { b_spline 5, <1, 1, 1>, .2 <2, 2, 1>, .2 <3, 1, 1>, .3 <3.5, 0, 1>, .3 <3, -1, 1>,
    .1 pigment { rgb <.7, .2, .9> } }
bicubic_patch { type 1 flatness .01 u_steps 4 v_steps 4 uv_vectors <0, 0> <1, 0> <1, 1> <0, 1>
  <0, 0, 2> <1, 0, 1> <2, 0, 3> <3, 0, 2> <0, 1, 2> <1, 1, 0> <2, 1, 3> <3, 1, 2> <0, 2, 2> <1,
      2, 2> <2, 2, 1> <3, 2, 2> <0, 3, 2> <1, 3, 2> <2, 3, 3> <3, 3, 3>
  uv_mapping pigment { checker rgb <1, .8, .2> rgb <.2, .1, .6> scale .1 } translate <-1.5, -.5,
      1> }
poly { 4, <1, 0, 0, 0, 2, 0, 0, 2, 0, -1.2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, .8, 0,
    0, 0, 0, 1, 0, -1.2, 0, .2> scale .9 rotate 60 * x translate <3, -.8, -1.5> pigment { rgb
        <.2, .8, .9> } finish { phong .5 } }
