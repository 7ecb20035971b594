#version 3.7;
global_settings { photons { count 100 gather 20, 20000 } }
sphere { 0, 1 }
