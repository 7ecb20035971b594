#include "photon/room.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/clock.h"
#include "photon/path.h"
#include "photon/relax.h"
#include "photon/tree.h"

/* Bytes a photon as a corner of a sheet, at most, measured. */
enum { BYTES_SHEETS = 690 };

/* At most: kept and found again, while it is relaxed, as a corner of a sheet. Larger numbers would
 * refuse what can be done. */
static double bytes_of_photon(const PhotonSettings *settings)
{
	TreeRoom tree = photon_tree_room(false);
	double most = sizeof(Photon) + tree.kept + tree.building;
	if (settings->relaxation.on)
		most = fmax(most, photon_relax_room(&settings->relaxation));
	if (settings->estimator.kind == ESTIMATOR_FOOTPRINT)
		most = fmax(most, BYTES_SHEETS);
	return most;
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
	double before = clock_cpu();
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
	return (PhotonForecast){scale * (double)buffer.count, scale * (clock_cpu() - before)};
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
