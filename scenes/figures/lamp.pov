// The halogen lamp's chair from above: the patches of light that the facets of the reflector throw
// over one another.
#include "../halogen.pov"
camera {
  location <-13, 15, -20>
  look_at <-1.9, 0, -2.6>
  right x * image_width / image_height
  angle 40
}
