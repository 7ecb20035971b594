/*
 * Image maps. Pixel centres lie at half-integers; maps repeat, or end with `once`. Interpolation:
 * bilinear, Catmull-Rom bicubic, and inverse squared distance to the four neighbours, as measured
 * through function { pigment { image_map } }. The mappings are those of the warps of the same
 * names.
 */
#include "surface/image_map.h"

#include <math.h>

#include "surface/cubic.h"

/* A place on the raster in pixels, rows from the top. */
typedef struct Place {
	double x, y;
} Place;

/* (u, v) with v upwards. */
static Vec2 map_uv(const ImageMap *map, Vec3 p)
{
	double radius = sqrt(p.x * p.x + p.z * p.z);
	switch (map->mapping) {
	case IMAGE_MAPPING_SPHERICAL:
		return (Vec2){vec3_turn(p), atan2(p.y, radius) / M_PI + 0.5};
	case IMAGE_MAPPING_CYLINDRICAL:
		return (Vec2){vec3_turn(p), p.y};
	case IMAGE_MAPPING_TOROIDAL:
		return (Vec2){vec3_turn(p), atan2(p.y, radius - 1) / (2 * M_PI) + 0.5};
	default:
		return (Vec2){p.x, p.y};
	}
}

static bool map_place(const ImageMap *map, Vec3 p, Place *place)
{
	Vec2 uv = map_uv(map, p);
	uv.u -= map->offset.u;
	uv.v -= map->offset.v;
	if (map->once && (uv.u < 0 || uv.u > 1 || uv.v < 0 || uv.v > 1))
		return false;
	if (!(uv.u >= 0 && uv.u <= 1))
		uv.u -= floor(uv.u);
	if (!(uv.v >= 0 && uv.v <= 1))
		uv.v -= floor(uv.v);
	*place = (Place){uv.u * map->width, (1 - uv.v) * map->height};
	return isfinite(place->x) && isfinite(place->y);
}

/* A row or column brought into the raster: repeated, or held at the edge. */
static int inside_raster(const ImageMap *map, int i, int count)
{
	if (i >= 0 && i < count)
		return i;
	if (map->once)
		return i < 0 ? 0 : count - 1;
	i %= count;
	return i < 0 ? i + count : i;
}

static size_t pixel_offset(const ImageMap *map, int x, int y)
{
	x = inside_raster(map, x, map->width);
	y = inside_raster(map, y, map->height);
	return (size_t)y * (size_t)map->width + (size_t)x;
}

static Rgbft pixel_clear(const ImageMap *map, Rgbft color, float alpha, int index)
{
	color.filter = map->filter_all;
	color.transmit = map->transmit_all;
	if (index >= 0 && map->palette_filter)
		color.filter += map->palette_filter[index];
	if (index >= 0 && map->palette_transmit)
		color.transmit += map->palette_transmit[index];
	if (alpha < 1)
		color.transmit = 1 - alpha * (1 - color.transmit);
	return color;
}

static Rgbft pixel_color(const ImageMap *map, int x, int y)
{
	size_t at = pixel_offset(map, x, y);
	if (map->indices && map->palette && map->indices[at] < map->palette_count) {
		const float *c = map->palette + 4 * map->indices[at];
		return pixel_clear(map, rgbft(c[0], c[1], c[2], 0, 0), c[3], map->indices[at]);
	}
	const float *c = map->pixels + at * (size_t)map->channels;
	if (map->channels >= 3)
		return pixel_clear(map, rgbft(c[0], c[1], c[2], 0, 0),
				   map->channels == 4 ? c[3] : 1, -1);
	return pixel_clear(map, rgbft(c[0], c[0], c[0], 0, 0), map->channels == 2 ? c[1] : 1, -1);
}

/* What is interpolated: the colour, or one number a pixel. */
typedef Rgbft PixelReader(const ImageMap *map, int x, int y);

static Rgbft color_add(Rgbft sum, double weight, Rgbft c)
{
	float w = (float)weight;
	return rgbft(sum.r + w * c.r, sum.g + w * c.g, sum.b + w * c.b, sum.filter + w * c.filter,
	             sum.transmit + w * c.transmit);
}

static Rgbft read_cubic(const ImageMap *map, PixelReader *read, int x, int y, Place t)
{
	double wx[4], wy[4];
	Rgbft sum = {0};
	cubic_weights(t.x, wx);
	cubic_weights(t.y, wy);
	for (int j = 0; j < 4; j++)
		for (int i = 0; i < 4; i++)
			sum = color_add(sum, wx[i] * wy[j], read(map, x + i - 1, y + j - 1));
	return sum;
}

