/*
 * The iterations. Every photon's step follows from where all stood before, so the result depends
 * on no order.
 *
 * Beside SJ13 eqs. 8 and 9: neighbours are photons on the same side of the same object
 * (relax_set.c); a step is at most half the kernel's radius, which noise alone does not reach; the
 * lists of those near are twice as long as needed and kept for a few iterations, as photons hardly
 * change places; and under constraints a neighbour pushes by the light it has in common with the
 * photon, the product of their fluxes, colour by colour. What is seen is the noise of flux, not of
 * photons: bright ones must lie evenly among themselves, whatever the dim ones between them do,
 * and red ones need not make way for blue ones. Photons of equal flux push as in eq. 8. And the
 * push from dense to thin that the sheet's map tells is taken off (relax_gradient.h), else
 * relaxation blurs what it should keep. Plain relaxation is left as published.
 */
#include "photon/relax.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/clock.h"
#include "photon/features.h"
#include "photon/relax_forest.h"
#include "photon/relax_gradient.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__)
#define CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLONES
#endif
/* Else a clone would call what is compiled for any processor. */
#define INLINE static inline __attribute__((always_inline))

/* ---- one photon's step ---- */

INLINE float dot(const float a[3], const float b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

typedef struct Force {
	float at[3], radius; /* radius: distance of the farthest that pushes */
} Force;

/* Those near a photon: where it lies from each, how far (squared), and the light in common. */
typedef struct Near {
	float x[RELAX_MOST], y[RELAX_MOST], z[RELAX_MOST], distance2[RELAX_MOST],
		common[RELAX_MOST];
	int count;
} Near;

INLINE void look_around(const RelaxSet *set, uint32_t i, Near *near)
{
	const RelaxPoint *p = &set->points[i];
	const uint32_t *row = set->lists.index + (size_t)i * (size_t)set->lists.most;
	near->count = set->lists.counts[i];
	for (int j = 0; j < near->count; j++) {
		const RelaxPoint *q = &set->points[row[j]];
		near->x[j] = p->position[0] - q->position[0];
		near->y[j] = p->position[1] - q->position[1];
		near->z[j] = p->position[2] - q->position[2];
		near->common[j] = set->bases ? dot(p->flux, q->flux) : 1;
	}
	for (int j = 0; j < near->count; j++)
		near->distance2[j] = near->x[j] * near->x[j] + near->y[j] * near->y[j] +
				     near->z[j] * near->z[j];
}

/* The most of the values that fewer than k others are less than: the k-th, or the last. Counting
 * has no branches to mispredict and fills registers. */
INLINE float kth_least(const float *values, int count, int k)
{
	int less[RELAX_MOST];
	float kth = 0;
	memset(less, 0, sizeof *less * (size_t)count);
	for (int n = 0; n < count; n++) {
		float value = values[n];
#pragma omp simd
		for (int j = 0; j < count; j++)
			less[j] += value < values[j];
	}
#pragma omp simd reduction(max : kth)
	for (int j = 0; j < count; j++) {
		float value = less[j] < k ? values[j] : 0;
		kth = value > kth ? value : kth;
	}
	return kth;
}

/* SJ13 eq. 8, the mean weighed by the light in common; the farthest of them does not push. */
INLINE Force force_on(const RelaxSet *set, uint32_t i, int neighbors)
{
	Near near;
	look_around(set, i, &near);
	float radius2 = kth_least(near.distance2, near.count, neighbors), radius = sqrtf(radius2);
	Force f = {{0, 0, 0}, radius};
	float weight = 0, pushes[RELAX_MOST];
	const float tiny = 1e-20f; /* epsilon: two photons at one place do not push each other */
#pragma omp simd
	for (int j = 0; j < near.count; j++) {
		near.common[j] = near.distance2[j] <= radius2 ? near.common[j] : 0;
		pushes[j] = near.common[j] * (radius / (sqrtf(near.distance2[j]) + tiny) - 1);
	}
	for (int j = 0; j < near.count; j++) {
		weight += near.common[j];
		f.at[0] += near.x[j] * pushes[j];
		f.at[1] += near.y[j] * pushes[j];
		f.at[2] += near.z[j] * pushes[j];
	}
	float share = weight > 0 ? 1 / weight : 0;
	for (int k = 0; k < 3; k++)
		f.at[k] *= share;
	return f;
}

/* SJ13 eq. 9, or without constraints what lies in the tangent plane. */
INLINE void constrain(const RelaxSet *set, uint32_t i, Force *f)
{
	if (!set->bases) {
		const float *n = set->points[i].normal;
		float out = dot(f->at, n);
		for (int k = 0; k < 3; k++)
			f->at[k] -= out * n[k];
		return;
	}
	const RelaxBasis *b = &set->bases[i];
	float along = dot(f->at, b->u), across = b->v_length * dot(f->at, b->v);
	for (int k = 0; k < 3; k++)
		f->at[k] = along * b->u[k] + across * b->v[k];
}

INLINE void limit(Force *f)
{
	float length = sqrtf(dot(f->at, f->at)), most = 0.5f * f->radius;
	float scale = length > most ? most / length : 1;
	for (int k = 0; k < 3; k++)
		f->at[k] *= scale;
}

/* Where a photon goes to. */
typedef struct Step {
	float position[3], normal[3];
} Step;

typedef struct Work {
	Step *steps;
	int neighbors;
} Work;

static void stay(const RelaxPoint *point, Step *step)
{
	memcpy(step->position, point->position, sizeof step->position);
	memcpy(step->normal, point->normal, sizeof step->normal);
}

/* Onto the surface, or back to where the photon was if there is none. */
static void project(const RelaxSet *set, const RelaxPoint *point, float length, Step *step)
{
	RelaxPlace place = {point->object,
			    vec3_of_floats(step->position), vec3_of_floats(step->normal)};
	if (!set->surfaces->project(set->surfaces->data, &place, length)) {
		stay(point, step);
		return;
	}
	vec3_to_floats(place.position, step->position);
	vec3_to_floats(place.normal, step->normal);
}

CLONES static void step_run(RelaxSet *set, uint32_t first, uint32_t end, void *data)
{
	const Work *work = data;
	for (uint32_t i = first; i < end; i++) {
		const RelaxPoint *point = &set->points[i];
		Force f = force_on(set, i, work->neighbors);
		if (set->bases)
			relax_gradient_resist(set->bases[i].gradient, f.radius, f.at);
		constrain(set, i, &f);
		limit(&f);
		stay(point, &work->steps[i]);
		for (int k = 0; k < 3; k++)
			work->steps[i].position[k] += f.at[k];
		float length = sqrtf(dot(f.at, f.at));
		if (set->surfaces->project && length > 0)
			project(set, point, length, &work->steps[i]);
	}
}

static void move_run(RelaxSet *set, uint32_t first, uint32_t end, void *data)
{
	const Step *steps = ((const Work *)data)->steps;
	for (uint32_t i = first; i < end; i++) {
		memcpy(set->points[i].position, steps[i].position, sizeof steps[i].position);
		memcpy(set->points[i].normal, steps[i].normal, sizeof steps[i].normal);
	}
}

/* ---- all ---- */

/*
 * How many iterations the lists of those near last. A photon moves by a fraction of its distance
 * to the next in so many, and lists are twice as long as needed.
 */
enum { LIST_ITERATIONS = 4 };

static int listed_of(const Relaxation *settings)
{
	int listed = 2 * settings->repulsion_neighbors;
	return listed < RELAX_MOST ? listed : RELAX_MOST;
}

static void iterate(RelaxSet *set, const Relaxation *settings, RelaxSpace space, int iterations)
{
	Work work = {memory_alloc(sizeof(Step) * ((size_t)set->count + 1)),
		     settings->repulsion_neighbors};
	RelaxForest *forest = relax_forest_create(set, space);
	for (int i = 0; i < iterations && !relax_set_is_stopped(set); i++) {
		if (i % LIST_ITERATIONS == 0) {
			relax_lists_drop(set);
			relax_forest_grow(forest);
			relax_lists_fill(set, forest, listed_of(settings));
		}
		relax_set_each(set, step_run, &work);
		relax_set_each(set, move_run, &work);
	}
	relax_forest_destroy(forest);
	free(work.steps);
}

static void note_movement(const RelaxSet *set, const PhotonMap *map, RelaxStatistics *statistics)
{
	double sum = 0, freedom = 0;
	for (uint32_t i = 0; i < set->count; i++) {
		const float *p = set->points[i].position,
			    *q = map->photons[set->points[i].photon].position;
		sum += sqrt(pow((double)p[0] - q[0], 2) + pow((double)p[1] - q[1], 2) +
			    pow((double)p[2] - q[2], 2));
		freedom += set->bases ? set->bases[i].v_length : 1;
	}
	statistics->moved = set->count;
	statistics->mean_movement = set->count ? sum / set->count : 0;
	statistics->mean_constraint = set->count ? freedom / set->count : 1;
}

/* A photon that took no part has the basis of one that moves as it likes. */
static void note_freedom(const Photon *photon, PhotonConstraint *out)
{
	Vec3 tangent, across;
	vec3_frame(photon_normal(photon), &tangent, &across);
	vec3_to_floats(tangent, out->along);
	out->freedom = 1;
}

static void note_constraints(const RelaxSet *set, PhotonMap *map)
{
	PhotonConstraint *all = memory_resize(map->constraints,
					      sizeof *all * ((size_t)map->count + 1));
	map->constraints = all;
	for (uint32_t i = 0; i < map->count; i++)
		note_freedom(&map->photons[i], &all[i]);
	for (uint32_t i = 0; i < set->count; i++) {
		const RelaxBasis *b = &set->bases[i];
		all[set->points[i].photon] =
			(PhotonConstraint){{b->u[0], b->u[1], b->u[2]}, b->v_length};
	}
}

/* Numbers that no scene should ask for, made harmless. */
static Relaxation sensible(Relaxation s)
{
	s.neighbors = s.neighbors < 3 ? 3 : s.neighbors < 1000 ? s.neighbors : 1000;
	s.repulsion_neighbors = s.repulsion_neighbors < RELAX_MOST ? s.repulsion_neighbors
								   : RELAX_MOST;
	s.repulsion_neighbors = s.repulsion_neighbors > 1 ? s.repulsion_neighbors : 1;
	s.range = s.range > 0 ? s.range : 3;
	return s;
}

static void relax_points(RelaxSet *set, const Relaxation *settings, RelaxStatistics *statistics)
{
	double start = clock_wall();
	if (settings->constrained)
		features_detect(set, settings);
	double detected = clock_wall();
	if (settings->constrained) {
		iterate(set, settings, RELAX_PARAMETER, settings->parameter_iterations);
		iterate(set, settings, RELAX_WORLD, settings->world_iterations);
	} else {
		iterate(set, settings, RELAX_WORLD,
			settings->parameter_iterations + settings->world_iterations);
	}
	statistics->iterations =
		(uint64_t)(settings->parameter_iterations + settings->world_iterations);
	statistics->feature_seconds = detected - start;
	statistics->seconds = clock_wall() - detected;
}

/* Sheets' trees are many: what a forest leaves behind may go unused when the next one grows. */
double photon_relax_room(const Relaxation *settings)
{
	Relaxation s = sensible(*settings);
	double lists = (double)sizeof(uint32_t) * listed_of(&s) + sizeof(uint8_t);
	double point = sizeof(Photon) + sizeof(RelaxPoint) + sizeof(Step);
	TreeRoom forest = relax_forest_room(s.constrained ? RELAX_PARAMETER : RELAX_WORLD);
	if (s.constrained)
		point += sizeof(RelaxBasis) + forest.kept;
	return point + forest.kept + fmax(lists, forest.building);
}

/* Means weigh as many photons as they are of. */
static double joint_mean(double a, uint64_t count_a, double b, uint64_t count_b)
{
	uint64_t count = count_a + count_b;
	return count ? (a * (double)count_a + b * (double)count_b) / (double)count : a;
}

void relax_statistics_add(RelaxStatistics *sum, const RelaxStatistics *part)
{
	sum->mean_movement = joint_mean(sum->mean_movement, sum->moved, part->mean_movement,
					part->moved);
	sum->mean_constraint = joint_mean(sum->mean_constraint, sum->moved,
					  part->mean_constraint, part->moved);
	sum->moved += part->moved;
	sum->iterations += part->iterations;
	sum->feature_seconds += part->feature_seconds;
	sum->seconds += part->seconds;
}

bool photon_relax(PhotonMap *map, const Relaxation *settings, const RelaxSurfaces *surfaces,
		  RelaxStatistics *statistics)
{
	RelaxStatistics own;
	RelaxSet set;
	if (!statistics)
		statistics = &own;
	*statistics = (RelaxStatistics){.mean_constraint = 1};
	if (!settings->on || map->count == 0)
		return false;
	Relaxation s = sensible(*settings);
	relax_set_init(&set, map, surfaces, s.constrained && s.hues);
	if (set.count > 0)
		relax_points(&set, &s, statistics);
	bool moved = set.count > 0 && !relax_set_is_stopped(&set);
	if (moved) {
		note_movement(&set, map, statistics);
		if (s.constrained)
			note_constraints(&set, map);
		relax_set_store(&set, map);
	}
	map->relaxed = map->relaxed || moved;
	relax_set_free(&set);
	photon_tree_destroy(map->tree);
	map->tree = NULL;
	return moved;
}
