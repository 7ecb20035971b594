/*
 * Finish by finish as POV-Ray 3.7's manual, section 3.4.6.3, defines them. Highlights are phong
 * (mirrored ray against light) and Blinn's half vector with the exponent 1/roughness; both, unlike
 * the diffuse part, are not weakened by a layer's transparency.
 *
 * Sampling: smooth directions come from the cosine about the normal, mixed with nothing else;
 * narrow highlights are rare for photons and too small to matter there.
 */
#include "surface/bsdf.h"

#include <math.h>

#include "surface/bsdf_layer.h"
#include "surface/noise.h"

static const double PI = 3.14159265358979323846;

/* ---- physics ---- */

double bsdf_fresnel(double cosine, double ior)
{
	Refraction at = refraction_of(cosine, ior);
	return refraction_mirrored(&at);
}

bool bsdf_refract(Vec3 direction, Vec3 normal, double ior, Vec3 *out)
{
	Refraction at = refraction_of(-vec3_dot(direction, normal), ior);
	if (at.inner2 < 0)
		return false;
	*out = refraction_direction(&at, direction, normal);
	return true;
}

/* How far a metal's own colour gives way to white towards grazing light: the curve that POV-Ray's
 * `metallic` uses, an approximation of Fresnel's (Schlick's fit for conductors); 0 head on, 1
 * grazing. */
static double metal_grazing(double cosine)
{
	double x = acos(fmin(fmax(cosine, -1), 1)) / (PI / 2);
	double f = 0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903;
	return fmin(fmax(f, 0), 1);
}

Rgb bsdf_metal_tint(Rgb color, double metallic, double cosine)
{
	float share = (float)(metallic * (1 - metal_grazing(cosine)));
	return rgb(1 + share * (color.r - 1), 1 + share * (color.g - 1), 1 + share * (color.b - 1));
}

/* ---- preparing ---- */

static Rgb layer_mirror(const ShadingLayer *layer, Vec3 from, double ior)
{
	double cosine = real_min(real_max(vec3_dot(from, layer->normal), 0), 1);
	Refraction at = refraction_of(cosine, ior);
	return bsdf_finish_mirror(layer->finish, &layer->color, &at);
}

/* Under 0 it subtracts: scenes use that. Scenes before version 3.7 count a filter by its brightest
 * part; measured. */
static float layer_opacity(Rgbft color, bool legacy)
{
	return 1 - color.filter * (legacy ? rgb_max(rgbft_rgb(color)) : 1) - color.transmit;
}

/* Turbulence makes the film thicker and thinner. Its five octaves add up to less than 2; fitted to
 * POV-Ray's images. */
static float film_thickness(const Finish *finish, Vec3 world)
{
	if (finish->irid.turbulence == 0)
		return finish->irid.thickness;
	Turbulence turbulence = turbulence_default();
	turbulence.octaves = 5;
	double noise = turbulence_value(world, &turbulence, NOISE_GENERATOR_DEFAULT);
	return (float)(finish->irid.thickness * (1 + (2 * noise - 1) * finish->irid.turbulence));
}

/* A normal that bumps turned away from the viewer is still taken as it is: POV-Ray does. */
static void init_layer(Bsdf *bsdf, const ShadingLayer *from, const BsdfPlace *place)
{
	BsdfLayer *layer = &bsdf->layers[bsdf->count++];
	layer->finish = from->finish;
	layer->normal = from->normal;
	layer->color = rgbft_rgb(from->color);
	layer->above = bsdf->through;
	layer->opacity = layer_opacity(from->color, place->legacy);
	layer->grain = (float)(from->finish->crand * place->grain);
	layer->film = from->finish->irid.amount > 0 ? film_thickness(from->finish, place->world)
						    : 0;
	layer->mirror = layer_mirror(from, place->from, place->mirror_ior);
	bsdf->through = rgb_mul(bsdf->through, bsdf_finish_through(from->finish, &from->color,
								   layer->mirror));
}

