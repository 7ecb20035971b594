/* The scattering interface: density integrates to one, no more light than comes, events against
 * Fresnel and Snell. */
#include "surface/bsdf_layer.h"

#include "base/random.h"

#include "check.h"

static const double PI = 3.14159265358979323846;
static const double TURN = 6.28318530717958647692;

static Finish finish_of(float diffuse)
{
	Finish finish = {.diffuse = diffuse, .brilliance = 1, .phong_size = 40, .roughness = 0.05f};
	finish.reflection.exponent = finish.reflection.falloff = 1;
	return finish;
}

static Bsdf bsdf_of(const ShadingLayer *layers, int count, Vec3 from, double ior)
{
	BsdfPlace place = {
		.from = vec3_normalize(from),
		.geometric = {0, 0, 1},
		.ior = ior,
		.mirror_ior = ior,
		.irid_wavelength = {0.25f, 0.18f, 0.14f},
	};
	Bsdf bsdf;
	bsdf_init(&bsdf, layers, count, &place);
	return bsdf;
}

static Vec3 sphere_direction(uint64_t i)
{
	double z = 2 * random_uniform(1, i, 0) - 1, turn = TURN * random_uniform(1, i, 1),
	       radius = sqrt(1 - z * z);
	return vec3(radius * cos(turn), radius * sin(turn), z);
}

static void check_pdf(void)
{
	Finish finish = finish_of(0.8f);
	ShadingLayer layer = {{1, 1, 1, 0, 0}, {0, 0, 1}, &finish};
	Bsdf bsdf = bsdf_of(&layer, 1, vec3(0.3, 0, 1), 1);
	double sum = 0;
	const uint64_t count = 200000;
	for (uint64_t i = 0; i < count; i++)
		sum += bsdf_pdf(&bsdf, sphere_direction(i));
	/* Standard deviation of the mean: 4 pi sqrt(1/6 - 1/16) / pi / sqrt(count) / ... under
	 * 0.003. */
	CHECK_NEAR(sum / (double)count * 4 * PI, 1, 0.012);
}

/* The mean weight of sampled ways on is the albedo: at most 1 for finishes that keep their sums. */
static double sampled_albedo(const Bsdf *bsdf)
{
	double sum = 0;
	const uint64_t count = 100000;
	for (uint64_t i = 0; i < count; i++) {
		double u[3] = {random_uniform(2, i, 0), random_uniform(2, i, 1),
			       random_uniform(2, i, 2)};
		BsdfEvent event;
		if (bsdf_sample(bsdf, u, TRANSPORT_FLUX, &event))
			sum += event.weight.g;
	}
	return sum / (double)count;
}

static void check_energy(void)
{
	Finish finish = finish_of(0.8f);
	ShadingLayer layer = {{1, 0.5f, 1, 0, 0}, {0, 0, 1}, &finish};
	Bsdf bsdf = bsdf_of(&layer, 1, vec3(0.3, 0, 1), 1);
	CHECK_NEAR(sampled_albedo(&bsdf), 0.4, 0.01);
	layer.color = rgbft(1, 1, 1, 0.3f, 0.2f);
	bsdf = bsdf_of(&layer, 1, vec3(0.3, 0, 1), 1 / 1.5);
	CHECK_NEAR(sampled_albedo(&bsdf), 0.8 * 0.5 + 0.5, 0.01);
	finish.reflection.min = finish.reflection.max = rgb_all(0.25f);
	finish.conserve_energy = true;
	bsdf = bsdf_of(&layer, 1, vec3(0.3, 0, 1), 1 / 1.5);
	double albedo = sampled_albedo(&bsdf);
	CHECK_NEAR(albedo, 0.8 * 0.5 + 0.5 * 0.75 + 0.25, 0.02);
}

/* A brilliant lobe: integral of cos^b over the hemisphere is 2 pi / (b + 1), in eval's units 2 / (b
 * + 1). */
