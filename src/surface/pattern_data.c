/* Patterns that look elsewhere: functions, images, volumes, pigments, shapes, and the surface's own slope. */
#include "surface/pattern_data.h"

#include <math.h>

#include "surface/image_map.h"
#include "surface/pattern_classes.h"

static double value_function(const Pattern *pattern, const SurfacePoint *at)
{
	const FunctionData *data = pattern->data;
	const double args[3] = {at->p.x, at->p.y, at->p.z};
	return function_eval(data->function, args);
}

static double value_image(const Pattern *pattern, const SurfacePoint *at)
{
	const ImageData *data = pattern->data;
	return image_map_gray(data->image, at->p);
}

static double value_pigment(const Pattern *pattern, const SurfacePoint *at)
{
	const PigmentData *data = pattern->data;
	return rgb_gray(rgbft_rgb(pigment_color(data->pigment, at)));
}

static double value_potential(const Pattern *pattern, const SurfacePoint *at)
{
	const PotentialData *data = pattern->data;
	return data->value(data->shape, at->p);
}

/* 0 to 1 mapped from the range given; a range without width is a step. */
static double ranged(double v, double lo, double hi)
{
	return hi == lo ? v : (v - lo) / (hi - lo);
}

static double value_slope(const Pattern *pattern, const SurfacePoint *at)
{
	const SlopeData *slope = pattern->data;
	Vec3 direction = slope->point_at ? vec3_sub(slope->direction, at->p) : slope->direction;
	double v = asin(fmax(-1, fmin(1, vec3_dot(at->normal, vec3_normalize(direction))))) / M_PI + 0.5;
	v = ranged(v, slope->lo_slope, slope->hi_slope);
	double altitude = vec3_length(slope->altitude);
	if (altitude > 0)
		v += ranged(vec3_dot(at->p, slope->altitude), slope->lo_alt, slope->hi_alt);
	return v;
}

static double value_aoi(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	double cosine = -vec3_dot(at->normal, at->direction);
	return asin(fmax(-1, fmin(1, cosine))) / M_PI + 0.5;
}

/* ---- density_file ---- */

static uint32_t big_endian(const uint8_t *bytes, size_t count)
{
	uint32_t v = 0;
	for (size_t i = 0; i < count; i++)
		v = v << 8 | bytes[i];
	return v;
}

DensityData *density_parse(Arena *arena, const uint8_t *bytes, size_t length)
{
	if (length < 6)
		return NULL;
	size_t x = big_endian(bytes, 2), y = big_endian(bytes + 2, 2), z = big_endian(bytes + 4, 2), count = x * y * z;
	if (count == 0 || (length - 6) / count == 0)
		return NULL;
	size_t width = (length - 6) / count >= 4 ? 4 : (length - 6) / count >= 2 ? 2 : 1;
	float *voxels = ARENA_ARRAY(arena, float, count);
	double scale = 1 / (pow(256, (double)width) - 1);
	for (size_t i = 0; i < count; i++)
		voxels[i] = (float)(big_endian(bytes + 6 + i * width, width) * scale);
	DensityData *data = ARENA_NEW(arena, DensityData);
	*data = (DensityData){(int)x, (int)y, (int)z, voxels, 0};
	return data;
}

static double voxel_at(const DensityData *d, int x, int y, int z)
{
	x = x < 0 ? 0 : x >= d->size_x ? d->size_x - 1 : x;
	y = y < 0 ? 0 : y >= d->size_y ? d->size_y - 1 : y;
	z = z < 0 ? 0 : z >= d->size_z ? d->size_z - 1 : z;
	return d->voxels[((size_t)z * (size_t)d->size_y + (size_t)y) * (size_t)d->size_x + (size_t)x];
}

static double value_density(const Pattern *pattern, const SurfacePoint *at)
{
	const DensityData *d = pattern->data;
	Vec3 p = at->p;
	if (!(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1 && p.z >= 0 && p.z < 1))
		return 0;
	double x = p.x * d->size_x, y = p.y * d->size_y, z = p.z * d->size_z;
	if (d->interpolate == 0)
		return voxel_at(d, (int)x, (int)y, (int)z);
	double fx = floor(x), fy = floor(y), fz = floor(z), sum = 0;
	for (int n = 0; n < 8; n++) {
		int i = n & 1, j = n >> 1 & 1, k = n >> 2;
		double weight = fabs(1 - i - (x - fx)) * fabs(1 - j - (y - fy)) * fabs(1 - k - (z - fz));
		sum += weight * voxel_at(d, (int)fx + i, (int)fy + j, (int)fz + k);
	}
	return sum;
}

const PatternClass pattern_function = {"function", value_function, 0, NULL, PATTERN_NEEDS_DATA};
const PatternClass pattern_image = {"image_pattern", value_image, 0, NULL, PATTERN_STILL | PATTERN_NEEDS_DATA};
const PatternClass pattern_density_file = {"density_file", value_density, 0, NULL, PATTERN_STILL | PATTERN_NEEDS_DATA};
const PatternClass pattern_pigment = {"pigment_pattern", value_pigment, 0, NULL, PATTERN_STILL | PATTERN_NEEDS_DATA};
const PatternClass pattern_slope = {"slope", value_slope, 0, NULL, PATTERN_STILL | PATTERN_NEEDS_DATA};
const PatternClass pattern_aoi = {"aoi", value_aoi, 0, NULL, PATTERN_STILL};
const PatternClass pattern_potential = {"potential", value_potential, 0, NULL, PATTERN_NEEDS_DATA};
