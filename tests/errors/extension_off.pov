#declare kernel = 1;
sphere { 0, kernel }
#version unofficial cognac 1.0;
#declare radius_ = kernel;
#declare gaussian = 1;
