#version 3.7;
global_settings { assumed_gamma 1 }
// warps of every kind; cubic/triangle waves; repeat with flip, black holes, displace
camera { orthographic location <0, 0, -10> look_at 0 right x * 8 up y * 6 }
light_source { <0, 0, -100>, 1 }
#macro Tile(K, P) box { <-.95, -.95, 0>, <.95, .95, .1> pigment { P } finish { ambient .2 }
    translate <mod(K, 4) * 2 - 3, 2 - int(K / 4) * 2, 0> } #end
Tile(0, pigment { checker rgb 1 rgb <1, 0, 0> scale .3 warp { black_hole <.2, .1, 0>, .7 strength
    1.4 falloff 2 } })
Tile(1, pigment { gradient x color_map { [0 rgb 0] [1 rgb <1, 1, 0>] } scale .4 warp { repeat x
    flip y offset <0, .3, 0> } })
Tile(2, pigment { wood turbulence .1 warp { turbulence <.4, .2, .3> octaves 3 omega .6 lambda 2.4
    } scale .5 })
Tile(3, pigment { checker rgb 0 rgb <0, 1, 0> scale .2 warp { spherical orientation z dist_exp 1
    } })
Tile(4, pigment { brick rgb .3 rgb <1, .5, .3> scale .06 warp { cylindrical orientation y } })
Tile(5, pigment { hexagon rgb <1, 0, 0>, rgb <0, 1, 0>, rgb <0, 0, 1> rotate 90 * x scale .2 warp
    { toroidal orientation z major_radius .6 } })
Tile(6, pigment { checker rgb 1 rgb <.2, .2, 1> scale .25 warp { planar z, .2 } rotate 20 * y })
Tile(7, pigment { marble warp { black_hole <0, 0, 0>, 1 inverse repeat <.5, .5, 0> strength 2
    turbulence <.1, .1, 0> } frequency 3 })
Tile(8, pigment { radial frequency 8 sine_wave rotate 90 * x phase .2 })
Tile(9, pigment { onion frequency 2 ramp_wave color_map { [0 rgb 1] [.5 rgb 0] [.5 rgb <1, 0,
    1>] [1 rgb 0] } })
Tile(10, pigment { quilted control0 .5 control1 .2 scale .5 cubic_wave })
Tile(11, pigment { crackle form <-1, 1, 0> metric 3 offset .2 scale .4 poly_wave 2 })
