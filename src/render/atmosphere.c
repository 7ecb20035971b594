/* POV-Ray 3.7's manual: sky_sphere 3.4.3.4, fog 3.4.3.3, rainbow 3.4.3.5. */
#include "render/atmosphere.h"

#include <math.h>


static const double FAR_AWAY = 1e7; /* the length of a ray that meets nothing */
static const double PI = 3.14159265358979323846;

static float mean(Rgb color)
{
	return (color.r + color.g + color.b) / 3;
}

/* ---- sky ---- */

/* What the layers of the sky so far let through. */
typedef struct SkyPassage {
	Rgb through;  /* of the background, and of a lower layer's light */
	Rgbft legacy; /* the same as scenes before version 3.7 count it: product of colours,
			 filters, transmits */
} SkyPassage;

static void pass_sky(SkyPassage *passage, Rgbft color, bool legacy)
{
	Rgbft product = passage->legacy;
	passage->legacy = rgbft(product.r * color.r, product.g * color.g, product.b * color.b,
	                        product.filter * color.filter, product.transmit * color.transmit);
	passage->through = rgb_mul(passage->through, rgbft_transmittance(color));
	if (legacy)
		passage->through = rgbft_transmittance(passage->legacy);
}

/* Old scenes' clouds do not tint what lies under them, they only weaken it. */
static Rgb layer_share(const SkyPassage *passage, bool first, bool legacy)
{
	if (!legacy || first)
		return passage->through;
	return rgb_all(fminf(fabsf(passage->legacy.filter) + fabsf(passage->legacy.transmit), 1));
}

static Rgb sky_layers(const SkySphere *sky, Vec3 direction, bool legacy, Rgb *through)
{
	Vec3 p = transform_vector_inverse(&sky->transform, direction);
	SurfacePoint at = {.p = p, .world = p, .normal = direction, .direction = direction};
	SkyPassage passage = {{1, 1, 1}, {1, 1, 1, 1, 1}};
	Rgb sum = {0, 0, 0};
	for (int i = sky->count - 1; i >= 0; i--) {
		Rgbft color = pigment_color(sky->pigments[i], &at);
		Rgb own = rgb_scale(rgb_mul(rgbft_rgb(color), sky->emission),
				    1 - color.filter - color.transmit);
		sum = rgb_add(sum,
			      rgb_mul(own, layer_share(&passage, i == sky->count - 1, legacy)));
		pass_sky(&passage, color, legacy);
	}
	*through = passage.through;
	return sum;
}

/* What of the background's colour is seen, as measured: a picture without alpha loses what transmit
 * lets through, though not what filter does; one with alpha loses both, but mirrors show the whole
 * colour. */
static float background_share(const Tracer *tracer, const PathRay *path)
{
	Rgbft background = tracer->scene->background;
	if (!tracer->alpha)
		return fmaxf(1 - background.transmit, 0);
	return path->reflected ? 1 : rgbft_opacity(background);
}

Seen atmosphere_sky(const Tracer *tracer, const PathRay *path)
{
	const Scene *scene = tracer->scene;
	Rgb through = {1, 1, 1}, sum = {0, 0, 0};
	if (scene->sky_sphere)
		sum = sky_layers(scene->sky_sphere, path->ray.direction, tracer->legacy, &through);
	Rgb own = rgb_scale(rgbft_rgb(scene->background), background_share(tracer, path));
	float transmit = tracer->alpha
				 ? mean(rgb_mul(through, rgbft_transmittance(scene->background)))
				 : 0;
	return (Seen){.color = rgb_add(sum, rgb_mul(through, own)), .transmit = transmit};
}

/* ---- fog ---- */

/* Density of ground fog is 1 under its offset and falls as 1/(1 + y^2) above, y in units of
 * fog_alt; this is its mean along a way from y1 to y2, from the integral's arctangent. */
static double ground_mean(double y1, double y2)
{
	double low = fmin(y1, y2), high = fmax(y1, y2);
	if (high <= 0)
		return 1;
	if (high - low < 1e-9)
		return 1 / (1 + high * high);
	double above = atan(high) - atan(fmax(low, 0));
	return (above - fmin(low, 0)) / (high - low);
}

/* The share of a depth that turbulence leaves: what it takes comes from the place halfway, and is
 * less the farther one sees. Measured from POV-Ray's images. */
static double turbulent_share(const Fog *fog, const Ray *ray, double distance, int generator)
{
	Vec3 middle = vec3_mul(ray_at(ray, distance / 2), fog->turbulence.amount);
	double noise = turbulence_value(middle, &fog->turbulence, generator);
	return 1 - exp(-distance / fog->distance) * fmin(1, fog->turb_depth * noise);
}

static double fog_depth(const Fog *fog, const Ray *ray, double distance, int generator)
{
	double depth = distance;
	if (fog->kind == FOG_GROUND && fog->alt != 0) {
		double y1 = (vec3_dot(ray->origin, fog->up) - fog->offset) / fog->alt;
		double y2 = (vec3_dot(ray_at(ray, distance), fog->up) - fog->offset) / fog->alt;
		depth *= ground_mean(y1, y2);
	}
	if (vec3_length2(fog->turbulence.amount) > 0)
		depth *= turbulent_share(fog, ray, distance, generator);
	return depth;
}

