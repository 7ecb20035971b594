/*
 * The pattern `tiling`: tiles of a few types that fill the x-z plane, periodic in two directions,
 * with bevelled edges. Which tiles there are and where they lie, the types' numbers and the width
 * of the bevel were measured from POV-Ray's pictures.
 * (Tiling 22 of POV-Ray bevels a few of its edges a little wider than the others.)
 *
 * With n types a tile of type k has the value k/n in its middle, up to (k+1)/n on its edge; the
 * bevel is as wide as the smallest tile allows.
 */
#include <math.h>
#include <string.h>

#include "surface/pattern_classes.h"
#include "surface/pattern_data.h"

#define H 0.86602540378443864676 /* the height of a triangle with sides of 1 */
#define R 0.70710678118654752440 /* half the diagonal of a square with sides of 1 */

typedef struct TilingDesc {
	int types;
	double bevel; /* how far from their edges tiles are bevelled */
	Vec2 a, b;    /* x and z of the two steps after which everything repeats */
} TilingDesc;

static const TilingDesc tiling_table[] = {
	[1] = {1, 0.5, {1, 0}, {0, 1}},
	[2] = {1, H, {1.5, H}, {0, 2 * H}},
	[3] = {2, H / 3, {1, 0}, {0.5, H}},
	[4] = {1, H / 2, {1, 0}, {0.5, H}},
	[5] = {3, H / 2, {1.5, H}, {0, 2 * H}},
	[6] = {2, 0.5, {4, 0}, {1, 1}},
	[7] = {2, 0.5, {1 + 2 * R, 0}, {0, 1 + 2 * R}},
	[8] = {3, H / 3, {1, 0}, {0.5, 1 + H}},
	[9] = {3, H / 3, {2, 0}, {1, 2 * H}},
	[10] = {1, 0.5, {1, 0}, {0.5, 1}},
	[11] = {3, 0.5, {3, 0}, {0, 3}},
	[12] = {3, 0.5, {3, 3}, {3, -3}},
	[13] = {3, R / 2, {4 * R, 0}, {0, 4 * R}},
	[14] = {5, R / 2, {4 * R, 0}, {0, 4 * R}},
	[15] = {2, 0.5, {1, -2}, {2, 1}},
	[16] = {3, H / 3, {1.5 + H, 0.5 + H}, {0, 1 + 2 * H}},
	[17] = {6, H / 3, {1.5 + H, 0.5 + H}, {0, 1 + 2 * H}},
	[18] = {2, 0.5, {4, 0}, {2, 2}},
	[19] = {3, H / 3, {2.5, -H}, {2, 2 * H}},
	[20] = {3, H / 3, {2.5, H}, {2, -2 * H}},
	[21] = {6, H / 3, {0.5 + H, 0.5 + H}, {0.5 + H, -0.5 - H}},
	[22] = {3, H / 3, {2 + 2 * H, 0}, {1 + H, 1.5 + 2 * H}},
	[23] = {3, 0.5, {3 + 2 * H, 0}, {1.5 + H, 1.5 + 3 * H}},
	[24] = {5, 0.5, {3 + 2 * H, 0}, {1.5 + H, 1.5 + 3 * H}},
};

/*
 * A tile is convex. Its outline goes from a corner round to the left: each letter is an edge, A
 * along x and every next letter 15 degrees further towards z, of length 1, small letters of the
 * square root of 2.
 */
typedef struct TileDesc {
	int tiling, type;
	double x, z; /* the corner */
	const char *edges;
} TileDesc;

