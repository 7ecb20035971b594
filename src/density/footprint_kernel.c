#include "density/footprint_kernel.h"

#include <math.h>

#include "density/kernel.h"

/* ---- values ---- */

static double round_value(double a, double b)
{
	return kernel_value(KERNEL_EPANECHNIKOV, a * a + b * b);
}

/* The kernel and its mirror images: in one border, in each of two, and in both. */
static double mirrored_value(const FootprintCut *cuts, int count, double a, double b)
{
	double value = round_value(a, b), beyond[MOST_BORDERS] = {0};
	for (int i = 0; i < count; i++) {
		beyond[i] = cuts[i].distance - (cuts[i].a * a + cuts[i].b * b);
		if (!(beyond[i] > 0))
			return 0;
		value += round_value(a + 2 * beyond[i] * cuts[i].a, b + 2 * beyond[i] * cuts[i].b);
	}
	if (count == 2) {
		a += 2 * beyond[0] * cuts[0].a;
		b += 2 * beyond[0] * cuts[0].b;
		double over = 2 * (cuts[1].distance - (cuts[1].a * a + cuts[1].b * b));
		value += round_value(a + over * cuts[1].a, b + over * cuts[1].b);
	}
	return value;
}

/* A cut where the axes are longer: stretch is their old length over the new. */
static FootprintCut widen_cut(FootprintCut cut, double stretch_a, double stretch_b)
{
	double a = cut.a / stretch_a, b = cut.b / stretch_b, length = sqrt(a * a + b * b);
	return (FootprintCut){(float)(a / length), (float)(b / length),
	                      (float)(cut.distance / length)};
}

double footprint_value(const Footprint *f, const float x[3], double pixel2, double *radius)
{
	double a = f->a[0] * x[0] + f->a[1] * x[1] + f->a[2] * x[2];
	double b = f->b[0] * x[0] + f->b[1] * x[1] + f->b[2] * x[2];
	double least2 = f->least * f->least + pixel2, most2 = f->most * f->most + pixel2;
	if (!(a * a * f->least * f->least / least2 + b * b * f->most * f->most / most2 < 1))
		return 0;
	double least = sqrt(least2), most = sqrt(most2);
	double stretch_a = f->least / least, stretch_b = f->most / most;
	a *= stretch_a;
	b *= stretch_b;
	*radius = most;
	if (f->cuts == 0)
		return round_value(a, b) / (least * most);
	FootprintCut cuts[MOST_BORDERS];
	for (int i = 0; i < f->cuts; i++)
		cuts[i] = widen_cut(f->cut[i], stretch_a, stretch_b);
	return mirrored_value(cuts, f->cuts, a, b) / (f->share * least * most);
}

/* ---- making ---- */

/* What is left of the kernel: of one cut all, as its mirror image brings back what it takes. */
static double share_left(const FootprintCut *cuts, int count)
{
	enum { SIDE = 16 };
	double sum = 0;
	if (count < 2)
		return 1;
	for (int i = 0; i < SIDE * SIDE; i++) {
		double a = 2 * (i % SIDE + 0.5) / SIDE - 1, b = 2 * (i / SIDE + 0.5) / SIDE - 1;
		if (a * a + b * b < 1)
			sum += mirrored_value(cuts, count, a, b);
	}
	return sum * 4 / (SIDE * SIDE);
}

typedef struct Axes {
	double least, most;           /* lengths */
	double across[2], along[2];   /* unit: of the shorter, of the longer one */
} Axes;

static Axes axes_of(Symmetric c, double least_variance)
{
	double mean = 0.5 * (c.uu + c.vv), difference = 0.5 * (c.uu - c.vv);
	double spread = sqrt(difference * difference + c.uv * c.uv);
	double angle = 0.5 * atan2(c.uv, difference);
	double most = fmax(mean + spread, least_variance);
	double least = fmax(mean - spread, fmax(least_variance, 1e-6 * most));
	return (Axes){sqrt(least / footprint_variance), sqrt(most / footprint_variance),
	              {-sin(angle), cos(angle)}, {cos(angle), sin(angle)}};
}

/* In the ellipse's coordinates, where it is the unit disc. */
static void into_disc(const Axes *axes, const double x[2], double out[2])
{
	out[0] = (axes->across[0] * x[0] + axes->across[1] * x[1]) / axes->least;
	out[1] = (axes->along[0] * x[0] + axes->along[1] * x[1]) / axes->most;
}

/* False: the border passes the ellipse. */
static bool make_cut(const FootprintShape *shape, int i, const Axes *axes, FootprintCut *cut)
{
	double point[2], line[2], side[2];
	const double from[2] = {shape->point[i][0] - shape->center[0],
	                        shape->point[i][1] - shape->center[1]};
	into_disc(axes, from, point);
	into_disc(axes, shape->along[i], line);
	into_disc(axes, shape->out[i], side);
	double length = hypot(line[0], line[1]), a = line[1] / length, b = -line[0] / length;
	double sign = a * side[0] + b * side[1] < 0 ? -1 : 1;
	double distance = fmax(0, sign * (a * point[0] + b * point[1]));
	*cut = (FootprintCut){(float)(sign * a), (float)(sign * b), (float)distance};
	return length > 0.1 && distance < 1;
}

static void to_floats(Vec3 v, double scale, float out[3])
{
	out[0] = (float)(scale * v.x);
	out[1] = (float)(scale * v.y);
	out[2] = (float)(scale * v.z);
}

static Vec3 in_plane(const FootprintPlane *plane, const double x[2])
{
	return vec3_mad(vec3_scale(plane->u, x[0]), x[1], plane->v);
}

Footprint footprint_make(const FootprintShape *shape, Vec3 photon, const FootprintPlane *plane,
                         double least_variance)
{
	Axes axes = axes_of(shape->covariance, least_variance);
	Footprint f = {.least = (float)axes.least, .most = (float)axes.most};
	to_floats(vec3_add(photon, in_plane(plane, shape->center)), 1, f.at);
	to_floats(in_plane(plane, axes.across), 1 / axes.least, f.a);
	to_floats(in_plane(plane, axes.along), 1 / axes.most, f.b);
	for (int i = 0; i < shape->borders; i++)
		f.cuts += make_cut(shape, i, &axes, &f.cut[f.cuts]);
	f.share = (float)share_left(f.cut, f.cuts);
	if (f.share < 0.05f) {
		f.share = 1;
		f.cuts = 0;
	}
	return f;
}

Box3 footprint_box(const Footprint *f, Vec3 normal)
{
	double a2 = pow(f->least, 4), b2 = pow(f->most, 4);
	double extent[3], n[3] = {normal.x, normal.y, normal.z};
	for (int k = 0; k < 3; k++)
		extent[k] = sqrt(a2 * f->a[k] * f->a[k] + b2 * f->b[k] * f->b[k]) +
		            0.25 * f->most * fabs(n[k]);
	Vec3 at = vec3(f->at[0], f->at[1], f->at[2]);
	Vec3 e = vec3(extent[0], extent[1], extent[2]);
	return (Box3){vec3_sub(at, e), vec3_add(at, e)};
}
