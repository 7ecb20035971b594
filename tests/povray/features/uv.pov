#version 3.7;
global_settings { assumed_gamma 1 }
// uv_mapping of everything
camera { location <0, 4, -10> look_at <0, 0, 0> angle 46 }
light_source { <6, 8, -7>, 1 } light_source { <-6, 2, -7>, .3 shadowless }
#declare P = pigment { uv_mapping image_map { png "map.png" interpolate 2 } }
#declare Q = texture { uv_mapping pigment { checker rgb 1 rgb <.2, .4, .7> scale .1 } }
sphere { <-3.5, 1.5, 0>, .9 pigment { P } } box { <-2.3, .8, -.7>, <-.9, 2.2, .7> rotate 20 * y
    pigment { P } }
cylinder { <.8, .8, 0>, <.8, 2.2, 0>, .7 texture { Q } } cone { <3, .8, 0>, .9, <3, 2.2, 0>, .3
    texture { Q } }
torus { .7, .3 rotate 50 * x translate <-3.5, -1, 0> pigment { P } }
lathe { cubic_spline 5, <0, -1>, <.6, -.8>, <.3, 0>, <.7, .7>, <.4, 1> translate <-1.5, -1, 0>
    texture { Q } }
sor { 5, <.1, -.2>, <.6, 0>, <.3, .7>, <.6, 1.4>, <.2, 1.9> translate <.6, -1.8, 0> texture { Q }
    }
mesh { triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> uv_vectors <0, 0>, <1, 0>, <0, 1> } triangle {
    <1, 0, 0>, <1, 1, .5>, <0, 1, 0> uv_vectors <1, 0>, <1, 1>, <0, 1> } scale 1.6 translate
        <1.8, -1.8, -.5> pigment { P } }
mesh2 { vertex_vectors { 4, <0, 0, 0>, <1, 0, 0>, <1, 1, 0>, <0, 1, .6> } normal_vectors { 4, <0,
    0, -1>, <.3, 0, -1>, <.3, .3, -1>, <-.3, .3, -1> } uv_vectors { 4, <0, 0>, <2, 0>, <2, 2>,
        <0, 2> } face_indices { 2, <0, 1, 2>, <0, 2, 3> } scale 1.5 translate <3.6, -1.8, 0>
        texture { Q } }
superellipsoid { <.4, .4> scale .6 translate <3.9, 1.4, -1> texture { Q } }
disc { <0, -2.2, -2>, y, 1.5, .5 texture { Q } }