void bsdf_init(Bsdf *bsdf, const ShadingLayer *bottom_to_top, int count, const BsdfPlace *place)
{
	bsdf->count = 0;
	bsdf->from = place->from;
	bsdf->geometric = place->geometric;
	bsdf->ior = place->ior;
	bsdf->both_sides = place->both_sides;
	bsdf->irid_wavelength = place->irid_wavelength;
	bsdf->through = rgb_all(1);
	for (int i = count - 1; i >= 0 && bsdf->count < BSDF_MAX_LAYERS; i--) {
		Rgb left = bsdf->through; /* negative shares count as well */
		if (fabsf(left.r) <= place->cutoff && fabsf(left.g) <= place->cutoff &&
		    fabsf(left.b) <= place->cutoff)
			break;
		init_layer(bsdf, &bottom_to_top[i], place);
	}
}

/* ---- smooth lobes ---- */

Rgb bsdf_emission(const Bsdf *bsdf, Rgb ambient_light)
{
	Rgb sum = {0, 0, 0};
	for (int i = 0; i < bsdf->count; i++) {
		const BsdfLayer *layer = &bsdf->layers[i];
		Rgb own = rgb_add(rgb_mul(layer->finish->ambient, ambient_light),
				  layer->finish->emission);
		if (rgb_is_black(own))
			continue;
		own = rgb_scale(rgb_mul(own, layer->color), layer->opacity);
		sum = rgb_add(sum, rgb_mul(own, layer->above));
	}
	return sum;
}

/* Light through a film: two ways that differ by the film's thickness times the cosines interfere at
 * each wavelength. Thickness and wavelengths in one unit; the formula was fitted to POV-Ray 3.7's
 * images, where only diffuse light takes part. */
static Rgb irid_tint(const Bsdf *bsdf, const BsdfLayer *layer, double light_cosine)
{
	double eye_cosine = vec3_dot(layer->normal, bsdf->from);
	double path = 2 * PI * layer->film * (light_cosine + eye_cosine);
	float amount = layer->finish->irid.amount;
	Rgb wave = bsdf->irid_wavelength;
	return rgb(1 + amount * (float)cos(path / wave.r), 1 + amount * (float)cos(path / wave.g),
	           1 + amount * (float)cos(path / wave.b));
}

static Rgb diffuse_lobe(const Bsdf *bsdf, const BsdfLayer *layer, double cosine)
{
	const Finish *finish = layer->finish;
	float amount = finish->diffuse;
	if (cosine < 0 && !bsdf->both_sides)
		amount = finish->diffuse_back;
	else if (bsdf->both_sides && finish->diffuse_back != 0 && cosine < 0)
		amount = fmaxf(amount, finish->diffuse_back);
	if (finish->diffuse_albedo)
		amount *= (finish->brilliance + 1) / 2;
	double shape = finish->brilliance == 1 ? fabs(cosine)
					       : pow(fabs(cosine), finish->brilliance);
	float strength = (float)shape * amount * layer->opacity - layer->grain;
	Rgb color = rgb_scale(rgb_mul(layer->color, layer->above), strength);
	return finish->irid.amount > 0 ? rgb_mul(color, irid_tint(bsdf, layer, cosine)) : color;
}

/* The factors that make an albedo highlight reflect the amount given in all. */
static double phong_amount(const Finish *finish)
{
	return finish->phong * (finish->phong_albedo ? (finish->phong_size + 1) / 2 : 1);
}

static double specular_amount(const Finish *finish)
{
	double exponent = 1 / finish->roughness;
	return finish->specular *
		(finish->specular_albedo ? (exponent + 2) / (4 * (2 - pow(2, -exponent / 2))) : 1);
}

static Rgb highlight_color(const BsdfLayer *layer, double strength, double light_cosine)
{
	Rgb tint = rgb_all(1);
	if (layer->finish->metallic != 0)
		tint = bsdf_metal_tint(layer->color, layer->finish->metallic, light_cosine);
	return rgb_scale(rgb_mul(tint, layer->above), (float)strength);
}

