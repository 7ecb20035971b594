#version unofficial cognac 1.0;
light_source { 9 * y, 1 photons { refraction on } }
sphere { 2 * y, 1 pigment { rgbt 1 } interior { ior 1.5 } photons { target refraction on } }
plane {
  y, 0
  photons { estimator { footprint } }
}
global_settings { photons { count 1000 emitter_coordinates off } }
