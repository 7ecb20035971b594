#version unofficial cognac 1.0;
global_settings {
  photons {
    count 1000
    estimator { nearest { diffusivity 3 } }
    estimator { nearest { kernel isotropic } }
    estimator { nearest { count 20000 } }
    estimator { diffusion { count 50 kernel cone } }
    estimator { footprint { count 50 } }
    estimator { deep { network "dpm-500" } }
    estimator { adaptive }
    estimator { nearest { count 5 } diffusion }
    estimator { }
  }
}
global_settings { photons { estimator nearest } }
global_settings { photons { progressive passes 3 } }
sphere { 0, 1 photons { estimator off } }