static Rgb phong_lobe(const Bsdf *bsdf, const BsdfLayer *layer, Vec3 to)
{
	Vec3 mirrored = vec3_reflect(vec3_neg(bsdf->from), layer->normal);
	double cosine = vec3_dot(mirrored, to);
	if (cosine <= 0)
		return rgb_all(0);
	double strength = phong_amount(layer->finish) * pow(cosine, layer->finish->phong_size);
	return highlight_color(layer, strength, vec3_dot(layer->normal, to));
}

static Rgb specular_lobe(const Bsdf *bsdf, const BsdfLayer *layer, Vec3 to)
{
	double cosine = vec3_dot(vec3_normalize(vec3_add(to, bsdf->from)), layer->normal);
	if (cosine <= 0)
		return rgb_all(0);
	double strength = specular_amount(layer->finish) *
			  pow(cosine, 1 / layer->finish->roughness);
	return highlight_color(layer, strength, vec3_dot(layer->normal, to));
}

static Rgb layer_eval(const Bsdf *bsdf, const BsdfLayer *layer, Vec3 to, bool highlights)
{
	const Finish *finish = layer->finish;
	double cosine = vec3_dot(layer->normal, to);
	Rgb sum = {0, 0, 0};
	if (cosine <= 0 && !bsdf->both_sides && finish->diffuse_back == 0)
		return sum;
	if (highlights && finish->phong > 0)
		sum = rgb_add(sum, phong_lobe(bsdf, layer, to));
	if (highlights && finish->specular > 0)
		sum = rgb_add(sum, specular_lobe(bsdf, layer, to));
	if (finish->diffuse != 0 || finish->diffuse_back != 0)
		sum = rgb_add(sum, diffuse_lobe(bsdf, layer, cosine));
	return sum;
}

Rgb bsdf_eval(const Bsdf *bsdf, Vec3 to, bool highlights)
{
	Rgb sum = {0, 0, 0};
	for (int i = 0; i < bsdf->count; i++)
		sum = rgb_add(sum, layer_eval(bsdf, &bsdf->layers[i], to, highlights));
	return sum;
}

bool bsdf_is_delta(const Bsdf *bsdf)
{
	for (int i = 0; i < bsdf->count; i++)
		if (!bsdf_finish_is_delta(bsdf->layers[i].finish))
			return false;
	return true;
}

bool bsdf_sees_back(const Bsdf *bsdf)
{
	if (bsdf->both_sides)
		return true;
	for (int i = 0; i < bsdf->count; i++)
		if (bsdf->layers[i].finish->diffuse_back != 0)
			return true;
	return false;
}

/* ---- mirrors and the passage through ---- */

/* What events are made of besides their weights. */
typedef struct EventPlace {
	Vec3 from, geometric;
	double ior;
} EventPlace;

/* A mirrored direction that bumps sent into the surface is mirrored out of it again. */
static Vec3 mirror_direction(const EventPlace *place, Vec3 normal)
{
	Vec3 incoming = vec3_neg(place->from);
	Vec3 out = vec3_reflect(incoming, normal);
	if (vec3_dot(out, place->geometric) >= 0)
		return out;
	if (vec3_dot(out, normal) < 0)
		out = vec3_reflect(incoming, place->geometric);
	else
		out = vec3_reflect(out, place->geometric);
	return vec3_normalize(out);
}

static void passage(const EventPlace *place, Vec3 normal, Rgb through, BsdfEvent *event)
{
	*event = (BsdfEvent){.kind = BSDF_TRANSMIT,
			     .weight = through,
			     .exponent = 1,
			     .to = vec3_neg(place->from)};
	if (!refraction_bends(place->ior))
		return;
	event->bent = true;
	/* A normal that bumps turned away from the viewer counts from its other side. */
	if (vec3_dot(normal, place->from) < 0)
		normal = vec3_neg(normal);
	event->total = !bsdf_refract(event->to, normal, place->ior, &event->to);
	if (event->total) { /* all of the light, whatever colour the surface filters with */
		event->to = mirror_direction(place, normal);
		event->weight = rgb_all(1);
	}
}

