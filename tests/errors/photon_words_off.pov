// Without the extension its words are names like any other.
#version 3.7;
#declare estimator = 3; #declare progressive = 2; #declare passes = 1; #declare nearest = 5;
global_settings { photons { count 1000 } }
sphere { 0, estimator + passes photons { target 1 estimator { nearest } } }