static double corner_weight(const ImageMap *map, Place t, int i, int j)
{
	double dx = i - t.x, dy = j - t.y;
	if (map->interpolation == IMAGE_INTERPOLATION_DISTANCE)
		return 1 / fmax(dx * dx + dy * dy, 1e-20);
	return (1 - fabs(dx)) * (1 - fabs(dy));
}

static Rgbft read_corners(const ImageMap *map, PixelReader *read, int x, int y, Place t)
{
	Rgbft sum = {0};
	double weights[4], total = 0;
	for (int n = 0; n < 4; n++)
		total += weights[n] = corner_weight(map, t, n & 1, n >> 1);
	for (int n = 0; n < 4; n++)
		sum = color_add(sum, weights[n] / total, read(map, x + (n & 1), y + (n >> 1)));
	return sum;
}

/* A border between rows belongs to the upper one: POV-Ray counts rows upwards. */
static int nearest_row(double y) { return (int)ceil(y) - 1; }

static Rgbft map_read(const ImageMap *map, PixelReader *read, Place place)
{
	if (map->interpolation == IMAGE_INTERPOLATION_NONE)
		return read(map, (int)floor(place.x), nearest_row(place.y));
	double x = floor(place.x - 0.5), y = floor(place.y - 0.5);
	Place t = {place.x - 0.5 - x, place.y - 0.5 - y};
	if (map->interpolation == IMAGE_INTERPOLATION_BICUBIC)
		return read_cubic(map, read, (int)x, (int)y, t);
	return read_corners(map, read, (int)x, (int)y, t);
}

bool image_map_color(const ImageMap *map, Vec3 p, Rgbft *color)
{
	Place place;
	*color = rgbft(1, 1, 1, 0, 1);
	if (!map_place(map, p, &place))
		return false;
	*color = map_read(map, pixel_color, place);
	return true;
}

int image_map_index(const ImageMap *map, Vec3 p)
{
	Place place;
	if (!map_place(map, p, &place))
		return 0;
	int x = (int)floor(place.x), y = nearest_row(place.y);
	size_t at = pixel_offset(map, x, y);
	if (map->indices && !map->use_color)
		return map->indices[at];
	return (int)(pixel_color(map, x, y).r * 255 + 0.5);
}

/* One number a pixel: alpha or grey, as the map's words say, whatever they say of the palette. In
 * the red channel. */
static Rgbft pixel_number(const ImageMap *map, int x, int y)
{
	Rgbft c = pixel_color(map, x, y);
	return rgbft(map->use_alpha ? c.transmit : rgb_gray(rgbft_rgb(c)), 0, 0, 0, 0);
}

double image_map_gray(const ImageMap *map, Vec3 p)
{
	Place place;
	return map_place(map, p, &place) ? map_read(map, pixel_number, place).r : 0;
}

/* A bump map's heights: grey, or palette indices as they are. */
static Rgbft pixel_height(const ImageMap *map, int x, int y)
{
	if (map->indices && !map->use_color)
		return rgbft(map->indices[pixel_offset(map, x, y)], 0, 0, 0, 0);
	return pixel_number(map, x, y);
}

/* Across and up on the surface with unit normal n, as the image lies on it. */
static void bump_frame(Vec3 n, Vec3 *across, Vec3 *up)
{
	double length = sqrt(n.x * n.x + n.z * n.z);
	*across = length > 1e-10 ? vec3(-n.z / length, 0, n.x / length) : vec3(1, 0, 0);
	*up = vec3_cross(*across, n);
}

/* Slopes from the pixel and the two that stand diagonally below it. */
Vec3 image_map_bump(const ImageMap *map, Vec3 p, double amount, Vec3 n)
{
	Place place;
	if (!map_place(map, p, &place))
		return n;
	double here = map_read(map, pixel_height, place).r;
	double left = map_read(map, pixel_height, (Place){place.x - 1, place.y + 1}).r;
	double right = map_read(map, pixel_height, (Place){place.x + 1, place.y + 1}).r;
	Vec3 across, up;
	bump_frame(n, &across, &up);
	n = vec3_mad(n, -amount * (right - left) / 2, across);
	return vec3_mad(n, amount * ((left + right) / 2 - here), up);
}
