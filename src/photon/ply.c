/*
 * Photon maps as PLY (Turk 1994): binary little-endian, a vertex a photon, unpacked into plain
 * numbers, so that MeshLab, CloudCompare and Blender show them. Lights travel as a second element.
 * Photons that relaxation moved have a comment that says so and, when it moved them under
 * constraints, those as further properties.
 * Numbers are written in the machine's order, which is little-endian on every machine this runs on;
 * reading other orders or ASCII is refused.
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"
#include "base/output_file.h"
#include "photon/map.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
	       "PLY files are written in little-endian order");

typedef struct PlyPhoton {
	float x, y, z, nx, ny, nz, red, green, blue; /* flux */
	float dx, dy, dz, e1, e2, e3, length;
	uint16_t light, object;
	uint8_t edges;
	uint16_t path;
} __attribute__((packed)) PlyPhoton;

typedef struct PlyConstraint {
	float along[3], across[3]; /* u_b and v_b of SJ13 eq. 7 */
} __attribute__((packed)) PlyConstraint;

typedef struct PlyLight {
	double paths, parameter_area;
	uint8_t dimensions;
} __attribute__((packed)) PlyLight;

static const char first_lines[] =
	"ply\nformat binary_little_endian 1.0\ncomment photon map of cognac\n";
static const char relaxed_line[] = "comment relaxed\n";
static const char photon_properties[] =
	"property float x\nproperty float y\nproperty float z\n"
	"property float nx\nproperty float ny\nproperty float nz\n"
	"property float flux_red\nproperty float flux_green\nproperty float flux_blue\n"
	"property float from_x\nproperty float from_y\nproperty float from_z\n"
	"property float emitter_1\nproperty float emitter_2\nproperty float emitter_3\n"
	"property float path_length\nproperty ushort light\nproperty ushort object\n"
	"property uchar path_edges\nproperty ushort path_kind\n";
static const char constraint_properties[] =
	"property float along_x\nproperty float along_y\nproperty float along_z\n"
	"property float across_x\nproperty float across_y\nproperty float across_z\n";
static const char light_properties[] =
	"property double paths\nproperty double parameter_area\n"
	"property uchar parameter_dimensions\n";

/* ---- writing ---- */

static PlyPhoton unpack(const Photon *p)
{
	Vec3 n = photon_normal(p), d = photon_direction(p);
	Rgb flux = photon_flux(p);
	return (PlyPhoton){p->position[0], p->position[1], p->position[2], (float)n.x,
			   (float)n.y,     (float)n.z,     flux.r,         flux.g,
			   flux.b,         (float)d.x,     (float)d.y,     (float)d.z,
			   p->emitter[0],  p->emitter[1],  p->emitter[2],  p->length,
			   p->light,       p->object,      p->edges,       p->path};
}

static PlyConstraint unpack_constraint(const Photon *photon, const PhotonConstraint *constraint)
{
	const float *u = constraint->along;
	Vec3 across = vec3_normalize(vec3_cross(photon_normal(photon), vec3_of_floats(u)));
	Vec3 v = vec3_scale(across, constraint->freedom);
	return (PlyConstraint){{u[0], u[1], u[2]}, {(float)v.x, (float)v.y, (float)v.z}};
}

static void write_photon(const PhotonMap *map, uint32_t i, FILE *file)
{
	PlyPhoton row = unpack(&map->photons[i]);
	fwrite(&row, sizeof row, 1, file);
	if (!map->constraints)
		return;
	PlyConstraint constraint = unpack_constraint(&map->photons[i], &map->constraints[i]);
	fwrite(&constraint, sizeof constraint, 1, file);
}

/* Whether all got there the stream knows. */
static void write_all(const PhotonMap *map, FILE *file)
{
	fprintf(file, "%s%selement vertex %u\n%s%s", first_lines,
		map->relaxed ? relaxed_line : "", map->count, photon_properties,
		map->constraints ? constraint_properties : "");
	fprintf(file, "element light %d\n%send_header\n", map->light_count, light_properties);
	for (uint32_t i = 0; i < map->count && !ferror(file); i++)
		write_photon(map, i, file);
	for (int i = 0; i < map->light_count; i++) {
		const PhotonLight *l = &map->lights[i];
		PlyLight row = {(double)l->paths, l->parameter_area,
				(uint8_t)l->parameter_dimensions};
		fwrite(&row, sizeof row, 1, file);
	}
}

bool photon_map_write(const PhotonMap *map, const char *path, Diag *diag)
{
	OutputFile file;
	if (!output_file_open(&file, path, diag))
		return false;
	write_all(map, file.stream);
	return output_file_commit(&file, diag);
}

/* ---- reading: what was written here, property for property ---- */

enum { LONGEST_LINE = 256 };

static bool expect_lines(FILE *file, const char *lines)
{
	char line[LONGEST_LINE];
	while (*lines) {
		size_t length = (size_t)(strchr(lines, '\n') + 1 - lines);
		if (!fgets(line, sizeof line, file) || strlen(line) != length ||
		    memcmp(line, lines, length) != 0)
			return false;
		lines += length;
	}
	return true;
}

/* Lines that may be missing: then the file stays where it was. */
static bool accept_lines(FILE *file, const char *lines)
{
	long at = ftell(file);
	if (expect_lines(file, lines))
		return true;
	fseek(file, at, SEEK_SET);
	return false;
}

