/*
 * Reads a scene: text to tokens to directives to grammar to builders. The one entry of the parser
 * room.
 */
#ifndef PARSER_READER_H
#define PARSER_READER_H

#include <signal.h>

#include "base/diag.h"
#include "scene/scene.h"

/* A constant given on the command line or in an INI file: Declare=Name=Value. */
typedef struct ReaderConstant {
	const char *name;
	const char *text;
	double number;
	bool is_string;
} ReaderConstant;

typedef struct ReaderOptions {
	const char *path; /* the scene file; "-" reads standard input */
	const char *const *library_paths; int library_path_count;
	const char *header_include; /* +HI: read first; or NULL */
	const ReaderConstant *constants; int constant_count;
	double version;             /* +MV; 0: none */
	double clock, clock_delta, initial_clock, final_clock;
	int frame_number, initial_frame, final_frame;
	bool clock_on;
	int image_width, image_height;
	bool quick_colors;          /* low quality: pigments with a quick_color are of that colour */
	bool allow_write_anywhere;
	const char *const *allowed_read_paths; int allowed_read_path_count; /* empty: everywhere */
	const volatile sig_atomic_t
		*interrupted; /* reading ends soon after it became nonzero; or NULL */
} ReaderOptions;

/* Fills the builder. False when there were errors, all reported. */
bool reader_read(const ReaderOptions *options, SceneBuilder *builder, Diag *diag);

#endif
