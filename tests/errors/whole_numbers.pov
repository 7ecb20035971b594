#version 3.7;
global_settings { max_trace_level 3e9 photons { count 2e15 gather 20, 1e10 } }
camera { aperture 0.1 blur_samples 5, 1e300 }
light_source { 4 * y, 1 area_light x, z, 3e9, -3e9 }
bicubic_patch { type 1 u_steps 4294967296 }
height_field { function 5e9, 4 { x } }
height_field { function 4, 16385 { x } }
sphere { 0, 1 pigment { image_map { function 3, 1e5 { x } } } }
isosurface { function { y } max_trace 1e10 }
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 1e10> } }
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> 4e9 } }
mesh2 { vertex_vectors { 5e9, 0, x, y } face_indices { 1, <0, 1, 2> } }
prism { 0, 1, 3e9, <0, 0>, <1, 1>, <1, 0> }
