/*
 * Pigments, normals, finishes, textures and interiors: what POV-Ray's texture { } and interior { }
 * blocks say. Plain immutable data, made by lang, evaluated here. Points come in world space at the
 * top and are taken down by transforms.
 */
#ifndef SURFACE_TEXTURE_H
#define SURFACE_TEXTURE_H

#include "base/arena.h"
#include "base/color.h"
#include "base/transform.h"
#include "surface/pattern.h"
#include "surface/point.h"

typedef struct Pigment Pigment;
typedef struct Normal Normal;
typedef struct Texture Texture;
typedef struct ImageMap ImageMap; /* surface/image_map.h */

/* ---- pigment: a colour for every point ---- */

typedef enum PigmentKind {
	PIGMENT_COLOR,       /* color */
	PIGMENT_COLOR_MAP,   /* pattern + colors */
	PIGMENT_PIGMENT_MAP, /* pattern + pigments */
	PIGMENT_LIST,        /* list pattern + pigments: checker, brick, object... */
	PIGMENT_AVERAGE,     /* pigments weighted by their keys */
	PIGMENT_IMAGE,       /* image */
	PIGMENT_UV,          /* uv_mapping: the one pigment at (u, v, 0) */
} PigmentKind;

/* Keys rise. Below the first and above the last the end entries hold. */
typedef struct ColorEntry { double key; Rgbft color; } ColorEntry;
typedef struct PigmentEntry { double key; const Pigment *pigment; } PigmentEntry;

struct Pigment {
	PigmentKind kind;
	Pattern pattern;          /* its warps bend the point for every kind */
	Rgbft color;
	const ColorEntry *colors; int color_count;
	const PigmentEntry *pigments; int pigment_count;
	const ImageMap *image;
	Rgbft quick_color; bool has_quick_color;
};

Rgbft pigment_color(const Pigment *pigment, const SurfacePoint *at);
/* True when no place of it lets light through. May say false for an opaque one. */
bool pigment_is_opaque(const Pigment *pigment);
bool pigment_uses_uv(const Pigment *pigment);

/* ---- normal: a perturbation of the shading normal ---- */

typedef enum NormalKind {
	NORMAL_PATTERN,
	NORMAL_SLOPE_MAP,
	NORMAL_NORMAL_MAP,
	NORMAL_LIST,
	NORMAL_AVERAGE,
	NORMAL_BUMP_MAP,
	NORMAL_UV
} NormalKind;

typedef struct SlopeEntry { double key, height, slope; } SlopeEntry;
typedef struct NormalEntry { double key; const Normal *normal; } NormalEntry;

struct Normal {
	NormalKind kind;
	Pattern pattern;
	double amount;     /* bump depth */
	double bump_size;  /* factor of normal maps; 1 */
	double accuracy;   /* step of the finite difference; 0.02 */
	const SlopeEntry *slopes; int slope_count;
	const NormalEntry *normals; int normal_count;
	const ImageMap *image;
	bool no_bump_scale;
};

/* The perturbed normal for the normal n; at->p, n and the result are in the space that the normal
 * block stands in (its warps lead down from there). Unit, unless no_bump_scale keeps lengths. */
Vec3 normal_perturb(const Normal *normal, const SurfacePoint *at, Vec3 n);

bool normal_uses_uv(const Normal *normal);

/* ---- finish ---- */

typedef struct Finish {
	Rgb ambient, emission;
	float diffuse, diffuse_back, brilliance;
	bool diffuse_albedo, specular_albedo, phong_albedo;
	float phong, phong_size;
	float specular, roughness; /* roughness as the scene says; exponent is 1/roughness */
	float metallic;            /* phong and specular highlights take the surface's colour */
	float crand;
	bool conserve_energy;
	bool use_subsurface; Rgb subsurface_translucency; Rgb subsurface_anisotropy;
	struct {
		Rgb min, max;
		bool fresnel;
		float falloff, exponent, metallic;
	} reflection;
	struct { float amount, thickness, turbulence; } irid;
	const struct Interior *interior; /* from words of old versions (ior, caustics, fade_distance
					    in a finish), or NULL */
} Finish;

Finish finish_default(void);

/* ---- texture ---- */

