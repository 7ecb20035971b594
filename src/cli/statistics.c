#include "cli/statistics.h"

#include <inttypes.h>

#include "base/clock.h"
#include "base/output_file.h"
#include "base/parallel.h"
#include "config.h"

void statistics_add(FrameStatistics *sum, const FrameStatistics *frame)
{
	sum->frames += frame->frames;
	sum->parse_seconds += frame->parse_seconds;
	sum->build_seconds += frame->build_seconds;
	sum->trace_seconds += frame->trace_seconds;
	sum->write_seconds += frame->write_seconds;
	sum->cpu_seconds += frame->cpu_seconds;
	sum->shapes = frame->shapes;
	sum->lights = frame->lights;
	pass_statistics_add(&sum->passes, &frame->passes);
}

static uint64_t all_rays(const RenderStatistics *r)
{
	return r->eye_rays + r->shadow_rays + r->reflected_rays + r->refracted_rays +
	       r->transmitted_rays;
}

static double seconds_per_iteration(const RelaxStatistics *r)
{
	return r->iterations ? r->seconds / (double)r->iterations : 0;
}

static void print_relaxation(FILE *out, const RelaxStatistics *r)
{
	fprintf(out, "%-18s%14.3f s = %.3f features + %" PRIu64 " iterations of %.3f\n",
		"relaxation", r->feature_seconds + r->seconds, r->feature_seconds, r->iterations,
		seconds_per_iteration(r));
}

