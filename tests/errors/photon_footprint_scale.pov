#version unofficial cognac 1.0;
global_settings { photons { count 1000 estimator { footprint { scale 0 } } } }
