#version 3.7;
mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 3> } }
prism { 0, 1, 2, <0, 0>, <1, 1> }
sor { 4, <1, 0>, <1, 2>, <1, 1>, <1, 3> }
lathe { quadratic_spline 2, <1, 0>, <1, 2> }
blob { threshold 1 }
