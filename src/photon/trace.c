#include "photon/trace.h"

#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/parallel.h"
#include "photon/path.h"
#include "photon/room.h"

/* Paths are traced in chunks, and some chunks a thread at a time: each of these has a buffer of its
 * own, and buffers are joined in order and used again, so that they stay in the caches. Threads
 * wait for each other at the end of a round, for half a chunk on average. */
enum { CHUNK = 1024, ROUND_OF_THREAD = 32 };

typedef struct Job {
	const Scene *scene;
	const PhotonTraceOptions *options;
	const PhotonAims *aims;
	long *firsts;      /* number of each aim's first chunk */
	long count, done;  /* chunks */
	PhotonBuffer *buffers;
	long round; /* how many */
	Photon *photons;
	size_t *places; /* of each buffer's photons among these */
	size_t room;    /* for so many photons at most */
} Job;

static bool stopped(const PhotonTraceOptions *options)
{
	return options->stop && *options->stop;
}

/* The aim whose paths the chunk holds. */
static int aim_of_chunk(const Job *job, long chunk)
{
	int low = 0, high = job->aims->count;
	while (high - low > 1) {
		int middle = low + (high - low) / 2;
		if (job->firsts[middle] <= chunk)
			low = middle;
		else
			high = middle;
	}
	return low;
}

static void trace_chunk(void *data, long item, int thread)
{
	(void)thread;
	Job *job = data;
	int aim = aim_of_chunk(job, job->done + item);
	uint64_t first = (uint64_t)(job->done + item - job->firsts[aim]) * CHUNK;
	uint64_t left = job->aims->aims[aim].paths - first;
	PhotonBuffer *buffer = &job->buffers[item];
	buffer->count = 0;
	buffer->statistics = (PhotonStatistics){0};
	if (!stopped(job->options))
		photon_paths(job->scene, &job->aims->aims[aim], job->options, first,
			     left < CHUNK ? left : CHUNK, buffer);
}

static void number_chunks(Job *job, Arena *arena)
{
	job->firsts = ARENA_ARRAY(arena, long, job->aims->count + 1);
	for (int a = 0; a < job->aims->count; a++) {
		job->firsts[a] = job->count;
		job->count += (long)((job->aims->aims[a].paths + CHUNK - 1) / CHUNK);
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

/* Room for one photon a path, but no more than this at first: memory not written costs nothing, and
 * large pages stay whole that need not be moved. */
static const uint64_t ROOM_AT_FIRST = 1 << 22;

static void copy_photons(void *data, long item, int thread)
{
	(void)thread;
	const Job *job = data;
	const PhotonBuffer *buffer = &job->buffers[item];
	if (buffer->count)
		memcpy(job->photons + job->places[item], buffer->photons,
		       sizeof(Photon) * buffer->count);
}

/* The buffers' photons, in order, behind those that are there: by all threads, since memory that is
 * written for the first time costs more than the copy. */
static void join_buffers(Job *job, long count, size_t *stored, size_t *capacity)
{
	size_t sum = *stored;
	for (long i = 0; i < count; i++) {
		job->places[i] = sum;
		sum += job->buffers[i].count;
	}
	while (sum > *capacity) {
		*capacity *= 2;
		job->photons = memory_resize(job->photons, sizeof(Photon) * *capacity);
	}
	parallel_for(count, 1, copy_photons, job);
	*stored = sum;
}

/* NULL: there are more than there is room for. */
static PhotonMap *trace_rounds(Job *job, PhotonStatistics *statistics)
{
	uint64_t paths = job->aims->paths;
	size_t capacity = (size_t)(paths < ROOM_AT_FIRST ? paths + 1 : ROOM_AT_FIRST), stored = 0;
	job->photons = memory_alloc_wide(sizeof(Photon) * capacity);
	while (job->done < job->count && !stopped(job->options) && stored <= job->room) {
		long left = job->count - job->done, some = left < job->round ? left : job->round;
		parallel_for(some, 1, trace_chunk, job);
		join_buffers(job, some, &stored, &capacity);
		for (long i = 0; i < some; i++)
			photon_statistics_add(statistics, &job->buffers[i].statistics);
		job->done += some;
	}
	if (stored > job->room) {
		free(job->photons);
		return NULL;
	}
	PhotonMap *map = photon_map_create();
	map->photons = memory_resize(job->photons, sizeof(Photon) * stored);
	map->count = (uint32_t)stored;
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

static void warn_of_hours(const Job *job, double seconds)
{
	static const double hour = 3600, million = 1e6, least_hours = 1.5; /* two, as it is told */
	double hours = seconds / parallel_threads() / hour;
	if (hours > least_hours && job->options->diag && job->options->pass == 0)
		diag_warning(job->options->diag, job->scene->settings.photons.where,
			     "%.0f million paths take about %.0f hours",
			     (double)job->aims->paths / million, hours);
}

/* Only where one photon a path would be too many is it found out how many paths leave one. */
static bool has_room(const Job *job)
{
	if (job->aims->paths <= job->room)
		return true;
	PhotonForecast forecast = photon_room_forecast(job->scene, job->aims, job->options);
	if (forecast.photons > (double)job->room)
		return false;
	warn_of_hours(job, forecast.seconds);
	return true;
}

/* NULL: stopped, or refused for want of memory. */
static PhotonMap *trace_aims(Job *job, PhotonStatistics *statistics, Arena *arena)
{
	bool refused = !has_room(job);
	PhotonMap *map = NULL;
	job->round = (long)parallel_threads() * ROUND_OF_THREAD;
	job->buffers = ARENA_ARRAY(arena, PhotonBuffer, job->round);
	job->places = ARENA_ARRAY(arena, size_t, job->round);
	number_chunks(job, arena);
	if (!refused) {
		map = trace_rounds(job, statistics);
		refused = !map;
	}
	for (long i = 0; i < job->round; i++)
		free(job->buffers[i].photons);
	if (refused && !stopped(job->options))
		photon_room_refuse(job->scene, job->aims, job->options);
	if (map && stopped(job->options)) {
		photon_map_destroy(map);
		map = NULL;
	}
	return map;
}

PhotonMap *photon_trace(const Scene *scene, const PhotonTraceOptions *options,
			PhotonStatistics *statistics)
{
	PhotonStatistics own = {0};
	double wall = clock_wall(), cpu = clock_cpu();
	Arena *arena = arena_create();
	PhotonAims aims = photon_aims(scene, options, arena);
	if (aims.count == 0 && options->diag && options->pass == 0)
		diag_warning(options->diag, scene->settings.photons.where,
			     "no photons: no object is a target that a light sends any to");
	Job job = {.scene = scene,
		   .options = options,
		   .aims = &aims,
		   .room = (size_t)photon_room(scene)};
	PhotonMap *map = trace_aims(&job, &own, arena);
	if (map) {
		note_lights(map, scene, &aims);
		if (!scene->settings.photons.emitter_coordinates)
			forget_emitters(map);
	}
	arena_destroy(arena);
	own.seconds = clock_wall() - wall;
	own.cpu_seconds = clock_cpu() - cpu;
	if (statistics)
		*statistics = own;
	return map;
}