static void check_brilliance(void)
{
	Finish finish = finish_of(0.6f);
	finish.brilliance = 4;
	ShadingLayer layer = {{1, 1, 1, 0, 0}, {0, 0, 1}, &finish};
	Bsdf bsdf = bsdf_of(&layer, 1, vec3(0, 0, 1), 1);
	CHECK_NEAR(sampled_albedo(&bsdf), 0.6 * 2 / 5, 0.005);
	finish.diffuse_albedo = true;
	bsdf = bsdf_of(&layer, 1, vec3(0, 0, 1), 1);
	CHECK_NEAR(sampled_albedo(&bsdf), 0.6, 0.01);
}

/* Diffuse light goes both ways alike: exchanging the directions of a flat surface changes eval by
 * the cosines alone. */
static void check_reciprocity(void)
{
	Finish finish = finish_of(0.7f);
	ShadingLayer layer = {{0.9f, 0.5f, 0.2f, 0, 0}, {0, 0, 1}, &finish};
	for (uint64_t i = 0; i < 100; i++) {
		Vec3 a = sphere_direction(2 * i), b = sphere_direction(2 * i + 1);
		a.z = fabs(a.z) + 1e-3;
		b.z = fabs(b.z) + 1e-3;
		a = vec3_normalize(a);
		b = vec3_normalize(b);
		Bsdf forth = bsdf_of(&layer, 1, a, 1), back = bsdf_of(&layer, 1, b, 1);
		CHECK_NEAR(bsdf_eval(&forth, b, true).r / b.z, bsdf_eval(&back, a, true).r / a.z,
			   1e-5);
	}
}

static void check_fresnel_slab(void)
{
	Finish finish = finish_of(0);
	finish.reflection.max = rgb_all(1);
	finish.reflection.fresnel = finish.conserve_energy = true;
	ShadingLayer layer = {{1, 1, 1, 1, 0}, {0, 0, 1}, &finish};
	Vec3 from = vec3(sin(0.7), 0, cos(0.7));
	Bsdf bsdf = bsdf_of(&layer, 1, from, 1 / 1.5);
	BsdfEvent events[BSDF_MAX_EVENTS];
	CHECK(bsdf_events(&bsdf, TRANSPORT_RADIANCE, events) == 2);
	double inner = asin(sin(0.7) / 1.5);
	double s = sin(0.7 - inner) / sin(0.7 + inner), p = tan(0.7 - inner) / tan(0.7 + inner);
	double reflectance = (s * s + p * p) / 2;
	CHECK(events[0].kind == BSDF_TRANSMIT && events[1].kind == BSDF_REFLECT);
	CHECK_NEAR(events[0].weight.r, 1 - reflectance, 1e-6);
	CHECK_NEAR(events[1].weight.r, reflectance, 1e-6);
	CHECK_NEAR(events[0].to.x, -sin(inner), 1e-12);
	CHECK_NEAR(events[0].to.z, -cos(inner), 1e-12);
	CHECK_NEAR(events[1].to.x, -from.x, 1e-12);
	CHECK_NEAR(bsdf_fresnel(1, 1 / 1.5), 0.04, 1e-12);
	/* From inside beyond the critical angle everything is reflected. */
	bsdf = bsdf_of(&layer, 1, vec3(sin(0.8), 0, cos(0.8)), 1.5);
	bsdf.through = rgb_all(1);
	CHECK(bsdf_events(&bsdf, TRANSPORT_RADIANCE, events) == 1);
	CHECK(events[0].total && events[0].to.z > 0);
	CHECK_NEAR(bsdf_fresnel(cos(0.8), 1.5), 1, 0);
}

/* The upper layer of two tints what the lower one does: 0.3 of its own, 0.46 of the lower's red. */
static void check_layers(void)
{
	Finish glowing = finish_of(0);
	glowing.emission = rgb_all(1);
	ShadingLayer layers[2] = {
		{{1, 0.5f, 0.2f, 0, 0}, {0, 0, 1}, &glowing},
		{{0.2f, 0.6f, 0.5f, 0.3f, 0.4f}, {0, 0, 1}, &glowing},
	};
	Bsdf bsdf = bsdf_of(layers, 2, vec3(0, 0, 1), 1);
	Rgb light = bsdf_emission(&bsdf, rgb_all(1));
	CHECK_NEAR(light.r, 0.52, 1e-5);
	CHECK_NEAR(light.g, 0.47, 1e-5);
	CHECK_NEAR(light.b, 0.26, 1e-5);
	CHECK(rgb_is_black(bsdf.through));
}

