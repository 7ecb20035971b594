#version unofficial cognac 1.0;
global_settings { photons { count 1000 emitter_coordinates off relaxation { constrained } estimator { footprint } } }
