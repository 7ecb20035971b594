#version 3.7;
global_settings { assumed_gamma 1 }
// every tiling that repeats, as a pigment; some as normals and texture maps
#default { finish { ambient 1 diffuse 0 } }
camera { orthographic location <0, 9, 0> look_at 0 up z * 20 right x * 80 / 3 direction -y sky z }
light_source { <-9, 20, -5>, 1 }
#declare Map = color_map { [0 rgb <0, 0, .2>] [.3 rgb <.9, .2, .1>] [.6 rgb <.3, .8, .3>]
    [1 rgb 1] }
#macro Tile(K) box { <-1.6, -1, -2.4>, <1.6, 0, 2.4> translate <mod(K, 7) * 3.3 - 9.9, 0,
    7.5 - int(K / 7) * 5> #end
#for (K, 0, 23)
    Tile(K) pigment { tiling K + 1 color_map { Map } rotate y * K scale .9 } }
#end
Tile(24) pigment { rgb 1 } normal { tiling 12 .7 scale .6 } finish { ambient .1 diffuse .9 } }
Tile(25) texture { tiling 7 texture_map { [.5 pigment { rgb <.8, .6, .1> }] [.5 pigment { checker
    rgb 1 rgb 0 scale .2 }] } } }
Tile(26) pigment { tiling 15 frequency 2 phase .1 sine_wave turbulence .2 warp { repeat x * 2 } } }
Tile(27) pigment { pigment_pattern { tiling 9 } } }