static const TileDesc tile_table[] = {
	{1, 0, 0, 0, "AGMS"},
	{2, 0, -1.5, -H, "AEIMQU"},
	{3, 0, 0, 0, "AIQ"},
	{3, 1, 0, 0, "EMU"},
	{4, 0, 0, 0, "AEMQ"},
	{5, 0, 0, 0, "AEMQ"},
	{5, 1, 1.5, -H, "EIQU"},
	{5, 2, -1, 0, "AIMU"},
	{6, 0, 0, -1, "AAGMMS"},
	{6, 1, -2, -2, "AGGMSS"},
	{7, 0, 0.5 + R, 0.5, "DJPV"},
	{7, 1, -0.5, -0.5 - R, "ADGJMPSV"},
	{8, 0, -0.5, -H, "AIQ"},
	{8, 1, 0.5, -H, "EMU"},
	{8, 2, 0, 0, "AGMS"},
	{9, 0, -1, 0, "AIQ"},
	{9, 1, 0.5, -H, "EMU"},
	{9, 2, -1, -2 * H, "AEIMQU"},
	{10, 0, 0, 0, "AGMS"},
	{11, 0, 1, 1, "AGMS"},
	{11, 1, 0, -1, "AAGMMS"},
	{11, 1, 1, 0, "AAGMMS"},
	{11, 2, 2, 1, "AGGMSS"},
	{11, 2, 0, 0, "AGGMSS"},
	{12, 0, 1, 1, "AGMS"},
	{12, 0, 1, -2, "AGMS"},
	{12, 2, -1, -2, "AGGMSS"},
	{12, 2, -1, 0, "AGGMSS"},
	{12, 2, 0, -2, "AGGMSS"},
	{12, 2, 0, 0, "AGGMSS"},
	{12, 1, -3, -1, "AAGMMS"},
	{12, 1, -3, 0, "AAGMMS"},
	{12, 1, 1, -1, "AAGMMS"},
	{12, 1, 1, 0, "AAGMMS"},
	{13, 0, R, R, "agms"},
	{13, 1, 0, 0, "VaDmm"},
	{13, 1, 0, 0, "aaJmP"},
	{13, 2, 0, 0, "DgJss"},
	{13, 2, 0, 0, "ggPsV"},
	{14, 4, R, R, "agms"},
	{14, 3, 0, 0, "VaDmm"},
	{14, 2, 0, 0, "aaJmP"},
	{14, 1, 0, 0, "DgJss"},
	{14, 0, 0, 0, "ggPsV"},
	{15, 0, 0, 0, "AGMS"},
	{15, 1, -1, -2, "AAGGMMSS"},
	{16, 2, -1.5, -H, "AEIMQU"},
	{16, 0, -1.5, H, "AGMS"},
	{16, 0, 0, 0, "CIOU"},
	{16, 0, -0.5, -H, "WEKQ"},
	{16, 1, 0, 0, "WGO"},
	{16, 1, 1 + H, -0.5, "CKS"},
	{17, 5, -1.5, -H, "AEIMQU"},
	{17, 0, -1.5, H, "AGMS"},
	{17, 1, 0, 0, "CIOU"},
	{17, 2, -0.5, -H, "WEKQ"},
	{17, 4, 0, 0, "WGO"},
	{17, 3, 1 + H, -0.5, "CKS"},
	{18, 0, -2, 0, "AAGMMS"},
	{18, 0, -2, 1, "AAGMMS"},
	{18, 1, 0, 0, "AGGMSS"},
	{18, 1, 1, 0, "AGGMSS"},
	{19, 2, -1.5, -H, "AEIMQU"},
	{19, 0, 0, 0, "AIQ"},
	{19, 0, 1, 0, "AIQ"},
	{19, 0, -0.5, -H, "AIQ"},
	{19, 0, -0.5, H, "AIQ"},
	{19, 1, 0.5, -H, "EMU"},
	{19, 1, 0, 0, "EMU"},
	{19, 1, 1, 0, "EMU"},
	{19, 1, -0.5, H, "EMU"},
	{20, 2, 0, -2 * H, "AEIMQU"},
	{20, 0, -1, 0, "AIQ"},
	{20, 0, 0, 0, "AIQ"},
	{20, 0, 1, 0, "AIQ"},
	{20, 0, -0.5, H, "AIQ"},
	{20, 1, 0, 0, "EMU"},
	{20, 1, 1, 0, "EMU"},
	{20, 1, 2, 0, "EMU"},
	{20, 1, -0.5, H, "EMU"},
	{21, 0, 0, -0.5, "CKS"},
	{21, 2, 0, -0.5, "GOW"},
	{21, 1, 0.5 + H, -H, "EMU"},
	{21, 3, H, 0, "AIQ"},
	{21, 4, H, 0, "EKQW"},
	{21, 5, 0.5, -0.5 - H, "CIOU"},
	{22, 0, -0.5, 0.5, "AIQ"},
	{22, 1, 1 + H, -H, "EMU"},
	{22, 2, -0.5, -1.5 - 2 * H, "ACEGIKMOQSUW"},
	{23, 2, -0.5, -1.5 - 2 * H, "ACEGIKMOQSUW"},
	{23, 0, -0.5, 0.5, "AEIMQU"},
	{23, 0, 1 + H, -H, "AEIMQU"},
	{23, 1, 1 + H, -1 - H, "AGMS"},
	{23, 1, 0.5 + H, 0, "EKQW"},
	{23, 1, -0.5, 0.5, "IOUC"},
	{24, 4, -0.5, -1.5 - 2 * H, "ACEGIKMOQSUW"},
	{24, 0, -0.5, 0.5, "AEIMQU"},
	{24, 0, 1 + H, -H, "AEIMQU"},
	{24, 1, 1 + H, -1 - H, "AGMS"},
	{24, 2, 0.5 + H, 0, "EKQW"},
	{24, 3, -0.5, 0.5, "IOUC"},
};

#undef H
#undef R

