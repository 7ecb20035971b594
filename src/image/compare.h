/*
 * How far two images differ. Values are compared as given: linear light for OpenEXR, stored values
 * 0..1 for the others.
 */
#ifndef IMAGE_COMPARE_H
#define IMAGE_COMPARE_H

#include "image/image.h"

typedef struct ImageDifference {
	double mse, rmse;
	double mrse;  /* mean of (a - b)^2 / (b^2 + 1e-2), b the reference */
	double smape; /* mean of 2 |a - b| / (|a| + |b|), 0 where both are 0 */
	double psnr;  /* decibels for a peak of 1; infinite for equal images */
	double ssim;  /* of luma, Gaussian window of sigma 1.5 and 11 pixels (Wang et al. 2004) */
	double dssim; /* (1 - ssim) / 2 */
} ImageDifference;

/* Over the colour channels; both of the same size, else false and reported. image is judged against
 * reference. */
bool image_compare(const Image *image, const Image *reference, ImageDifference *out, Diag *diag);

/* New images: half the size (means of 2x2; an odd last row or column is dropped), a part, the
 * false-colour map of the largest difference of a pixel's channels (black, blue, red, yellow, white
 * for 0 to scale). */
Image *image_halve(const Image *image);
Image *image_crop(const Image *image, int x, int y, int width, int height);
Image *image_difference_map(const Image *image, const Image *reference, double scale);

#endif
