#include "lang/files.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Longest number or string that #read takes. */
enum { TOKEN_LIMIT = 4096 };

struct SceneFile {
	FILE *stream; /* NULL once closed */
	FileMode mode;
	const char *path;
	int line;     /* that is being read, from 1 */
	bool ended;   /* nothing is left to read, or a mistake was met */
	SceneFile *next;
};

/* ---- where files may be ---- */

/* The real path of what the path names or, for a file to be made, of its folder with the name after
 * it. */
static bool real_path(const char *path, char out[PATH_MAX])
{
	if (realpath(path, out))
		return true;
	const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
	char folder[PATH_MAX], real_folder[PATH_MAX];
	int length = slash ? (int)(slash - path) : 1;
	if (snprintf(folder, sizeof folder, "%.*s", length, slash ? path : ".") >= PATH_MAX ||
	    *name == '\0' || strcmp(name, "..") == 0)
		return false;
	if (!realpath(length ? folder : "/", real_folder))
		return false;
	return snprintf(out, PATH_MAX, "%s/%s", real_folder, name) < PATH_MAX;
}

static bool lies_below(const char *real, const char *folder)
{
	char top[PATH_MAX];
	if (!realpath(folder, top))
		return false;
	size_t length = strlen(top);
	return strcmp(top, "/") == 0 ||
	       (strncmp(real, top, length) == 0 && (real[length] == '/' || real[length] == '\0'));
}

bool files_may_read(Context *context, const char *path, Location where)
{
	char real[PATH_MAX];
	if (context->read_path_count == 0)
		return true;
	bool known = real_path(path, real);
	for (int i = 0; known && i < context->read_path_count; i++)
		if (lies_below(real, context->read_paths[i]))
			return true;
	for (int i = 0; known && i < context->library_path_count; i++)
		if (lies_below(real, context->library_paths[i]))
			return true;
	diag_error(context->diag, where, "reading '%s' is not allowed", path);
	return false;
}

static bool may_write(Context *context, const char *path, Location where)
{
	char real[PATH_MAX];
	if (context->allow_write_anywhere || (real_path(path, real) && lies_below(real, ".")))
		return true;
	diag_error(context->diag, where,
		   "writing '%s' is not allowed: it is outside the working directory", path);
	return false;
}

static bool is_file(const char *path)
{
	struct stat status;
	return stat(path, &status) == 0 && !S_ISDIR(status.st_mode);
}

const char *files_find(Context *context, const char *name)
{
	if (is_file(name))
		return arena_strdup(context->parse, name);
	for (int i = 0; *name != '/' && i < context->library_path_count; i++) {
		const char *path = arena_printf(context->parse, "%s/%s", context->library_paths[i],
						name);
		if (is_file(path))
			return path;
	}
	return NULL;
}

/* ---- opening and closing ---- */

SceneFile *files_open(Context *context, const char *path, FileMode mode, Location where)
{
	const char *found = mode == FILE_READ ? files_find(context, path) : path;
	if (!found) {
		diag_error(context->diag, where, "no file '%s'", path);
		return NULL;
	}
	if (mode == FILE_READ ? !files_may_read(context, found, where)
			      : !may_write(context, found, where))
		return NULL;
	FILE *stream = fopen(found, mode == FILE_READ ? "r" : mode == FILE_WRITE ? "w" : "a");
	if (!stream) {
		diag_error(context->diag, where, "cannot open '%s': %s", path, strerror(errno));
		return NULL;
	}
	SceneFile *file = ARENA_NEW(context->parse, SceneFile);
	*file = (SceneFile){.stream = stream,
			    .mode = mode,
			    .path = arena_strdup(context->parse, path),
			    .line = 1,
			    .next = context->files};
	context->files = file;
	return file;
}

void files_close(SceneFile *file)
{
	if (file->stream)
		fclose(file->stream);
	file->stream = NULL;
}

