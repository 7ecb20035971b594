#version unofficial cognac 1.0;
global_settings { photons { count 1000 progressive { passes 4 reduction ppm } } }
