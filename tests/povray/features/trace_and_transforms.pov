#version 3.7;
global_settings { assumed_gamma 1 }
// cameras and patterns by clock, transforms with inverse and matrix, trace(), inside(), eval of
// bounding
#include "transforms.inc"
#include "rand.inc"
camera { panoramic location <0, 2, -6> look_at <0, .5, 0> angle 120 }
light_source { <4, 8, -6>, 1 }
#declare G = union { sphere { 0, 1 } box { <-.4, .6, -.4>, <.4, 1.6, .4> } cylinder { -2 * x, 2 *
    x, .3 } }
object { G pigment { rgb <.7, .6, .5> } }
#declare R = seed(42); #declare N = <0, 0, 0>;
#for (I, 1, 60) #local D = VRand_On_Sphere(R) * 4; #local H = trace(G, D, -D, N);
 #if (vlength(N) > 0) cone { H, .08, H + N * .4, 0 pigment { rgb <I / 60, 1 - I / 60, .2> } } #end
 #if (inside(G, D / 3)) sphere { D / 3, .1 pigment { rgb <0, 0, 1> } } #end #end
#declare TT = transform { scale <1, 2, .5> rotate 30 * z translate <1, 0, 2> }
box { -.5, .5 transform { TT } matrix <1, .2, 0, 0, 1, .1, .3, 0, 1, 2, 0, 0> pigment { rgb <.9,
    .3, .3> } }
box { -.5, .5 transform { TT inverse } translate <-3, 1, 1> pigment { rgb <.3, .9, .3> } }
object { cylinder { -y, y, .3 } Reorient_Trans(y, <1, 1, 0>) translate <-3, 2, 3> pigment { rgb
    <.9, .9, .2> } }
plane { y, -1 pigment { leopard scale .3 } rotate 5 * z }
