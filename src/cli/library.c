#include "cli/library.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "config.h"

static void add(LibraryPaths *library, const char *path)
{
	if (*path == 0 || library->count == LIBRARY_MAXIMUM)
		return;
	for (int i = 0; i < library->count; i++)
		if (strcmp(library->paths[i], path) == 0)
			return;
	library->paths[library->count++] = path;
}

LibraryPaths library_paths(const Options *options)
{
	static const char *const installed[] = {
		POVRAY_INCLUDES,
		"/usr/share/povray-3.7/include",
		"/usr/local/share/povray-3.7/include",
	};
	LibraryPaths library = {.count = 0};
	for (int i = 0; i < options->library_path_count; i++)
		add(&library, options->library_paths[i]);
	const char *environment = getenv("COGNAC_LIBRARY_PATH");
	while (environment && *environment) {
		size_t length = strcspn(environment, ":");
		add(&library, arena_strndup(options->arena, environment, length));
		environment += length + (environment[length] == ':');
	}
	for (size_t i = 0; i < sizeof installed / sizeof *installed; i++)
		if (access(installed[i], X_OK) == 0)
			add(&library, installed[i]);
	return library;
}
