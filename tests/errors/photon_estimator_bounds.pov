#version unofficial cognac 1.0;
global_settings { photons { count 1000 estimator { nearest { count 0 radius -0.1 } } } }
