#version 3.7;
global_settings { assumed_gamma 1 }
// tiles of every polygon and size, every kind of corner; as normal and texture map
#default { finish { ambient 1 diffuse 0 } }
camera { orthographic location <0, 9, 0> look_at 0 up z * 20 right x * 80 / 3 direction -y sky z }
light_source { <-9, 20, -5>, 1 }
#macro Tile(K) box { <-1.6, -1, -2.4>, <1.6, 0, 2.4> translate <mod(K, 8) * 3.3 - 11.55, 0,
    7.5 - int(K / 8) * 5> #end
#macro Pavement(Sides, Tiles, N, Style) pavement number_of_sides Sides number_of_tiles Tiles
    pattern N form mod(Style, 4) interior mod(int(Style / 4), 3) exterior mod(Style, 3) #end
#macro Field(K, Sides, Tiles, N) Tile(K) pigment { Pavement(Sides, Tiles, N, K)
    color_map { [0 rgb <0, 0, .2>] [.3 rgb <.9, .2, .1>] [.6 rgb <.3, .8, .3>] [1 rgb 1] }
    rotate y * K scale .8 } } #end
Field(0, 3, 1, 1) Field(1, 3, 2, 1) Field(2, 3, 3, 1) Field(3, 3, 4, 3)
Field(4, 3, 5, 3) Field(5, 3, 5, 4) Field(6, 3, 6, 7) Field(7, 3, 6, 12)
Field(8, 4, 1, 1) Field(9, 4, 2, 1) Field(10, 4, 3, 2) Field(11, 4, 4, 4)
Field(12, 4, 4, 5) Field(13, 4, 5, 6) Field(14, 4, 5, 8) Field(15, 4, 6, 5)
Field(16, 4, 6, 14) Field(17, 4, 6, 23) Field(18, 4, 6, 31) Field(19, 4, 6, 35)
Field(20, 6, 1, 1) Field(21, 6, 2, 1) Field(22, 6, 3, 2) Field(23, 6, 4, 3)
Field(24, 6, 5, 5) Field(25, 6, 5, 12) Field(26, 6, 5, 16) Field(27, 6, 5, 22)
Tile(28) pigment { rgb 1 } normal { pavement .7 number_of_sides 4 number_of_tiles 5
    pattern 3 form 2 scale .6 } finish { ambient .1
    diffuse .9 } }
Tile(29) texture { Pavement(6, 4, 4, 5) texture_map { [.5 pigment { rgb <.8, .6, .1> }] [.5
    pigment { checker rgb 1 rgb 0 scale .2 }] } } }
Tile(30) pigment { pavement frequency 2 phase .1 sine_wave turbulence .2 } }
Tile(31) pigment { pavement pattern 2 number_of_tiles 3 number_of_sides 4 } }
