#include "base/diag.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

enum { FULL = 20, CHAIN_SHOWN = 8, LINE_SHOWN = 200, WARNED_KEPT = 64 };

typedef struct Source {
	const char *name, *text;
	size_t length;
} Source;

/* A warning that was printed: loops and macros come by its place again and again. */
typedef struct Warned {
	uint32_t source, offset;
	const char *format;
} Warned;

struct Diag {
	FILE *out;
	Source *sources;
	uint32_t source_count;
	int errors;
	bool quiet, no_warnings;
	Warned warned[WARNED_KEPT]; /* the latest */
	unsigned warned_count;
	pthread_mutex_t lock;
};

Diag *diag_create(FILE *out)
{
	Diag *diag = memory_alloc(sizeof *diag);
	*diag = (Diag){.out = out};
	pthread_mutex_init(&diag->lock, NULL);
	return diag;
}

void diag_destroy(Diag *diag)
{
	if (!diag)
		return;
	pthread_mutex_destroy(&diag->lock);
	free(diag->sources);
	free(diag);
}

uint32_t diag_add_source(Diag *diag, const char *name, const char *text, size_t length)
{
	diag->sources = memory_resize(diag->sources,
				      (diag->source_count + 1) * sizeof *diag->sources);
	diag->sources[diag->source_count++] = (Source){name, text, length};
	return diag->source_count;
}

static const Source *source_of(const Diag *diag, Location at)
{
	return at.source >= 1 && at.source <= diag->source_count ? &diag->sources[at.source - 1]
								 : NULL;
}

static size_t line_start(const Source *source, size_t offset)
{
	while (offset > 0 && source->text[offset - 1] != '\n')
		offset--;
	return offset;
}

static size_t clamp_offset(const Source *source, Location at)
{
	return at.offset < source->length ? at.offset : source->length;
}

Position diag_position(const Diag *diag, Location at)
{
	const Source *source = source_of(diag, at);
	if (!source)
		return (Position){NULL, 0, 0};
	size_t offset = clamp_offset(source, at);
	int line = 1;
	for (size_t i = 0; i < offset; i++)
		line += source->text[i] == '\n';
	return (Position){source->name, line, (int)(offset - line_start(source, offset)) + 1};
}

/* The line with its number, and a caret under the column; tabs are kept so that the caret stands
 * right. Bytes that a terminal could take for commands are shown as '?'. */
static void print_line(const Diag *diag, Location at, Position position)
{
	const Source *source = source_of(diag, at);
	size_t offset = clamp_offset(source, at), start = line_start(source, offset);
	if (offset - start > LINE_SHOWN / 2)
		start = offset - LINE_SHOWN / 2;
	fprintf(diag->out, "%5d | ", position.line);
	for (size_t i = start; i < source->length && i - start < LINE_SHOWN; i++) {
		unsigned char c = (unsigned char)source->text[i];
		if (c == '\n' || c == '\r')
			break;
		fputc(c >= ' ' || c == '\t' ? c : '?', diag->out);
	}
	fputs("\n      | ", diag->out);
	for (size_t i = start; i < offset; i++) {
		unsigned char c = (unsigned char)source->text[i];
		if ((c & 0xc0) != 0x80) /* a UTF-8 character takes one column */
			fputc(c == '\t' ? '\t' : ' ', diag->out);
	}
	fputs("^\n", diag->out);
}

static void print_chain(const Diag *diag, const Expansion *via)
{
	for (int shown = 0; via; via = via->at.via) {
		Position position = diag_position(diag, via->at);
		if (++shown > CHAIN_SHOWN) {
			fputs("  ...\n", diag->out);
			return;
		}
		if (via->name)
			fprintf(diag->out, "  in macro '%s', called at ", via->name);
		else
			fputs("  included from ", diag->out);
		fprintf(diag->out, "%s:%d:%d\n", position.file ? position.file : "?", position.line,
			position.column);
	}
}

static void report(const Diag *diag, Location at, const char *kind, const char *format,
		   va_list args)
{
	Position position = diag_position(diag, at);
	if (position.file)
		fprintf(diag->out, "%s:%d:%d: ", position.file, position.line, position.column);
	else
		fputs("cognac: ", diag->out);
	fputs(kind, diag->out);
	vfprintf(diag->out, format, args);
	fputc('\n', diag->out);
	if (position.file) {
		print_line(diag, at, position);
		print_chain(diag, at.via);
	}
	fflush(diag->out);
}

static void locked_report(Diag *diag, Location at, const char *kind, const char *format,
			  va_list args)
{
	if (!diag->out)
		return;
	pthread_mutex_lock(&diag->lock);
	report(diag, at, kind, format, args);
	pthread_mutex_unlock(&diag->lock);
}

static void count_error(Diag *diag)
{
	pthread_mutex_lock(&diag->lock);
	diag->errors++;
	pthread_mutex_unlock(&diag->lock);
}

void diag_error(Diag *diag, Location at, const char *format, ...)
{
	va_list args;
	va_start(args, format);
	if (!diag_is_full(diag))
		locked_report(diag, at, "error: ", format, args);
	va_end(args);
	count_error(diag);
}

/* True once for each of the latest places; what stands at no place is always new. */
static bool is_new_warning(Diag *diag, Location at, const char *format)
{
	bool known = false;
	pthread_mutex_lock(&diag->lock);
	for (unsigned i = 0; i < diag->warned_count && i < WARNED_KEPT && at.source && !known; i++)
		known = diag->warned[i].source == at.source &&
			diag->warned[i].offset == at.offset && diag->warned[i].format == format;
	if (!known)
		diag->warned[diag->warned_count++ % WARNED_KEPT] =
			(Warned){at.source, at.offset, format};
	pthread_mutex_unlock(&diag->lock);
	return !known;
}

void diag_warning(Diag *diag, Location at, const char *format, ...)
{
	if (diag->no_warnings || !is_new_warning(diag, at, format))
		return;
	va_list args;
	va_start(args, format);
	locked_report(diag, at, "warning: ", format, args);
	va_end(args);
}

void diag_fail(Diag *diag, const char *format, ...)
{
	va_list args;
	va_start(args, format);
	locked_report(diag, (Location){0, 0, NULL}, "error: ", format, args);
	va_end(args);
	count_error(diag);
}

void diag_note(Diag *diag, const char *format, ...)
{
	if (diag->quiet)
		return;
	va_list args;
	va_start(args, format);
	locked_report(diag, (Location){0, 0, NULL}, "", format, args);
	va_end(args);
}

void diag_text(Diag *diag, const char *text)
{
	if (diag->quiet || !diag->out)
		return;
	pthread_mutex_lock(&diag->lock);
	fputs(text, diag->out);
	fflush(diag->out);
	pthread_mutex_unlock(&diag->lock);
}

void diag_set_quiet(Diag *diag, bool quiet)
{
	diag->quiet = quiet;
}

void diag_set_warnings(Diag *diag, bool shown)
{
	diag->no_warnings = !shown;
}

int diag_errors(const Diag *diag)
{
	return diag->errors;
}

bool diag_is_full(const Diag *diag)
{
	return diag->errors >= FULL;
}
