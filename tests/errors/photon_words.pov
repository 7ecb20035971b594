#version unofficial cognac 1.0;
light_source { 0, 1 photons { share -1 } }
sphere { 0, 1 photons { target refraction on nonsense } }
