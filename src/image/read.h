/* Picture files in: PNG, JPEG, TIFF, GIF, TGA, PPM and PGM, BMP, Radiance and OpenEXR. */
#ifndef IMAGE_READ_H
#define IMAGE_READ_H

#include "image/image.h"

/* By content, not by name. NULL on failure, reported to diag. The values are as the file has them:
 * see image_linearize. */
Image *image_read(const char *path, Diag *diag);

#endif