/* A film's turbulence changes its thickness from place to place; without it every place is the
 * same. */
static void check_film(void)
{
	Finish finish = finish_of(1);
	finish.irid.amount = 0.5f;
	finish.irid.thickness = 2;
	ShadingLayer layer = {{1, 1, 1, 0, 0}, {0, 0, 1}, &finish};
	BsdfPlace place = {.from = {0, 0, 1},
			   .geometric = {0, 0, 1},
			   .ior = 1,
			   .mirror_ior = 1,
			   .irid_wavelength = {0.25f, 0.18f, 0.14f}};
	float least = INFINITY, most = -INFINITY;
	for (int i = 0; i < 100; i++) {
		Bsdf bsdf;
		place.world = vec3(0.37 * i, 0.11 * i, 1.7);
		finish.irid.turbulence = 0;
		bsdf_init(&bsdf, &layer, 1, &place);
		CHECK(bsdf.layers[0].film == 2);
		finish.irid.turbulence = 0.25f;
		bsdf_init(&bsdf, &layer, 1, &place);
		least = fminf(least, bsdf.layers[0].film);
		most = fmaxf(most, bsdf.layers[0].film);
	}
	CHECK(least >= 1.5f && most <= 3.5f && most - least > 0.2f);
}

static bool events_agree(const BsdfEvent *a, const BsdfEvent *b)
{
	return a->kind == b->kind && a->total == b->total && a->bent == b->bent &&
	       vec3_distance(a->to, b->to) == 0 && a->weight.r == b->weight.r &&
	       a->weight.g == b->weight.g && a->weight.b == b->weight.b &&
	       a->exponent == b->exponent;
}

/* One layer asked by itself says what a stack of one says, bit for bit. */
static void check_layer_events(void)
{
	for (uint64_t i = 0; i < 2000; i++) {
		Finish finish = finish_of(i & 1 ? 0 : 0.4f);
		Vec3 from = sphere_direction(i);
		float share = (float)random_uniform(3, i, 0);
		finish.reflection.fresnel = i & 2;
		finish.conserve_energy = i & 4;
		finish.reflection.metallic = i & 8 ? 0.7f : 0;
		finish.reflection.max = i & 16 ? rgb(1, 0.8f, share) : rgb_all(0);
		ShadingLayer layer = {{0.9f, share, 0.5f, i & 32 ? 0.8f : 0, i & 64 ? 0.2f : 0},
				      {0, 0, 1}, &finish};
		double ior = i & 128 ? 1 : i & 256 ? 1.5 : 1 / 1.5;
		from.z = fabs(from.z);
		Bsdf bsdf = bsdf_of(&layer, 1, from, ior);
		BsdfEvent whole[BSDF_MAX_EVENTS], own[2];
		int count = bsdf_events(&bsdf, TRANSPORT_FLUX, whole);
		Refraction at = refraction_of(vec3_dot(bsdf.from, layer.normal), ior);
		bsdf_layer_events(&finish, &layer.color, &at, own);
		int same = 0;
		for (int k = 0; k < 2; k++) {
			if (rgb_is_black(own[k].weight))
				continue;
			own[k].to = bsdf_layer_direction(&own[k], &at, vec3_neg(bsdf.from),
							 layer.normal);
			CHECK(same < count && events_agree(&own[k], &whole[same]));
			same++;
		}
		CHECK(same == count);
		CHECK(bsdf_finish_is_delta(&finish) == bsdf_is_delta(&bsdf));
	}
}

int main(void)
{
	check_layer_events();
	check_film();
	check_pdf();
	check_energy();
	check_brilliance();
	check_reciprocity();
	check_fresnel_slab();
	check_layers();
	return CHECK_RESULT();
}
