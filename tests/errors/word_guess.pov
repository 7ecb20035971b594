#version unofficial cognac 1.5;
global_settings { photons { count 100 relaxation { constraned } estimator { nearest { cuont 15 } } } }
global_settings { photons { relaxation constrained estimator footprint relaxation { } } }
Sphere { 0, 1 }
sphere { 0, 1 txture { pigmnt { rgb 1 } } photons { tragets reflectoin on } }
