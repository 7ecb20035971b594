/* #include: finds, reads and scans files; a text that was scanned before is not scanned again. */
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "lang/files.h"
#include "parser/link.h"
#include "parser/state.h"

static bool is_file(const char *path)
{
	struct stat status;
	return stat(path, &status) == 0 && !S_ISDIR(status.st_mode);
}

static const char *directory_of(Arena *arena, const char *path)
{
	const char *slash = strrchr(path, '/');
	return slash ? arena_strndup(arena, path, (size_t)(slash - path + 1)) : "";
}

/* The file of that name in its folder whatever its letters' case: old scenes come from systems that
 * do not care. */
static const char *find_any_case(Arena *arena, const char *path)
{
	const char *folder = directory_of(arena, path), *base = path + strlen(folder),
		   *found = NULL;
	DIR *directory = opendir(*folder ? folder : ".");
	if (!directory)
		return NULL;
	for (struct dirent *entry; !found && (entry = readdir(directory));) {
		const char *candidate = arena_printf(arena, "%s%s", folder, entry->d_name);
		if (strcasecmp(entry->d_name, base) == 0 && is_file(candidate))
			found = candidate;
	}
	closedir(directory);
	return found;
}

static const char *find_in(Arena *arena, const char *folder, const char *name)
{
	const char *separator = *folder && folder[strlen(folder) - 1] != '/' ? "/" : "";
	const char *path = arena_printf(arena, "%s%s%s", folder, separator, name);
	return is_file(path) ? path : find_any_case(arena, path);
}

/* As given, beside the file that includes it, beside the scene, along the library paths. */
static const char *find_file(Reader *reader, const char *name)
{
	Context *context = &reader->context;
	Arena *arena = context->parse;
	char *path = arena_strdup(arena, name);
	for (char *at = path; *at; at++)
		if (*at == '\\')
			*at = '/';
	const char *found = find_in(arena, "", path);
	if (!found && *path != '/' && reader->source_count > 0)
		found = find_in(arena, directory_of(arena, source_top(reader)->file->path), path);
	for (int i = 0; !found && *path != '/' && i < context->library_path_count; i++)
		found = find_in(arena, context->library_paths[i], path);
	return found;
}

/* The whole stream with two NUL bytes behind it; NULL when reading fails. */
static char *read_stream(FILE *stream, size_t *length)
{
	size_t capacity = 65536;
	char *text = memory_alloc(capacity);
	*length = 0;
	for (size_t got; (got = fread(text + *length, 1, capacity - *length - 2, stream)) > 0;) {
		*length += got;
		if (capacity - *length < 4096)
			text = memory_resize(text, capacity *= 2);
	}
	if (ferror(stream)) {
		free(text);
		return NULL;
	}
	text[*length] = text[*length + 1] = 0;
	return text;
}

static char *read_text(const char *path, size_t *length)
{
	if (strcmp(path, "-") == 0)
		return read_stream(stdin, length);
	FILE *stream = fopen(path, "rb");
	if (!stream)
		return NULL;
	char *text = read_stream(stream, length);
	fclose(stream);
	return text;
}

/* A scene is a text: no NUL bytes, and hardly any control characters at its beginning. */
static bool looks_binary(const char *text, size_t length)
{
	size_t seen = length < 4096 ? length : 4096, controls = 0;
	for (size_t i = 0; i < seen; i++) {
		unsigned char byte = (unsigned char)text[i];
		controls += byte < 32 && !strchr("\t\n\r\f\v\x1a", byte);
	}
	return memchr(text, 0, length) || controls * 50 > seen;
}

static TokenFile *find_scanned(Reader *reader, const char *path, const char *text, size_t length)
{
	for (TokenFile *file = reader->files; file; file = file->next)
		if (strcmp(file->path, path) == 0 && file->length == length &&
		    memcmp(file->text, text, length) == 0)
			return file;
	return NULL;
}

static TokenFile *scan(Reader *reader, const char *path, char *text, size_t length,
		       const Expansion *via)
{
	static const char byte_order_mark[] = "\xef\xbb\xbf";
	Context *context = &reader->context;
	TokenFile *file = ARENA_NEW(context->parse, TokenFile);
	file->path = arena_strdup(context->builder->arena, path);
	/* Messages quote it for as long as there is a scene. */
	file->text = arena_copy(context->builder->arena, text, length + 2);
	free(text);
	text = file->text;
	file->length = length;
	if (length >= 3 && memcmp(text, byte_order_mark, 3) == 0)
		memset(text, ' ', 3);
	file->source = diag_add_source(context->diag, file->path, text, length);
	file->next = reader->files;
	reader->files = file;
	scanner_scan(file, reader->symbols, context->parse, context->diag, via);
	link_directives(file);
	return file;
}

/* NULL after a report. Without a place to report at, the failure is the world's. */
static TokenFile *load(Reader *reader, const char *path, const Location *where,
		       const Expansion *via)
{
	size_t length;
	const char *problem = NULL;
	char *text = read_text(path, &length);
	if (!text)
		problem = strerror(errno);
	else if (length > UINT32_MAX - 16)
		problem = "the file is too large";
	else if (looks_binary(text, length))
		problem = "this is not a text file";
	if (problem) {
		if (where)
			diag_error(reader->context.diag, *where, "cannot read '%s': %s", path,
				   problem);
		else
			diag_fail(reader->context.diag, "cannot read '%s': %s", path, problem);
		free(text);
		return NULL;
	}
	TokenFile *known = find_scanned(reader, path, text, length);
	if (!known)
		return scan(reader, path, text, length, via);
	free(text);
	return known;
}

bool include_file(Reader *reader, const char *name, Location where)
{
	bool is_main = reader->source_count == 0;
	const Location *at = is_main ? NULL : &where;
	const char *path = is_main ? name : find_file(reader, name);
	if (!path) {
		diag_error(reader->context.diag, where, "cannot find the file '%s' to include",
			   name);
		return false;
	}
	if (!is_main && !files_may_read(&reader->context, path, where))
		return false;
	const Expansion *via = is_main ? NULL : source_expansion(reader, where, NULL);
	TokenFile *file = load(reader, path, at, via);
	return file && source_push(reader, (Source){SOURCE_FILE, file, 0, file->count, via}, where);
}

void include_directive(Reader *reader, Location where)
{
	const char *name;
	Location at = source_here(reader);
	if (frame_string(reader, &name) && !include_file(reader, name, at))
		/* What the file would have declared is missing: going on brings only echoes. */
		reader->stopped = true;
	(void)where;
}
