/*
 * Area lights follow POV-Ray 3.7's manual, section 3.4.4.1.5: shadow rays go to the corners of the
 * grid first, and a part whose corners agree is not looked at closer. Without area_illumination
 * only the shadow is soft; the light's direction and strength stay those of its centre.
 */
#include "render/lighting.h"

#include "light/area.h"
#include "scene/shade.h"

/* Corners that differ by less than this are taken as equal (sum of the colour's differences). */
static const float GRID_TOLERANCE = 0.1f;

/* ---- the grid of an area light ---- */

typedef struct Grid {
	Tracer *tracer;
	const LitPoint *at;
	int number;
	const Light *light;
	AreaFrame frame;
	Vec3 centre; /* from the lit point to the light's, which for parallel light is above every
			point */
} Grid;

static Vec3 grid_point(Grid *grid, int column, int row)
{
	double u = column, v = row;
	if (grid->light->jitter) {
		u += sampler_next(&grid->tracer->sampler) - 0.5;
		v += sampler_next(&grid->tracer->sampler) - 0.5;
	}
	return area_point(grid->light, &grid->frame, u, v);
}

static Rgb grid_visibility(Grid *grid, int column, int row)
{
	int at = row * grid->light->size1 + column;
	Tracer *tracer = grid->tracer;
	if (!tracer->grid_known[at]) {
		Vec3 offset = vec3_add(grid->centre, vec3_sub(grid_point(grid, column, row),
							      grid->light->position));
		double distance = vec3_length(offset);
		tracer->grid[at] = shadow_visibility(tracer, grid->at, grid->number,
		                                     vec3_scale(offset, 1 / distance), distance);
		tracer->grid_known[at] = true;
	}
	return tracer->grid[at];
}

static bool colors_differ(Rgb a, Rgb b)
{
	return fabsf(a.r - b.r) + fabsf(a.g - b.g) + fabsf(a.b - b.b) > GRID_TOLERANCE;
}

static bool corners_differ(const Rgb corner[4])
{
	return colors_differ(corner[0], corner[1]) || colors_differ(corner[1], corner[3]) ||
		colors_differ(corner[3], corner[2]) || colors_differ(corner[2], corner[0]);
}

static Rgb mean_of_four(const Rgb c[4])
{
	return rgb_scale(rgb_add(rgb_add(c[0], c[1]), rgb_add(c[2], c[3])), 0.25f);
}

/* A range of columns or rows cut at its middle; returns the number of pieces. */
static int split_range(const int range[2], int pieces[2][2])
{
	int sum = range[0] + range[1];
	pieces[0][0] = range[0];
	pieces[0][1] = range[1];
	if (range[1] - range[0] <= 1)
		return 1;
	pieces[0][1] = sum / 2;
	pieces[1][0] = sum - sum / 2; /* the next one when the range has no middle */
	pieces[1][1] = range[1];
	return 2;
}

/* The part of the grid between two columns and two rows. */
static Rgb grid_part(Grid *grid, const int columns[2], const int rows[2], int level)
{
	Rgb corner[4], sum = {0, 0, 0};
	for (int i = 0; i < 4; i++)
		corner[i] = grid_visibility(grid, columns[i & 1], rows[i >> 1]);
	if (grid->light->adaptive >= 0 && level >= grid->light->adaptive && !corners_differ(corner))
		return mean_of_four(corner);
	int across[2][2], down[2][2];
	int across_count = split_range(columns, across), down_count = split_range(rows, down);
	if (across_count * down_count == 1)
		return mean_of_four(corner);
	for (int r = 0; r < down_count; r++)
		for (int c = 0; c < across_count; c++)
			sum = rgb_add(sum, grid_part(grid, across[c], down[r], level + 1));
	return rgb_scale(sum, 1.0f / (float)(across_count * down_count));
}

static Grid grid_start(Tracer *tracer, const LitPoint *at, int number)
{
	const Light *light = &tracer->scene->lights[number];
	for (int i = 0; i < light->size1 * light->size2; i++)
		tracer->grid_known[i] = false;
	Vec3 direction;
	double distance;
	light_arrival(light, light->position, at->p, &direction, &distance);
	return (Grid){tracer,
		      at,
		      number,
		      light,
		      area_frame(light, at->p),
		      vec3_scale(direction, distance)};
}

static Rgb area_visibility(Tracer *tracer, const LitPoint *at, int number)
{
	Grid grid = grid_start(tracer, at, number);
	int columns[2] = {0, grid.light->size1 - 1}, rows[2] = {0, grid.light->size2 - 1};
	return grid_part(&grid, columns, rows, 0);
}

/* Every point of the grid as a light of its own. */
static Rgb area_illumination(Tracer *tracer, const LitPoint *at, int number, const Bsdf *bsdf)
{
	Grid grid = grid_start(tracer, at, number);
	int total = grid.light->size1 * grid.light->size2;
	Rgb sum = {0, 0, 0};
	for (int i = 0; i < total; i++) {
		Vec3 direction,
			from = grid_point(&grid, i % grid.light->size1, i / grid.light->size1);
		double distance;
		Rgb arrived = light_arrival(grid.light, from, at->p, &direction, &distance);
		arrived = rgb_mul(arrived, bsdf_eval(bsdf, direction, true));
		if (!rgb_is_black(arrived))
			sum = rgb_add(sum,
				      rgb_mul(arrived, shadow_visibility(tracer, at, number,
									 direction, distance)));
	}
	return rgb_scale(sum, 1.0f / (float)total);
}

/* ---- all lights ---- */

static Rgb one_light(Tracer *tracer, const LitPoint *at, int number, const Bsdf *bsdf)
{
	const Light *light = &tracer->scene->lights[number];
	bool area = light->area && tracer->quality.area_lights;
	bool shadows = tracer->quality.shadows && !light->shadowless;
	if (area && light->area_illumination && shadows)
		return area_illumination(tracer, at, number, bsdf);
	Vec3 direction;
	double distance;
	Rgb light_color = light_arrival(light, light->position, at->p, &direction, &distance);
	if (rgb_is_black(light_color))
		return light_color;
	Rgb sent = rgb_mul(light_color, bsdf_eval(bsdf, direction, !light->shadowless));
	if (!shadows || rgb_is_black(sent))
		return sent;
	Rgb visible = area ? area_visibility(tracer, at, number)
	                   : shadow_visibility(tracer, at, number, direction, distance);
	return rgb_mul(sent, visible);
}

Rgb lighting_at(Tracer *tracer, const LitPoint *at, const Bsdf *bsdf)
{
	Rgb sum = {0, 0, 0};
	if (bsdf_is_delta(bsdf))
		return sum;
	for (int i = 0; i < tracer->scene->light_count; i++)
		if (shade_light_reaches(&tracer->scene->lights[i], at->surface))
			sum = rgb_add(sum, one_light(tracer, at, i, bsdf));
	return sum;
}