void files_close_all(Context *context)
{
	for (SceneFile *file = context->files; file; file = file->next)
		files_close(file);
	context->files = NULL;
}

/* ---- reading ---- */

static int next_character(SceneFile *file)
{
	int c = getc(file->stream);
	file->line += c == '\n';
	return c;
}

static void give_back(SceneFile *file, int c)
{
	file->line -= c == '\n';
	if (c != EOF)
		ungetc(c, file->stream);
}

static int peek_character(SceneFile *file)
{
	int c = next_character(file);
	give_back(file, c);
	return c;
}

/* The rest of a comment after its first slash; comments between marks nest. False where it is none.
 */
static bool skip_comment(SceneFile *file)
{
	int c = peek_character(file), last = 0, depth = 1;
	if (c == '/') {
		while (c != EOF && c != '\n')
			c = next_character(file);
		return true;
	}
	if (c != '*')
		return false;
	next_character(file);
	while (depth > 0 && (c = next_character(file)) != EOF) {
		int step = last == '/' && c == '*' ? 1 : last == '*' && c == '/' ? -1 : 0;
		depth += step;
		last = step ? 0 : c;
	}
	return true;
}

/* The next character that is no blank and stands in no comment; EOF at the end. It stays in the
 * file. */
static int peek_past_blanks(SceneFile *file)
{
	for (;;) {
		int c = next_character(file);
		if (c != EOF && isspace(c))
			continue;
		if (c == '/' && skip_comment(file))
			continue;
		give_back(file, c);
		return c;
	}
}

bool files_at_end(const SceneFile *file)
{
	return !file->stream || file->ended;
}

/* After a mistake nothing more is read, so that it is told once. */
static bool report_content(Context *context, SceneFile *file, Location where, const char *what)
{
	diag_error(context->diag, where, "'%s', line %d: %s", file->path, file->line, what);
	file->ended = true;
	return false;
}

static bool is_number_part(int c)
{
	return isdigit(c) || c == '.' || c == '+' || c == '-' || c == 'e' || c == 'E';
}

static bool read_float(SceneFile *file, double *out)
{
	char text[TOKEN_LIMIT], *end;
	size_t length = 0;
	int c = peek_past_blanks(file);
	bool exponent = false;
	while (length + 1 < sizeof text && (c = next_character(file)) != EOF && is_number_part(c)) {
		bool sign = c == '+' || c == '-';
		if (sign && length > 0 && !exponent)
			break;
		exponent = c == 'e' || c == 'E';
		text[length++] = (char)c;
	}
	give_back(file, c);
	text[length] = '\0';
	*out = strtod(text, &end);
	return length > 0 && *end == '\0';
}

static bool read_vector(SceneFile *file, Value *out)
{
	Value value = {.kind = VALUE_VECTOR};
	next_character(file);
	while (value.size < 5 && read_float(file, &value.v[value.size])) {
		value.size++;
		int c = peek_past_blanks(file);
		if (c == ',')
			next_character(file);
		else if (c == '>')
			break;
	}
	*out = value;
	return value.size >= 2 && next_character(file) == '>';
}

/* A string to its closing quote; \" \\ \n \t stand for what they stand for in scenes. */
static bool read_string(SceneFile *file, Arena *arena, Value *out)
{
	char text[TOKEN_LIMIT];
	size_t length = 0;
	int c;
	next_character(file);
	while ((c = next_character(file)) != EOF && c != '"' && length + 1 < sizeof text) {
		if (c == '\\') {
			c = next_character(file);
			c = c == 'n' ? '\n' : c == 't' ? '\t' : c;
		}
		if (c != EOF)
			text[length++] = (char)c;
	}
	*out = value_string(arena_strndup(arena, text, length));
	return c == '"';
}

/* The comma that must part values. Behind the last one nothing is looked for: the file goes on
 * until reading beyond it is tried, as in POV-Ray. */