typedef struct TileEdge {
	Vec2 corner, direction; /* from the tile's centre; unit */
} TileEdge;

typedef struct Tile {
	int type;
	Vec2 center;
	double reach2; /* the square of the distance of its furthest corner */
	int edge_count;
	const TileEdge *edges;
} Tile;

struct Tiling {
	const TilingDesc *desc;
	int tile_count;
	const Tile *tiles;
};

/* The edges as the letters say, corners not yet from the centre; returns the corners' mean. */
static Vec2 follow_edges(const TileDesc *desc, TileEdge *edges)
{
	const double step = M_PI / 12;
	Vec2 at = {desc->x, desc->z}, sum = {0, 0};
	for (int i = 0; desc->edges[i]; i++) {
		bool small = desc->edges[i] >= 'a';
		double angle = (desc->edges[i] - (small ? 'a' : 'A')) * step;
		double length = small ? sqrt(2) : 1;
		edges[i] = (TileEdge){at, {cos(angle), sin(angle)}};
		sum = (Vec2){sum.u + at.u, sum.v + at.v};
		at = (Vec2){at.u + length * cos(angle), at.v + length * sin(angle)};
	}
	double count = (double)strlen(desc->edges);
	return (Vec2){sum.u / count, sum.v / count};
}

static Tile tile_create(Arena *arena, const TileDesc *desc)
{
	int count = (int)strlen(desc->edges);
	TileEdge *edges = ARENA_ARRAY(arena, TileEdge, count);
	Tile tile = {desc->type, follow_edges(desc, edges), 0, count, edges};
	for (int i = 0; i < count; i++) {
		Vec2 *corner = &edges[i].corner;
		*corner = (Vec2){corner->u - tile.center.u, corner->v - tile.center.v};
		tile.reach2 = fmax(tile.reach2, corner->u * corner->u + corner->v * corner->v);
	}
	return tile;
}

const Tiling *tiling_create(Arena *arena, int kind)
{
	enum { TILES = sizeof tile_table / sizeof *tile_table };
	Tiling *tiling = ARENA_NEW(arena, Tiling);
	Tile *tiles = ARENA_ARRAY(arena, Tile, TILES);
	*tiling = (Tiling){&tiling_table[kind], 0, tiles};
	for (int i = 0; i < TILES; i++)
		if (tile_table[i].tiling == kind)
			tiles[tiling->tile_count++] = tile_create(arena, &tile_table[i]);
	return tiling;
}

/* How deep a point lies in a tile round the origin: the distance to its nearest edge, negative
 * outside. */
static double tile_depth(const Tile *tile, Vec2 p)
{
	double least = HUGE_VAL;
	for (int i = 0; i < tile->edge_count; i++) {
		const TileEdge *edge = &tile->edges[i];
		double depth = edge->direction.u * (p.v - edge->corner.v) -
			       edge->direction.v * (p.u - edge->corner.u);
		least = fmin(least, depth);
	}
	return least;
}

/* The depth in the one of the tile's repetitions that holds the point, or is nearest to. */
static double tile_depth_repeated(const Tile *tile, const TilingDesc *desc, Vec2 p)
{
	Vec2 a = desc->a, b = desc->b, d = {p.u - tile->center.u, p.v - tile->center.v};
	double area = a.u * b.v - a.v * b.u;
	double i0 = rint((d.u * b.v - d.v * b.u) / area), j0 = rint((a.u * d.v - a.v * d.u) / area);
	double deepest = -HUGE_VAL;
	for (int i = -1; i <= 1; i++)
		for (int j = -1; j <= 1; j++) {
			Vec2 q = {d.u - (i0 + i) * a.u - (j0 + j) * b.u,
				  d.v - (i0 + i) * a.v - (j0 + j) * b.v};
			if (q.u * q.u + q.v * q.v <= tile->reach2)
				deepest = fmax(deepest, tile_depth(tile, q));
		}
	return deepest;
}

static double value_tiling(const Pattern *pattern, const SurfacePoint *at)
{
	const Tiling *tiling = ((const TilingData *)pattern->data)->tiling;
	double deepest = -HUGE_VAL;
	int type = 0;
	for (int i = 0; i < tiling->tile_count && deepest < 0; i++) {
		const Tile *tile = &tiling->tiles[i];
		double depth = tile_depth_repeated(tile, tiling->desc, (Vec2){at->p.x, at->p.z});
		if (depth > deepest) {
			deepest = depth;
			type = tile->type;
		}
	}
	double bevel = fmin(fmax(0, 1 - deepest / tiling->desc->bevel), 1);
	return (type + bevel) / tiling->desc->types;
}

const PatternClass pattern_tiling = {"tiling", value_tiling, 0, NULL, PATTERN_NEEDS_DATA};