/* What the fogs together leave of a sight, and the light that they add. */
typedef struct FogSum {
	Rgb left, light;
} FogSum;

static void add_fog(const Fog *fog, const Ray *ray, double distance, int generator, FogSum *sum)
{
	if (fog->distance == 0)
		return;
	float left = (float)exp(-fog_depth(fog, ray, distance, generator) / fog->distance);
	left = fmaxf(left, fog->color.transmit);
	Rgb color = rgbft_rgb(fog->color);
	Rgb tint = rgb_lerp(rgb_all(1), color, fog->color.filter);
	sum->left = rgb_mul(sum->left, rgb_scale(tint, left));
	sum->light = rgb_mad(sum->light, 1 - left, color);
}

static FogSum sum_fogs(const Scene *scene, const Ray *ray, double distance)
{
	FogSum sum = {{1, 1, 1}, {0, 0, 0}};
	for (int i = 0; i < scene->fog_count; i++)
		add_fog(scene->fogs[i], ray, distance, scene->settings.noise_generator, &sum);
	return sum;
}

Rgb atmosphere_transmittance(const Scene *scene, const Ray *ray, double distance)
{
	return sum_fogs(scene, ray, distance).left;
}

/* ---- rainbow ---- */

/* The share that the rainbow's arc leaves at a direction: 1 inside arc_angle, falling to 0 over
 * falloff_angle. */
static double arc_share(const Rainbow *rainbow, Vec3 direction)
{
	Vec3 right = vec3_normalize(vec3_cross(rainbow->up, rainbow->antisolar));
	Vec3 up = vec3_normalize(vec3_cross(rainbow->antisolar, right));
	double turn = fabs(atan2(vec3_dot(direction, right), vec3_dot(direction, up))) * 180 / PI;
	double outer = rainbow->arc_angle / 2, inner = rainbow->falloff_angle / 2;
	if (turn > outer)
		return 0;
	if (turn <= inner || outer <= inner)
		return 1;
	double share = (outer - turn) / (outer - inner);
	return share * share * (3 - 2 * share);
}

/* Rainbows over one another do not add up: what is seen is their mean. */
typedef struct RainbowSum {
	Rgb left, light;
	int count;
} RainbowSum;

static void add_rainbow(Tracer *tracer, const Rainbow *rainbow, const Ray *ray, double distance,
			RainbowSum *sum)
{
	if (!rainbow->pigment || rainbow->width == 0 || rainbow->distance == 0)
		return;
	double cosine = fmin(fmax(vec3_dot(ray->direction, rainbow->antisolar), -1), 1);
	double place = (acos(cosine) * 180 / PI - rainbow->angle) / rainbow->width + 0.5;
	if (rainbow->jitter != 0)
		place += (2 * sampler_next(&tracer->sampler) - 1) * rainbow->jitter;
	double share = place >= 0 && place <= 1 ? arc_share(rainbow, ray->direction) : 0;
	if (share <= 0)
		return;
	SurfacePoint at = {.p = {place, 0, 0}, .world = {place, 0, 0}, .direction = ray->direction};
	Rgbft color = pigment_color(rainbow->pigment, &at);
	double near = exp(-distance / rainbow->distance);
	float left = (float)fmin(fmax(near, 1 - share + share * color.transmit), 1);
	Rgb tint = rgb_lerp(rgb_all(1), rgbft_rgb(color), color.filter * (1 - left));
	sum->left = rgb_add(sum->left, rgb_scale(tint, left));
	sum->light = rgb_mad(sum->light, 1 - left, rgbft_rgb(color));
	sum->count++;
}

static Seen rainbows_apply(Tracer *tracer, const Ray *ray, double distance, Seen seen)
{
	RainbowSum sum = {.count = 0};
	for (int i = 0; i < tracer->scene->rainbow_count; i++)
		add_rainbow(tracer, tracer->scene->rainbows[i], ray, distance, &sum);
	if (!sum.count)
		return seen;
	Rgb left = rgb_scale(sum.left, 1.0f / (float)sum.count);
	seen.color = rgb_mad(rgb_mul(seen.color, left), 1.0f / (float)sum.count, sum.light);
	seen.transmit *= mean(left);
	return seen;
}

Seen atmosphere_apply(Tracer *tracer, const Ray *ray, double distance, Seen seen)
{
	const Scene *scene = tracer->scene;
	double length = fmin(distance, FAR_AWAY);
	seen = rainbows_apply(tracer, ray, length, seen);
	FogSum sum = sum_fogs(scene, ray, length);
	return (Seen){
		.color = rgb_add(rgb_mul(seen.color, sum.left), sum.light),
		.caustic = rgb_mul(seen.caustic, sum.left),
		.transmit = seen.transmit * mean(sum.left),
	};
}
