/*
 * One reading of one scene: the state that scanner, directives, grammar and builders share. Created
 * by the reader (parser/reader.h), which owns everything in it.
 */
#ifndef LANG_CONTEXT_H
#define LANG_CONTEXT_H

#include <stdbool.h>

#include "base/arena.h"
#include "base/diag.h"
#include "lang/value.h"
#include "scene/scene.h"

typedef struct SymbolTable SymbolTable; /* lang/symbol.h */
typedef struct Reader Reader;           /* parser/reader.h */
struct RandomStreams;                   /* lang/builtin.h */
struct ShapeCache;                      /* lang/builtin.h */
struct FunctionScope;                   /* lang/function.h */

/* Which defaults `#default { }` has set. Pointers into the scene arena; never NULL after
 * lang_context_init. */
typedef struct Defaults {
	const Texture *texture;
	const Pigment *pigment;
	const Normal *normal; /* or NULL */
	const Finish *finish;
	const Camera *camera;
} Defaults;

typedef struct Context {
	Diag *diag;
	Arena *parse;          /* strings, arrays, symbols: dropped after reading */
	Arena *items;          /* nodes of the item at hand: rewound after each */
	SceneBuilder *builder; /* builder->arena: what the scene keeps */
	SymbolTable *symbols;
	Reader *reader;
	Defaults defaults;
	double clock, clock_delta, initial_clock, final_clock;
	int frame_number, initial_frame, final_frame;
	bool clock_on;
	int image_width, image_height;
	double version;        /* the current #version, 3.7 by default; 0: none given yet */
	bool quick_colors;     /* pigments with a quick_color are of that colour */
	bool cognac;           /* the extension's words are on */
	unsigned unsupported; /* features a warning was given about: a bit each (lang/build_media.h)
			       */
	bool allow_write_anywhere; /* #fopen for writing outside the working directory */
	const char *const *library_paths; int library_path_count;
	const char *const *read_paths;
	int read_path_count; /* what scenes may read; none: everything */
	const char *input_file_name;
	struct RandomStreams *random;    /* what seed() has started; NULL before the first */
	struct ShapeCache
		*shapes; /* objects that trace() and its like have met; NULL before the first */
	struct FunctionScope
		*functions; /* the open function bodies, innermost first; NULL outside */
	SceneFile *files;                /* the open ones */
} Context;

#endif
