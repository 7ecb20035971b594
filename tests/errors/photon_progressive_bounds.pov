#version unofficial cognac 1.0;
global_settings { photons { count 0 progressive { passes 0 radius -1 } } }
