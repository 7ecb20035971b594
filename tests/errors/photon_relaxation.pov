#version unofficial cognac 1.0;
global_settings {
  photons {
    count 1000
    relaxation { constrained iterations -1 }
    relaxation { plain iterations 3, 5000 range 0 }
    relaxation { neighbors 2 repulsion_neighbors 300 strength 4 }
    relaxation { iterations neighbors 50 }
    relaxation { gradient plain off }
    relaxation { gradient 2, 3 }
    relaxation { hues plain off }
  }
}
sphere { 0, 1 photons { relaxation { plain } } }