static bool expect_count(FILE *file, const char *format, unsigned *count)
{
	char line[LONGEST_LINE];
	return fgets(line, sizeof line, file) && sscanf(line, format, count) == 1;
}

static bool is_sound(const PlyPhoton *row)
{
	float sum = row->x + row->y + row->z + row->nx + row->ny + row->nz + row->red + row->green +
		    row->blue + row->dx + row->dy + row->dz + row->e1 + row->e2 + row->e3 +
		    row->length;
	return isfinite(sum) && row->red >= 0 && row->green >= 0 && row->blue >= 0;
}

static Photon pack(const PlyPhoton *row)
{
	Photon p = {.position = {row->x, row->y, row->z},
		    .emitter = {row->e1, row->e2, row->e3},
		    .length = row->length,
		    .light = row->light,
		    .object = row->object,
		    .edges = row->edges,
		    .path = row->path};
	photon_set_flux(&p, rgb(row->red, row->green, row->blue));
	photon_set_direction(&p, vec3_normalize(vec3(row->dx, row->dy, row->dz)));
	photon_set_normal(&p, vec3_normalize(vec3(row->nx, row->ny, row->nz)));
	return p;
}

/* False for what cannot be. */
static bool pack_constraint(const PlyConstraint *row, PhotonConstraint *out)
{
	Vec3 across = vec3(row->across[0], row->across[1], row->across[2]);
	double freedom = vec3_length(across);
	*out = (PhotonConstraint){{row->along[0], row->along[1], row->along[2]},
				  (float)fmin(freedom, 1)};
	return isfinite(freedom + row->along[0] + row->along[1] + row->along[2]);
}

static bool read_photon(PhotonMap *map, uint32_t i, FILE *file)
{
	PlyPhoton row;
	PlyConstraint constraint;
	if (fread(&row, sizeof row, 1, file) != 1 || !is_sound(&row) ||
	    row.light >= map->light_count)
		return false;
	map->photons[i] = pack(&row);
	return !map->constraints || (fread(&constraint, sizeof constraint, 1, file) == 1 &&
				     pack_constraint(&constraint, &map->constraints[i]));
}

static const char *read_light(PhotonLight *light, FILE *file)
{
	static const double most_paths = 1e18;
	PlyLight row;
	if (fread(&row, sizeof row, 1, file) != 1)
		return "it ends too early";
	if (!(row.paths >= 0 && row.paths <= most_paths && row.parameter_area >= 0 &&
	      row.parameter_area < INFINITY))
		return "it holds a light that cannot be";
	*light = (PhotonLight){(uint64_t)row.paths, row.parameter_area, row.dimensions};
	return NULL;
}

static long bytes_left(FILE *file)
{
	long at = ftell(file);
	if (at < 0 || fseek(file, 0, SEEK_END) != 0)
		return -1;
	long end = ftell(file);
	return fseek(file, at, SEEK_SET) == 0 ? end - at : -1;
}

static const char *read_rows(PhotonMap *map, FILE *file, bool constrained)
{
	size_t each = sizeof(PlyPhoton) + (constrained ? sizeof(PlyConstraint) : 0);
	long need = (long)(map->count * each + (size_t)map->light_count * sizeof(PlyLight));
	if (bytes_left(file) != need)
		return "its length does not fit its header";
	if (constrained)
		map->constraints = memory_alloc(sizeof(PhotonConstraint) * map->count);
	map->photons = memory_alloc(sizeof(Photon) * map->count);
	map->lights = memory_alloc(sizeof(PhotonLight) * (size_t)map->light_count);
	for (uint32_t i = 0; i < map->count; i++)
		if (!read_photon(map, i, file))
			return "it holds a photon that cannot be";
	const char *wrong = NULL;
	for (int i = 0; i < map->light_count && !wrong; i++)
		wrong = read_light(&map->lights[i], file);
	return wrong;
}

static const char *read_all(PhotonMap *map, FILE *file)
{
	unsigned photons, lights;
	static const char stranger[] = "it is no photon map of this program";
	if (!expect_lines(file, first_lines))
		return stranger;
	map->relaxed = accept_lines(file, relaxed_line);
	if (!expect_count(file, "element vertex %u\n", &photons) ||
	    !expect_lines(file, photon_properties))
		return stranger;
	bool constrained = accept_lines(file, constraint_properties);
	if (!expect_count(file, "element light %u\n", &lights) ||
	    !expect_lines(file, light_properties) || !expect_lines(file, "end_header\n"))
		return stranger;
	if (lights > UINT16_MAX)
		return "it holds too many lights";
	map->count = photons;
	map->light_count = (int)lights;
	return read_rows(map, file, constrained);
}

PhotonMap *photon_map_read(const char *path, Diag *diag)
{
	FILE *file = fopen(path, "rb");
	if (!file) {
		diag_fail(diag, "cannot read the photon map '%s': %s", path, strerror(errno));
		return NULL;
	}
	PhotonMap *map = photon_map_create();
	const char *wrong = read_all(map, file);
	fclose(file);
	if (!wrong)
		return map;
	diag_fail(diag, "cannot read the photon map '%s': %s", path, wrong);
	photon_map_destroy(map);
	return NULL;
}
