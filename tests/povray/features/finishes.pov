#version 3.7;
global_settings { assumed_gamma 1 }
// finishes: irid, metallic with exponents, brilliance, conserve_energy, crand off, fresnel,
// blurred highlights
camera { location <0, 3, -9> look_at <0, .2, 0> angle 46 }
light_source { <5, 8, -7>, 1 } light_source { <-6, 4, -5>, rgb <.4, .5, .6> }
sky_sphere { pigment { gradient y color_map { [0 rgb <.8, .8, 1>] [1 rgb <.1, .2, .6>] } }
    pigment { bozo color_map { [0 rgbt 1] [.6 rgbt 1] [1 rgbt <1, 1, 1, .1>] } scale .2 } }
plane { y, -1 pigment { checker rgb .9 rgb .3 } finish { reflection { .05, .4 falloff 3 } } }
#macro B(X, Z, F) sphere { <X, 0, Z>, .9 pigment { rgb <.9, .7, .3> } finish { F } } #end
B(-3, 0, finish { irid { .4 thickness .6 turbulence .3 } ambient .1 })
B(-1, 0, finish { reflection { .1, .9 falloff 2 exponent .7 metallic } metallic specular .8
    roughness .02 })
B(1, 0, finish { diffuse .6 brilliance 3 phong .9 phong_size 60 metallic .5 })
B(3, 0, finish { reflection { rgb <.8, .2, .2>, rgb <.2, .2, .9> } conserve_energy diffuse .5 })
sphere { <-2, .3, -2.3>, .6 pigment { rgbf <.9, 1, .95, .9> } finish { reflection { 0, 1 fresnel
    } conserve_energy specular .6 } interior { ior 1.5 fade_distance .5 fade_power 2 fade_color
        rgb <.2, .8, .5> } }
sphere { <0, .3, -2.3>, .6 pigment { rgbf <1, .9, .8, .7> } finish { diffuse .3 specular .3
    roughness .1 } interior { ior 1.3 fade_distance 1 fade_power 1001 fade_color rgb <.8, .3, .1>
        caustics .5 } }
sphere { <2, .3, -2.3>, .6 pigment { rgbt <.4, .9, 1, .6> } finish { specular albedo .4 diffuse
    albedo .5 emission rgb <0, .1, 0> } interior { ior 1.1 } }
