#version 3.7;
light_source { 4 * y, 1 area_light x, z, 100000, 100000 }
light_source { 4 * y, 1 area_light x, z, 17, 17 }
light_source { 4 * y, 1 area_light x, z, 0, 3 }
light_source { 4 * y, 1 area_light x, z, -5, 3 }
light_source { 4 * y, 1 area_light x, z, -5, -5 }
