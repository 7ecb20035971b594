// Rings and coins from above, where their caustics lie over one another.
#include "../rings.pov"
camera {
  location <0.8, 12, -7>
  look_at <-0.2, 0, 0.1>
  right x * image_width / image_height
  angle 28
}