static void print_photons(FILE *out, const PassStatistics *s)
{
	const PhotonStatistics *p = &s->photons;
	const struct { const char *name; uint64_t value; } rows[] = {
		{"passes", s->passes}, {"photon paths", p->paths}, {"photons stored", p->stored},
		{"paths absorbed", p->absorbed}, {"paths escaped", p->escaped},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		fprintf(out, "%-18s%14" PRIu64 "\n", rows[i].name, rows[i].value);
	fprintf(out, "%-18s%14.3f s\n", "photons", p->seconds);
	if (s->relaxation.iterations > 0)
		print_relaxation(out, &s->relaxation);
	fprintf(out, "%-18s%14.3f s\n", "photon tree", s->caustics.index);
	fprintf(out, "%-18s%14.3f s\n", "estimators", s->caustics.estimators);
	fprintf(out, "%-18s%14.6g in = %.6g stored + %.6g absorbed + %.6g escaped\n", "flux",
		p->emitted_flux, p->stored_flux, p->absorbed_flux, p->escaped_flux);
}

void statistics_print(FILE *out, const FrameStatistics *s)
{
	const RenderStatistics *r = &s->passes.render;
	const struct { const char *name; uint64_t value; } rows[] = {
		{"pixels", r->pixels}, {"samples", r->samples}, {"eye rays", r->eye_rays},
		{"shadow rays", r->shadow_rays}, {"reflected rays", r->reflected_rays},
		{"refracted rays", r->refracted_rays}, {"transmitted rays", r->transmitted_rays},
	};
	if (s->frames > 1)
		fprintf(out, "%-18s%14d\n", "frames", s->frames);
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		fprintf(out, "%-18s%14" PRIu64 "\n", rows[i].name, rows[i].value);
	if (s->passes.has_photons)
		print_photons(out, &s->passes);
	fprintf(out, "%-18s%14.3f s\n", "parse", s->parse_seconds);
	fprintf(out, "%-18s%14.3f s\n", "build", s->build_seconds);
	fprintf(out, "%-18s%14.3f s\n", "trace", s->trace_seconds);
	fprintf(out, "%-18s%14.1f MB\n", "peak memory", (double)clock_peak_memory() / 1e6);
}

static void write_json_text(FILE *out, const char *text)
{
	putc('"', out);
	for (; *text; text++) {
		unsigned char c = (unsigned char)*text;
		if (c == '"' || c == '\\')
			fprintf(out, "\\%c", c);
		else if (c < 32)
			fprintf(out, "\\u%04x", c);
		else
			putc(c, out);
	}
	putc('"', out);
}

static void write_rays(FILE *out, const RenderStatistics *r)
{
	fprintf(out,
		"  \"rays\": {\"all\": %" PRIu64 ", \"eye\": %" PRIu64 ", \"shadow\": %" PRIu64
		", \"reflected\": %" PRIu64 ", \"refracted\": %" PRIu64
		", \"transmitted\": %" PRIu64 "},\n",
		all_rays(r), r->eye_rays, r->shadow_rays, r->reflected_rays, r->refracted_rays,
		r->transmitted_rays);
}

static void write_relaxation(FILE *out, const RelaxStatistics *r)
{
	fprintf(out,
		"    \"relaxation\": {\"moved\": %" PRIu64 ", \"iterations\": %" PRIu64
		", \"feature_seconds\": %.6f, \"iteration_seconds\": %.6f,\n",
		r->moved, r->iterations, r->feature_seconds, r->seconds);
	fprintf(out,
		"      \"seconds_per_iteration\": %.6f, \"mean_movement\": %.9g, "
		"\"mean_freedom\": %.6f},\n",
		seconds_per_iteration(r), r->mean_movement, r->mean_constraint);
}

static void write_photons(FILE *out, const PassStatistics *s)
{
	const PhotonStatistics *p = &s->photons;
	fprintf(out,
		"  \"photons\": {\"passes\": %" PRIu32 ", \"paths\": %" PRIu64
		", \"stored\": %" PRIu64 ", \"absorbed\": %" PRIu64 ", \"escaped\": %" PRIu64
		", \"segments\": %" PRIu64 ",\n",
		s->passes, p->paths, p->stored, p->absorbed, p->escaped, p->segments);
	fprintf(out,
		"    \"seconds\": %.6f, \"processor\": %.6f, \"first_radius\": %.9g, "
		"\"radius\": %.9g,\n",
		p->seconds, p->cpu_seconds, s->first_radius, s->radius);
	fprintf(out, "    \"tree_seconds\": %.6f, \"estimator_seconds\": %.6f,\n",
		s->caustics.index, s->caustics.estimators);
	if (s->relaxation.iterations > 0)
		write_relaxation(out, &s->relaxation);
	fprintf(out,
		"    \"flux\": {\"emitted\": %.9g, \"stored\": %.9g, \"absorbed\": %.9g, "
		"\"escaped\": %.9g}},\n",
		p->emitted_flux, p->stored_flux, p->absorbed_flux, p->escaped_flux);
}

bool statistics_write_json(const FrameStatistics *s, const char *scene, const char *status,
			   const char *path, Diag *diag)
{
	OutputFile file;
	if (!output_file_open(&file, path, diag))
		return false;
	fputs("{\n  \"program\": \"" PACKAGE_STRING "\",\n  \"scene\": ", file.stream);
	write_json_text(file.stream, scene);
	fprintf(file.stream, ",\n  \"status\": \"%s\",\n  \"frames\": %d,\n  \"threads\": %d,\n",
		status, s->frames, parallel_threads());
	fprintf(file.stream,
		"  \"seconds\": {\"parse\": %.6f, \"build\": %.6f, \"trace\": %.6f, "
		"\"write\": %.6f, \"processor\": %.6f},\n",
		s->parse_seconds, s->build_seconds, s->trace_seconds, s->write_seconds,
		s->cpu_seconds);
	fprintf(file.stream, "  \"pixels\": %" PRIu64 ",\n  \"samples\": %" PRIu64 ",\n",
		s->passes.render.pixels, s->passes.render.samples);
	write_rays(file.stream, &s->passes.render);
	if (s->passes.has_photons)
		write_photons(file.stream, &s->passes);
	fprintf(file.stream, "  \"deepest\": %d,\n  \"shapes\": %ld,\n  \"lights\": %ld,\n",
		s->passes.render.deepest, s->shapes, s->lights);
	fprintf(file.stream, "  \"peak_memory\": %zu\n}\n", clock_peak_memory());
	return output_file_commit(&file, diag);
}
