// cognac.pov, its light drawn as the sheets that the photons sample: three words, and what POV-Ray blurs is sharp.
// Declare=Photon_Count=N for more photons.
#version 3.7;
#include "cognac.pov"

#version unofficial cognac 1.0;
global_settings { photons { count Photon_Count estimator { footprint } } }