static bool read_comma(Context *context, SceneFile *file, Location where)
{
	int c = peek_past_blanks(file);
	file->ended = c == EOF;
	if (c == ',')
		next_character(file);
	return c == ',' || c == EOF ||
	       report_content(context, file, where, "a comma is missing between values");
}

static bool read_value(Context *context, SceneFile *file, int first, Value *out, Location where)
{
	if (first == '<')
		return read_vector(file, out) ||
		       report_content(context, file, where, "expected a vector of 2 to 5 floats");
	if (first == '"')
		return read_string(file, context->parse, out) ||
		       report_content(context, file, where, "expected a closing quote");
	return read_float(file, &out->number) ||
	       report_content(context, file, where, "expected a float, a string or a vector");
}

bool files_read(Context *context, SceneFile *file, Value *out, Location where)
{
	*out = value_float(0);
	if (!file->stream || file->mode != FILE_READ) {
		diag_error(context->diag, where, "'%s' is not open for reading", file->path);
		return false;
	}
	int first = peek_past_blanks(file);
	if (first == EOF) {
		file->ended = true;
		diag_warning(context->diag, where, "nothing is left to read from '%s'", file->path);
		return false;
	}
	return read_value(context, file, first, out, where) && read_comma(context, file, where);
}

/* ---- writing ---- */

static bool may_be_written(Context *context, const SceneFile *file, Location where)
{
	bool open = file->stream && file->mode != FILE_READ;
	if (!open)
		diag_error(context->diag, where, "'%s' is not open for writing", file->path);
	return open;
}

void files_write(Context *context, SceneFile *file, Value value, Location where)
{
	if (!may_be_written(context, file, where))
		return;
	if (value.kind == VALUE_STRING) {
		fputs(value.string, file->stream);
	} else if (value.kind == VALUE_FLOAT) {
		fprintf(file->stream, "%g", value.number);
	} else if (value_is_numeric(value)) {
		for (int i = 0; i < value.size; i++)
			fprintf(file->stream, "%c%g", i == 0 ? '<' : ',', value.v[i]);
		fputs("> ", file->stream);
	} else {
		diag_error(context->diag, where,
			   "'#write' takes strings, floats and vectors, found %s",
			   value_describe(value));
	}
}

struct FileInteger {
	Word word;
	int bytes;
	bool is_signed, big_endian;
};

const FileInteger *files_integer(Word word)
{
	static const FileInteger rows[] = {
		{W_uint8, 1, false, false},   {W_sint8, 1, true, false},
		{W_uint16be, 2, false, true}, {W_uint16le, 2, false, false},
		{W_sint16be, 2, true, true},  {W_sint16le, 2, true, false},
		{W_sint32be, 4, true, true},  {W_sint32le, 4, true, false},
	};
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (rows[i].word == word)
			return &rows[i];
	return NULL;
}

static void write_integer(FILE *stream, const FileInteger *format, double number)
{
	double values = ldexp(1, 8 * format->bytes);
	double low = format->is_signed ? -values / 2 : 0;
	uint64_t bits = (uint64_t)(int64_t)floor(fmin(fmax(number, low), low + values - 1) + 0.5);
	for (int i = 0; i < format->bytes; i++)
		putc((int)(bits >> (8 * (format->big_endian ? format->bytes - 1 - i : i)) & 0xff),
		     stream);
}

void files_write_integer(Context *context, SceneFile *file, const FileInteger *format, Value value,
			 Location where)
{
	if (!may_be_written(context, file, where))
		return;
	if (value.kind == VALUE_FLOAT) {
		write_integer(file->stream, format, value.number);
	} else if (value_is_numeric(value)) {
		for (int i = 0; i < value.size; i++)
			write_integer(file->stream, format, value.v[i]);
	} else {
		diag_error(context->diag, where, "'%s' takes floats and vectors, found %s",
			   word_text(format->word), value_describe(value));
	}
}
