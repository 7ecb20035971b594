#include "photon/trace.h"

#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/parallel.h"
#include "photon/path.h"

/* Paths are traced in chunks; each chunk has a buffer of its own, and buffers are joined in order.
 */
enum { CHUNK = 2048 };

typedef struct Chunk {
	const PhotonAim *aim;
	uint64_t first, count;
	PhotonBuffer buffer;
} Chunk;

typedef struct Job {
	const Scene *scene;
	const PhotonTraceOptions *options;
	Chunk *chunks;
	long count;
} Job;

static bool stopped(const PhotonTraceOptions *options)
{
	return options->stop && *options->stop;
}

static void trace_chunk(void *data, long item, int thread)
{
	(void)thread;
	Job *job = data;
	Chunk *chunk = &job->chunks[item];
	if (stopped(job->options))
		return;
	for (uint64_t i = 0; i < chunk->count; i++)
		photon_path(job->scene, chunk->aim, job->options, chunk->first + i, &chunk->buffer);
}

static void cut_chunks(Job *job, const PhotonAims *aims, Arena *arena)
{
	job->chunks = ARENA_ARRAY(arena, Chunk, aims->paths / CHUNK + (uint64_t)aims->count + 1);
	for (int a = 0; a < aims->count; a++) {
		const PhotonAim *aim = &aims->aims[a];
		for (uint64_t first = 0; first < aim->paths; first += CHUNK) {
			uint64_t left = aim->paths - first;
			job->chunks[job->count++] = (Chunk){
				.aim = aim, .first = first, .count = left < CHUNK ? left : CHUNK};
		}
	}
}

void photon_statistics_add(PhotonStatistics *sum, const PhotonStatistics *part)
{
	sum->paths += part->paths;
	sum->stored += part->stored;
	sum->absorbed += part->absorbed;
	sum->escaped += part->escaped;
	sum->segments += part->segments;
	sum->emitted_flux += part->emitted_flux;
	sum->stored_flux += part->stored_flux;
	sum->absorbed_flux += part->absorbed_flux;
	sum->escaped_flux += part->escaped_flux;
	sum->seconds += part->seconds;
	sum->cpu_seconds += part->cpu_seconds;
}

static PhotonMap *join_chunks(const Job *job, PhotonStatistics *statistics)
{
	PhotonMap *map = photon_map_create();
	uint64_t total = 0;
	for (long i = 0; i < job->count; i++)
		total += job->chunks[i].buffer.count;
	map->photons = memory_alloc(sizeof(Photon) * total);
	for (long i = 0; i < job->count; i++) {
		const PhotonBuffer *buffer = &job->chunks[i].buffer;
		if (buffer->count)
			memcpy(map->photons + map->count, buffer->photons,
			       sizeof(Photon) * buffer->count);
		map->count += buffer->count;
		photon_statistics_add(statistics, &buffer->statistics);
	}
	return map;
}

static void note_lights(PhotonMap *map, const Scene *scene, const PhotonAims *aims)
{
	map->light_count = scene->light_count;
	map->lights = memory_alloc(sizeof(PhotonLight) * (size_t)scene->light_count);
	memset(map->lights, 0, sizeof(PhotonLight) * (size_t)scene->light_count);
	for (int a = 0; a < aims->count; a++) {
		const PhotonAim *aim = &aims->aims[a];
		PhotonLight *light = &map->lights[aim->light];
		light->paths += aim->paths;
		light->parameter_area += emission_region(&scene->lights[aim->light], &aim->ball)
						 .measure;
		light->parameter_dimensions = emission_dimensions(&scene->lights[aim->light]);
	}
}

/* emitter_coordinates off. */
static void forget_emitters(PhotonMap *map)
{
	for (uint32_t i = 0; i < map->count; i++)
		memset(map->photons[i].emitter, 0, sizeof map->photons[i].emitter);
}

PhotonMap *photon_trace(const Scene *scene, const PhotonTraceOptions *options,
			PhotonStatistics *statistics)
{
	PhotonStatistics own = {0};
	double wall = clock_wall(), cpu = clock_cpu();
	Arena *arena = arena_create();
	PhotonAims aims = photon_aims(scene, options, arena);
	Job job = {scene, options, NULL, 0};
	cut_chunks(&job, &aims, arena);
	parallel_for(job.count, 1, trace_chunk, &job);
	PhotonMap *map = stopped(options) ? NULL : join_chunks(&job, &own);
	if (map)
		note_lights(map, scene, &aims);
	if (map && !scene->settings.photons.emitter_coordinates)
		forget_emitters(map);
	for (long i = 0; i < job.count; i++)
		free(job.chunks[i].buffer.photons);
	arena_destroy(arena);
	own.seconds = clock_wall() - wall;
	own.cpu_seconds = clock_cpu() - cpu;
	if (statistics)
		*statistics = own;
	return map;
}
