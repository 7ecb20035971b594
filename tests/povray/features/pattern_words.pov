#version 3.7;
global_settings { assumed_gamma 1 }
// words of patterns and images with fewer or odder numbers than usual
camera { orthographic location <0, 0, -10> look_at 0 right x * 8 up y * 6 }
light_source { <0, 40, -100>, 1 }
#declare Map = color_map { [0 rgb 0] [.3 rgb <1, 0, 0>] [.7 rgb <0, 1, 0>] [1 rgb 1] }
#declare Parts = array[3] { 1, 2, 3 }
#undef Parts[1]
#ifdef (Parts[1]) #error "an element that was undefined" #end
#macro Ball(K, P) sphere { <mod(K, 4) * 2 - 3, 2 - int(K / 4) * 2, 0>, .95 pigment { P }
    finish { ambient 1 diffuse 0 } } #end
#macro Tile(K, P) box { <-.95, -.95, 0>, <.95, .95, .1> pigment { P } finish { ambient 1 diffuse 0 }
    translate <mod(K, 4) * 2 - 3, 2 - int(K / 4) * 2, 0> } #end
Ball(0, pigment { slope { <1, 1, 0>, .2 } color_map { Map } scale .6 })
Ball(1, pigment { slope { <1, 1, -1>, .2, .9 altitude y, -.5, 2 } color_map { Map } })
Ball(2, pigment { slope { point_at <2, 2, -2>, .2, .8 } color_map { Map } scale .3 })
Ball(3, pigment { slope { y altitude <0, 2, 0>, 2.5 } color_map { Map } })
Tile(4, pigment { mandel 30 exterior 7, 2.5 interior 3, 2 scale .6 })
Tile(5, pigment { mandel 30 exterior 8, 2.5 interior 6, .5 scale .6 })
Tile(6, pigment { image_pattern { png "palette.png" use_index } color_map { Map } })
Tile(7, pigment { image_map { png "map.png" offset <.3, .1> interpolate 2 } scale 2 })
box { -.95, <.95, .95, 0> texture { material_map { png "palette.png" texture { pigment { rgb x } }
    texture { pigment { rgb <.2, .4, 1> } } } } translate <-3, -2, 0> }
Tile(9, pigment { image_pattern { png "map.png" use_index offset <.5, 0> } color_map { Map } })
Tile(10, pigment { julia <.353, .288>, 30 exterior 8, .5 interior 1, 1.5 scale .6 })
Ball(11, pigment { slope { point_at 0 } color_map { Map } translate <2, 1, -1> })