static void mirror(const EventPlace *place, Vec3 normal, Rgb weight, const Finish *finish,
		   BsdfEvent *event)
{
	*event = (BsdfEvent){
		.kind = BSDF_REFLECT,
		.weight = weight,
		.exponent = finish->reflection.exponent,
		.to = mirror_direction(place, normal),
	};
}

/* POV-Ray leaves out the change of radiance with the square of the index, in both directions: a
 * passage is the same for either transport. */
int bsdf_events(const Bsdf *bsdf, Transport transport, BsdfEvent out[BSDF_MAX_EVENTS])
{
	EventPlace place = {bsdf->from, bsdf->geometric, bsdf->ior};
	int count = 0;
	(void)transport;
	if (bsdf->count && !rgb_is_black(bsdf->through))
		passage(&place, bsdf->layers[0].normal, bsdf->through, &out[count++]);
	for (int i = 0; i < bsdf->count; i++) {
		const BsdfLayer *layer = &bsdf->layers[i];
		/* Total reflection is this mirror already. */
		bool same = count && out[0].total &&
			    vec3_distance(layer->normal, bsdf->layers[0].normal) < 1e-9;
		if (!rgb_is_black(layer->mirror) && !same)
			mirror(&place, layer->normal, layer->mirror, layer->finish, &out[count++]);
	}
	return count;
}

/* ---- sampling ---- */

/* The share of light that the diffuse lobes send on, as a guide for choosing. */
static Rgb diffuse_albedo(const Bsdf *bsdf)
{
	Rgb sum = {0, 0, 0};
	for (int i = 0; i < bsdf->count; i++) {
		const BsdfLayer *layer = &bsdf->layers[i];
		float share = layer->finish->diffuse * layer->opacity * 2 /
			      (layer->finish->brilliance + 1);
		sum = rgb_add(sum, rgb_scale(rgb_mul(layer->color, layer->above), share));
	}
	return sum;
}

double bsdf_pdf(const Bsdf *bsdf, Vec3 to)
{
	double cosine = vec3_dot(bsdf->geometric, to);
	return cosine > 0 ? cosine / PI : 0;
}

static Vec3 cosine_direction(Vec3 normal, double a, double b)
{
	Vec3 u, v;
	vec3_frame(normal, &u, &v);
	double radius = sqrt(a), turn = 2 * PI * b;
	Vec3 flat = vec3_add(vec3_scale(u, radius * cos(turn)), vec3_scale(v, radius * sin(turn)));
	return vec3_mad(flat, sqrt(fmax(1 - a, 0)), normal);
}

static double mean(Rgb color)
{
	return ((double)color.r + color.g + color.b) / 3;
}

/* The smooth direction's weight: eval / pi is f cos, over the density cos / pi and the chance of
 * the choice. */
static BsdfEvent smooth_event(const Bsdf *bsdf, const double u[3], double chance)
{
	BsdfEvent event = {.kind = BSDF_SMOOTH,
			   .exponent = 1,
			   .to = cosine_direction(bsdf->geometric, u[1], u[2])};
	double cosine = fmax(vec3_dot(event.to, bsdf->geometric), 1e-9);
	event.weight = rgb_scale(bsdf_eval(bsdf, event.to, true), (float)(1 / (cosine * chance)));
	return event;
}

bool bsdf_sample(const Bsdf *bsdf, const double u[3], Transport transport, BsdfEvent *out)
{
	BsdfEvent events[BSDF_MAX_EVENTS];
	int count = bsdf_events(bsdf, transport, events);
	double smooth = mean(diffuse_albedo(bsdf)), total = smooth;
	for (int i = 0; i < count; i++)
		total += mean(events[i].weight);
	double scale = total > 1 ? 1 / total : 1, at = u[0];
	for (int i = 0; i < count; i++) {
		double chance = mean(events[i].weight) * scale;
		if (at < chance) {
			*out = events[i];
			out->weight = rgb_scale(out->weight, (float)(1 / chance));
			return true;
		}
		at -= chance;
	}
	if (at >= smooth * scale)
		return false;
	*out = smooth_event(bsdf, u, smooth * scale);
	return true;
}
