#include "base/output_file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/arena.h"

static bool is_standard_output(const OutputFile *file)
{
	return strcmp(file->path, "-") == 0;
}

/* A new file beside the target with the permissions that a plain fopen would give. */
static FILE *open_beside(OutputFile *file)
{
	size_t length = strlen(file->path) + sizeof ".XXXXXX";
	file->temporary = memory_alloc(length);
	snprintf(file->temporary, length, "%s.XXXXXX", file->path);
	int descriptor = mkstemp(file->temporary);
	if (descriptor < 0)
		return NULL;
	mode_t mask = umask(0);
	umask(mask);
	fchmod(descriptor, 0666 & ~mask);
	return fdopen(descriptor, "w+b");
}

static void release(OutputFile *file)
{
	free(file->path);
	free(file->temporary);
	*file = (OutputFile){NULL, NULL, NULL};
}

bool output_file_open(OutputFile *file, const char *path, Diag *diag)
{
	*file = (OutputFile){NULL, NULL, NULL};
	file->path = memory_alloc(strlen(path) + 1);
	strcpy(file->path, path);
	file->stream = is_standard_output(file) ? tmpfile() : open_beside(file);
	if (!file->stream) {
		diag_fail(diag, "%s: cannot be written: %s", path, strerror(errno));
		release(file);
		return false;
	}
	return true;
}

static bool copy_to_standard_output(FILE *from)
{
	char block[1 << 14];
	size_t got;
	rewind(from);
	while ((got = fread(block, 1, sizeof block, from)) > 0)
		if (fwrite(block, 1, got, stdout) != got)
			return false;
	return !ferror(from) && fflush(stdout) == 0;
}

static bool put_in_place(OutputFile *file)
{
	bool good = fflush(file->stream) == 0 && !ferror(file->stream);
	if (is_standard_output(file)) {
		good = good && copy_to_standard_output(file->stream);
		fclose(file->stream);
		return good;
	}
	good = fclose(file->stream) == 0 && good;
	good = good && rename(file->temporary, file->path) == 0;
	if (!good) {
		int reason = errno;
		unlink(file->temporary);
		errno = reason;
	}
	return good;
}

bool output_file_commit(OutputFile *file, Diag *diag)
{
	bool good = put_in_place(file);
	if (!good)
		diag_fail(diag, "%s: cannot be written: %s", file->path, strerror(errno));
	release(file);
	return good;
}

void output_file_abandon(OutputFile *file)
{
	if (!file->stream)
		return;
	fclose(file->stream);
	if (file->temporary)
		unlink(file->temporary);
	release(file);
}
