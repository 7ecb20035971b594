#version unofficial cognac 1.0;
global_settings { photons { count 1000 estimator { footprint { scale 0 } } } }
#declare Wide = estimator { footprint { scale 1e30 } };
#declare Widest = estimator { footprint { scale 10 } };
