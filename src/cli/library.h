/* Where includes, fonts and pictures are looked for after the working directory. */
#ifndef CLI_LIBRARY_H
#define CLI_LIBRARY_H

#include "cli/options.h"

enum { LIBRARY_MAXIMUM = 2 * OPTIONS_MAXIMUM_PATHS };

typedef struct LibraryPaths {
	const char *paths[LIBRARY_MAXIMUM];
	int count;
} LibraryPaths;

/* First +L and Library_Path in their order, then the environment's COGNAC_LIBRARY_PATH (apart by
 * colons), then the folders where POV-Ray's own includes are installed. Strings live in the
 * options' arena. */
LibraryPaths library_paths(const Options *options);

#endif
