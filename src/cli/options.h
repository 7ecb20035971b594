/*
 * Everything that POV-Ray's switches, INI keys and our long options can say. One table maps INI
 * keys to fields (options.c), one maps switches to keys (switches.c); both accept and reject what
 * POV-Ray 3.7 accepts and rejects. Later words override earlier ones. Strings live in the options'
 * arena.
 */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/arena.h"
#include "base/diag.h"
#include "image/write.h"
#include "parser/reader.h"
#include "scene/photon_settings.h"

/* When a shell command runs, in the order of their key names. */
typedef enum ShellMoment {
	SHELL_PRE_SCENE,
	SHELL_PRE_FRAME,
	SHELL_POST_FRAME,
	SHELL_POST_SCENE,
	SHELL_USER_ABORT,
	SHELL_FATAL_ERROR,
	SHELL_MOMENT_COUNT
} ShellMoment;

enum { OPTIONS_MAXIMUM_PATHS = 64, OPTIONS_MAXIMUM_CONSTANTS = 256 };
/* No whole number of an option is larger: a frame more than the last is still an int. */
enum { OPTIONS_MOST_WHOLE = 1000000000 };

typedef struct Options {
	Arena *arena;

	const char *input;          /* the scene file; "-" standard input; NULL: not said */
	const char *output;         /* as said, or NULL */
	const char *include_header;
	const char *create_ini;     /* or NULL */
	const char *library_paths[OPTIONS_MAXIMUM_PATHS]; int library_path_count;
	ReaderConstant constants[OPTIONS_MAXIMUM_CONSTANTS]; int constant_count;
	double version;             /* of the language; 0: not said */

	int width, height;
	double start_column, end_column, start_row,
		end_row; /* as said: below 1 a share; negative: not said */

	bool to_file;
	const char *file_type;      /* the letter and bits as said: "N8" */
	ImageFormat format;
	int bits;
	bool alpha, gray, dither;
	double file_gamma;          /* negative: sRGB */
	int compression;            /* JPEG quality; below 2: 85 */

	int quality;
	bool antialias;
	int sampling_method;
	double threshold;
	int depth;
	bool jitter;
	double jitter_amount, antialias_gamma;

	double clock; bool clock_said;
	int initial_frame, final_frame; /* negative: not said */
	double initial_clock, final_clock;
	double subset_start, subset_end; /* as said: below 1 a share; negative: not said */
	int frame_step;
	bool cyclic;

	bool resume;                /* +C */
	bool verbose, verbose_said;
	bool show_debug, show_render, show_statistics, show_warnings;
	const char *statistics_file;
	int warning_level;
	const char *shell_command[SHELL_MOMENT_COUNT], *shell_return[SHELL_MOMENT_COUNT];

	int threads;                /* 0: as many as the machine has */
	uint64_t seed;
	const char *photons_file, *load_photons_file; /* --photons, --load-photons; or NULL */
	const char *photons_landed_file;              /* --photons-landed; or NULL */
	Estimator estimator; bool estimator_said;     /* --estimator */
	int passes;                 /* --passes; 0: as the scene says */
	const char *stats;          /* --stats: JSON to this file, or NULL */
	double update; /* --update: seconds between rewritings of the output file; 0: never */
	bool allow_shell, allow_write;
	bool help, show_version;    /* print and end */
	const char *ignored; /* names of keys that were taken and mean nothing here; "" none */
	int ini_depth;              /* INI files being read within each other */
} Options;

Options options_default(Arena *arena);

/* KEY=VALUE as in an INI file, key in any case. False, reported, for unknown keys and values that
 * do not fit. */
bool options_set(Options *options, const char *key, const char *value, Diag *diag);
/* +W320 and the like. */
bool options_switch(Options *options, const char *word, Diag *diag);
/* Any word of a command line or INI line: switch, KEY=VALUE, INI file, scene file. */
bool options_word(Options *options, const char *word, Diag *diag);
/* The whole command line: words and long options. */
bool options_command_line(Options *options, int count, char **words, Diag *diag);

/* Reads an INI file, or one section of it after the lines before its first: "file.ini" or
 * "file.ini[section]". Looked for in the working directory, then along the library paths. (ini.c)
 */
bool options_read_ini(Options *options, const char *name, Diag *diag);
/* Writes all that was said as an INI file. */
bool options_write_ini(const Options *options, const char *path, Diag *diag);

/* True for yes, on, true and 1 in any case; everything else is false, as in POV-Ray. */
bool options_truth(const char *text);

#endif
