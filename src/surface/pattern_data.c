/* Patterns that look elsewhere: functions, images, volumes, pigments, shapes, and the surface's own
 * slope. */
#include "surface/pattern_data.h"

#include <math.h>

#include "surface/cubic.h"
#include "surface/image_map.h"
#include "surface/pattern_classes.h"

static double value_function(const Pattern *pattern, const SurfacePoint *at)
{
	const FunctionData *data = pattern->data;
	const double args[3] = {at->p.x, at->p.y, at->p.z};
	double v = function_eval(data->function, args);
	return v > 1 ? fmod(v, 1) : v;
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

/* The range given mapped to 0 to 1; a range without width stays as it is. */
static double ranged(double v, double lo, double hi) { return hi == lo ? v : (v - lo) / (hi - lo); }

/* Share of half a turn between the normal and the plane square to a direction: 0 away from it, 1
 * towards it. */
static double facing(Vec3 normal, Vec3 direction)
{
	return asin(fmax(-1, fmin(1, vec3_dot(normal, vec3_normalize(direction))))) / M_PI + 0.5;
}

/* Slope and altitude are averaged with their vectors' lengths as weights. */
static double value_slope(const Pattern *pattern, const SurfacePoint *at)
{
	const SlopeData *slope = pattern->data;
	Vec3 direction = slope->point_at ? vec3_sub(slope->direction, at->world) : slope->direction;
	double v = ranged(facing(at->normal, direction), slope->lo_slope, slope->hi_slope);
	double along = vec3_length(slope->altitude), down = vec3_length(direction);
	if (along == 0)
		return v;
	double altitude = ranged(vec3_dot(at->p, slope->altitude) / along, slope->lo_alt,
	                         slope->hi_alt);
	return (down * v + along * altitude) / (down + along);
}

static double value_aoi(const Pattern *pattern, const SurfacePoint *at)
{
	(void)pattern;
	return facing(at->normal, vec3_neg(at->direction));
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
	size_t x = big_endian(bytes, 2), y = big_endian(bytes + 2, 2), z = big_endian(bytes + 4, 2),
		   count = x * y * z;
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

/* -1 is taken as 2^32 - 1, as POV-Ray does: the last voxel only where count is a power of two. */
static uint32_t wrapped(int i, int count) { return (uint32_t)i % (uint32_t)count; }

static double voxel_at(const DensityData *d, int x, int y, int z)
{
	size_t row = wrapped(z, d->size_z) * (size_t)d->size_y + wrapped(y, d->size_y);
	return d->voxels[row * (size_t)d->size_x + wrapped(x, d->size_x)];
}

/* The weights of four neighbours, the first of them one below: linear, or Catmull and Rom's cubic.
 */
static void neighbour_weights(int interpolate, double t, double w[4])
{
	if (interpolate != 1) {
		cubic_weights(t, w);
		return;
	}
	w[0] = w[3] = 0;
	w[1] = 1 - t;
	w[2] = t;
}

static double value_density(const Pattern *pattern, const SurfacePoint *at)
{
	const DensityData *d = pattern->data;
	Vec3 p = at->p;
	if (!(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1 && p.z >= 0 && p.z < 1))
		return 0;
	int x = (int)(p.x * d->size_x), y = (int)(p.y * d->size_y), z = (int)(p.z * d->size_z);
	if (d->interpolate == 0)
		return voxel_at(d, x, y, z);
	double wx[4], wy[4], wz[4], sum = 0;
	neighbour_weights(d->interpolate, p.x * d->size_x - x, wx);
	neighbour_weights(d->interpolate, p.y * d->size_y - y, wy);
	neighbour_weights(d->interpolate, p.z * d->size_z - z, wz);
	for (int n = 0; n < 64; n++) {
		int i = n & 3, j = n >> 2 & 3, k = n >> 4;
		double weight = wx[i] * wy[j] * wz[k];
		if (weight != 0)
			sum += weight * voxel_at(d, x + i - 1, y + j - 1, z + k - 1);
	}
	return sum;
}

const PatternClass pattern_function = {"function", value_function, 0, NULL, PATTERN_NEEDS_DATA};
const PatternClass pattern_image = {"image_pattern", value_image, 0, NULL,
                                    PATTERN_STILL | PATTERN_NEEDS_DATA};
const PatternClass pattern_density_file = {"density_file", value_density, 0, NULL,
                                           PATTERN_STILL | PATTERN_NEEDS_DATA};
const PatternClass pattern_pigment = {"pigment_pattern", value_pigment, 0, NULL,
                                      PATTERN_NEEDS_DATA};
const PatternClass pattern_slope = {"slope", value_slope, 0, NULL, PATTERN_NEEDS_DATA};
const PatternClass pattern_aoi = {"aoi", value_aoi, 0, NULL, 0};
const PatternClass pattern_potential = {"potential", value_potential, 0, NULL, PATTERN_NEEDS_DATA};
