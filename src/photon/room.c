#include "photon/room.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/clock.h"
#include "photon/path.h"

/* Bytes a photon, at most, measured: kept and found again; while it is relaxed; as a corner of a
 * sheet. Larger numbers would refuse what can be done. */
enum { BYTES_KEPT = 100, BYTES_RELAXED = 390, BYTES_SHEETS = 690 };

static double bytes_of_photon(const PhotonSettings *settings)
{
	if (settings->estimator.kind == ESTIMATOR_FOOTPRINT)
		return BYTES_SHEETS;
	return settings->relaxation.on ? BYTES_RELAXED : BYTES_KEPT;
}

uint64_t photon_room(const Scene *scene)
{
	return (uint64_t)fmin(memory_most() / bytes_of_photon(&scene->settings.photons),
			      UINT32_MAX);
}

PhotonForecast photon_room_forecast(const Scene *scene, const PhotonAims *aims,
				    const PhotonTraceOptions *options)
{
	enum { PROBES = 256, PROBE_PATHS = 64 };
	PhotonBuffer buffer = {.photons = NULL};
	uint64_t paths = 0;
	double before = clock_wall();
	const PhotonAim *aim = aims->aims, *last = &aims->aims[aims->count - 1];
	for (int i = 0; i < PROBES && !(options->stop && *options->stop); i++) {
		uint64_t path = aims->paths / PROBES * (uint64_t)i;
		while (aim < last && aim[1].first <= path)
			aim++;
		uint64_t first = path - aim->first, left = aim->paths - first;
		uint64_t count = left < PROBE_PATHS ? left : PROBE_PATHS;
		photon_paths(scene, aim, options, first, count, &buffer);
		paths += count;
	}
	free(buffer.photons);
	double scale = paths ? (double)aims->paths / (double)paths : 0;
	return (PhotonForecast){scale * (double)buffer.count, scale * (clock_wall() - before)};
}

void photon_room_refuse(const Scene *scene, const PhotonAims *aims,
			const PhotonTraceOptions *options)
{
	static const double million = 1e6, giga = 1e9;
	const PhotonSettings *settings = &scene->settings.photons;
	double photons = photon_room_forecast(scene, aims, options).photons;
	if (options->diag)
		diag_error(options->diag, settings->where,
			   "%.0f million paths would leave about %.0f million photons, which take "
			   "%.0f GB of memory; here are %.1f GB, for %.0f million",
			   (double)aims->paths / million, photons / million,
			   photons * bytes_of_photon(settings) / giga, memory_most() / giga,
			   (double)photon_room(scene) / million);
}