typedef enum TextureKind {
	TEXTURE_PLAIN,
	TEXTURE_MAP,
	TEXTURE_LIST,
	TEXTURE_AVERAGE,
	TEXTURE_MATERIAL_MAP,
	TEXTURE_UV
} TextureKind;

typedef struct TextureEntry { double key; const Texture *texture; } TextureEntry;

struct Texture {
	TextureKind kind;
	const Transform *transform; /* texture space to the space it is attached in; NULL: the same.
				     * Applies to everything in this struct, not to next */
	const Pigment *pigment;     /* PLAIN; never NULL */
	const Normal *normal;       /* PLAIN; may be NULL */
	const Finish *finish;       /* PLAIN; never NULL */
	Pattern pattern;            /* the others */
	const TextureEntry *textures; int texture_count;
	const ImageMap *image;      /* MATERIAL_MAP */
	const Texture *next;        /* the layer above this one, or NULL */
};

/* What the integrator shades: stacks of layers with weights that add up to 1. Layers of a stack
 * come bottom to top. */
typedef struct ShadingLayer {
	Rgbft color;
	Vec3 normal; /* unit, world */
	const Finish *finish;
} ShadingLayer;

typedef struct ShadingStack { float weight; int first, count; } ShadingStack;

/* Averages of a hundred textures stand for blurred reflections in many scenes. */
enum { SHADING_MAX_LAYERS = 160, SHADING_MAX_STACKS = 128 };

typedef struct Shading {
	ShadingLayer layers[SHADING_MAX_LAYERS]; int layer_count;
	ShadingStack stacks[SHADING_MAX_STACKS]; int stack_count;
} Shading;

/* Evaluates the texture at a world point; at->p is ignored, at->world used. attach is the transform
 * from the space the texture was attached in to the world (NULL: none). When stacks run out the
 * later ones are dropped and the weights rescaled. */
void texture_shade(const Texture *texture, const Transform *attach, const SurfacePoint *at,
		   Shading *out);

/* One of several textures that cover a point together, as above, and its share of it. */
typedef struct TexturePart {
	const Texture *texture;
	const Transform *attach;
	double weight;
} TexturePart;

/* The same of all of them; shares are rescaled to add up to 1. */
void texture_shade_parts(const TexturePart *parts, int count, const SurfacePoint *at, Shading *out);

/* True when no place of it lets light through. May say false for an opaque one. */
bool texture_is_opaque(const Texture *texture);
/* True when every layer of it has a diffuse part or a highlight, and none reflects. May say
 * false. */
bool texture_is_dull(const Texture *texture);
/* True when it is one layer of one colour without bumps, the same everywhere. */
bool texture_is_uniform(const Texture *texture);
/* True when some part of it looks at the surface's (u, v). */
bool texture_uses_uv(const Texture *texture);
/* The same texture laid out over (u, v), as uv_mapping in an object asks for. */
const Texture *texture_by_uv(Arena *arena, const Texture *texture);
/* The interior that old versions' finish words give an object without one; NULL: none. */
const struct Interior *texture_interior(const Texture *texture);

/* ---- interior ---- */

typedef struct Interior {
	float ior;              /* 1 */
	float caustics;         /* POV-Ray's fake caustics power; 0 */
	float fade_distance, fade_power;
	Rgb fade_color;
	float dispersion;       /* ratio of the ior of violet to that of red; 1 */
	int dispersion_samples; /* 7 */
	const void *media;      /* for the volume room */
} Interior;

Interior interior_default(void);
/* Whether its index depends on the hue; NULL is allowed. */
static inline bool interior_disperses(const Interior *interior)
{
	return interior && interior->dispersion != 1 && interior->dispersion > 0;
}
double interior_ior_of_hue(const Interior *interior, double hue);
/* The index of refraction for a hue: 0 red, 1 violet, 0.5 the scene's own number. dispersion is
 * violet's over red's. */
static inline double interior_ior(const Interior *interior, double hue)
{
	if (interior_disperses(interior))
		return interior_ior_of_hue(interior, hue);
	return interior->ior > 0 ? interior->ior : 1;
}
/* The colour of a hue, such that hues evenly spread over [0, 1] make white. */
Rgb interior_hue_color(double hue);

#endif
