/*
 * Ripples and waves: circular waves from random sources. Formulas as measured through function {
 * pattern { } }, the bumps by rendering. The sources lie on the unit sphere, in the directions of
 * the vector noise along the x axis.
 */
#include <math.h>
#include <stdint.h>

#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"
#include "surface/warp.h"

enum { WAVE_DEFAULT_COUNT = 10 };

/* Where the generator of the waves' frequencies starts. */
static const uint32_t wave_seed = 3734115329u;

static Vec3 wave_source(int i)
{
	return vec3_normalize(noise_vector(vec3(i, 0, 0), NOISE_GENERATOR_DEFAULT));
}

static double wave_frequency(uint32_t *state)
{
	*state = *state * 1812433253u + 12345u;
	return (*state >> 16 & 0x7fff) / 32767.0 + 0.01;
}

const WaveData *wave_sources_create(Arena *arena, int count)
{
	WaveData *data = ARENA_NEW(arena, WaveData);
	Vec3 *sources = ARENA_ARRAY(arena, Vec3, count);
	double *frequencies = ARENA_ARRAY(arena, double, count);
	uint32_t state = wave_seed;
	for (int i = 0; i < count; i++) {
		sources[i] = wave_source(i);
		frequencies[i] = wave_frequency(&state);
	}
	*data = (WaveData){count, sources, frequencies};
	return data;
}

/* The pattern's sources, or the ten of a scene that sets no number, made in the given space. */
typedef struct WaveSet {
	WaveData data;
	Vec3 sources[WAVE_DEFAULT_COUNT];
	double frequencies[WAVE_DEFAULT_COUNT];
} WaveSet;

static WaveData wave_set(const Pattern *pattern, WaveSet *space)
{
	if (pattern->data)
		return *(const WaveData *)pattern->data;
	uint32_t state = wave_seed;
	for (int i = 0; i < WAVE_DEFAULT_COUNT; i++) {
		space->sources[i] = wave_source(i);
		space->frequencies[i] = wave_frequency(&state);
	}
	return (WaveData){WAVE_DEFAULT_COUNT, space->sources, space->frequencies};
}

/* A source that stands at the point counts as one unit away. */
static double wave_distance(Vec3 offset)
{
	double length = vec3_length(offset);
	return length == 0 ? 1 : length;
}

static double value_ripples(const Pattern *pattern, const SurfacePoint *at)
{
	WaveSet space;
	WaveData waves = wave_set(pattern, &space);
	double sum = 0;
	for (int i = 0; i < waves.count; i++) {
		double length = wave_distance(vec3_sub(at->p, waves.sources[i]));
		sum += pattern_cycloid(length * (float)pattern->frequency + (float)pattern->phase);
	}
	return 0.5 * (1 + sum / waves.count);
}

static double value_waves(const Pattern *pattern, const SurfacePoint *at)
{
	WaveSet space;
	WaveData waves = wave_set(pattern, &space);
	double sum = 0;
	for (int i = 0; i < waves.count; i++) {
		double length = wave_distance(vec3_sub(at->p, waves.sources[i])),
		       f = waves.frequencies[i];
		sum += pattern_cycloid(length * (float)pattern->frequency * f +
				       (float)pattern->phase) /
		       f;
	}
	return 0.2 * (2.5 + sum / waves.count);
}

static void bump_ripples(const Pattern *pattern, const SurfacePoint *at, double amount,
                         Vec3 *normal)
{
	WaveSet space;
	WaveData waves = wave_set(pattern, &space);
	for (int i = 0; i < waves.count; i++) {
		Vec3 offset = vec3_sub(at->p, waves.sources[i]);
		double length = wave_distance(offset);
		double push = amount * pattern_cycloid(length * (float)pattern->frequency +
						       (float)pattern->phase);
		*normal = vec3_mad(*normal, push / length / waves.count, offset);
	}
}

static void bump_waves(const Pattern *pattern, const SurfacePoint *at, double amount, Vec3 *normal)
{
	WaveSet space;
	WaveData waves = wave_set(pattern, &space);
	for (int i = 0; i < waves.count; i++) {
		Vec3 offset = vec3_sub(at->p, waves.sources[i]);
		double length = wave_distance(offset), f = waves.frequencies[i];
		double push = amount *
		              pattern_cycloid(length * (float)pattern->frequency * f +
		                              (float)pattern->phase) /
		              f;
		*normal = vec3_mad(*normal, push / length / waves.count, offset);
	}
}

const PatternClass pattern_ripples = {"ripples", value_ripples, 0, bump_ripples, 0};
const PatternClass pattern_waves = {"waves", value_waves, 0, bump_waves, 0};
