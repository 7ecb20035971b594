#version 3.7;
global_settings { photons { count 100 relaxation { constrained } estimator { nearest { count 15 } } } }
sphere { 0, 1 photons { relaxatoin off } }
