/* INI files: keys, switches and file names, several words a line; sections; ; and # start comments
 * outside quotes. */
#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "cli/options.h"
#include "base/output_file.h"

enum { LINE_SIZE = 4096, MAXIMUM_DEPTH = 16 };

typedef struct IniReader {
	Options *options;
	Diag *diag;
	const char *path;
	const char *section; /* wanted; or NULL */
	int line;
	bool active;         /* lines at hand count */
	bool met;            /* the wanted section */
} IniReader;

/* Cuts a comment off and blanks at both ends; returns the first character. */
static char *trim(char *line)
{
	char quote = 0;
	for (char *c = line; *c; c++) {
		if (quote ? *c == quote : (*c == '"' || *c == '\''))
			quote = quote ? 0 : *c;
		else if (!quote && (*c == ';' || *c == '#'))
			*c = 0;
		if (!*c)
			break;
	}
	while (isspace((unsigned char)*line))
		line++;
	char *end = line + strlen(line);
	while (end > line && isspace((unsigned char)end[-1]))
		*--end = 0;
	return line;
}

/* Where the name before the first = ends, when the line is KEY=VALUE; else NULL. */
static char *key_end(char *line)
{
	char *c = line;
	while (isalnum((unsigned char)*c) || *c == '_')
		c++;
	char *end = c;
	while (isspace((unsigned char)*c))
		c++;
	return end > line && *c == '=' ? end : NULL;
}

static char *strip_quotes(char *text)
{
	size_t length = strlen(text);
	if (length < 2 || (*text != '"' && *text != '\'') || text[length - 1] != *text)
		return text;
	text[length - 1] = 0;
	return text + 1;
}

static bool read_key(IniReader *reader, char *line, char *end)
{
	char *value = strchr(end, '=') + 1;
	*end = 0;
	while (isspace((unsigned char)*value))
		value++;
	return options_set(reader->options, line, strip_quotes(value), reader->diag);
}

/* Switches and file names, apart by blanks; KEY=VALUE as the last of them. */
static bool read_words(IniReader *reader, char *line)
{
	while (*line) {
		char *end = line, *key = key_end(line);
		if (key)
			return read_key(reader, line, key);
		char quote = 0;
		for (; *end && (quote || !isspace((unsigned char)*end)); end++)
			if (quote ? *end == quote : (*end == '"' || *end == '\''))
				quote = quote ? 0 : *end;
		char *next = *end ? end + 1 : end;
		*end = 0;
		if (!options_word(reader->options, line, reader->diag))
			return false;
		while (isspace((unsigned char)*next))
			next++;
		line = next;
	}
	return true;
}

static bool read_line(IniReader *reader, char *line)
{
	line = trim(line);
	if (*line == '[') {
		char *end = strchr(line, ']');
		if (!end) {
			diag_fail(reader->diag, "a section's name has no end");
			return false;
		}
		*end = 0;
		reader->active = reader->section && strcasecmp(line + 1, reader->section) == 0;
		reader->met |= reader->active;
		return true;
	}
	return !reader->active || read_words(reader, line);
}

static bool read_lines(IniReader *reader, FILE *file)
{
	char line[LINE_SIZE];
	while (fgets(line, sizeof line, file)) {
		reader->line++;
		if (!read_line(reader, line)) {
			diag_fail(reader->diag, "in %s, line %d", reader->path, reader->line);
			return false;
		}
	}
	return true;
}

/* Opens a file here or along the library paths; *path gets where it was. */
static FILE *open_along_paths(Options *options, const char *name, const char **path)
{
	*path = name;
	FILE *file = fopen(name, "r");
	for (int i = 0; !file && *name != '/' && i < options->library_path_count; i++) {
		*path = arena_printf(options->arena, "%s/%s", options->library_paths[i], name);
		file = fopen(*path, "r");
	}
	return file;
}

bool options_read_ini(Options *options, const char *name, Diag *diag)
{
	IniReader reader = {.options = options, .diag = diag, .active = true};
	const char *bracket = strrchr(name, '['), *end = bracket ? strchr(bracket, ']') : NULL;
	if (bracket && end && end[1] == 0) {
		reader.section = arena_strndup(options->arena, bracket + 1,
					       (size_t)(end - bracket - 1));
		name = arena_strndup(options->arena, name, (size_t)(bracket - name));
	}
	if (options->ini_depth >= MAXIMUM_DEPTH) {
		diag_fail(diag, "%s: INI files include each other without end", name);
		return false;
	}
	FILE *file = open_along_paths(options, name, &reader.path);
	if (!file) {
		diag_fail(diag, "%s: cannot be read: %s", name, strerror(errno));
		return false;
	}
	options->ini_depth++;
	bool good = read_lines(&reader, file);
	options->ini_depth--;
	fclose(file);
	if (good && reader.section && !reader.met)
		diag_warning(diag, (Location){0}, "%s has no section [%s]", reader.path,
			     reader.section);
	return good;
}

static void write_flags(const Options *o, FILE *out)
{
	const struct { const char *key; bool value;
	} flags[] = {
		{"Antialias", o->antialias},     {"Continue_Trace", o->resume},
		{"Cyclic_Animation", o->cyclic}, {"Dither", o->dither},
		{"Jitter", o->jitter},           {"Output_Alpha", o->alpha},
		{"Output_To_File", o->to_file},
	};
	for (size_t i = 0; i < sizeof flags / sizeof *flags; i++)
		fprintf(out, "%s=%s\n", flags[i].key, flags[i].value ? "On" : "Off");
}

static void write_numbers(const Options *o, FILE *out)
{
	const struct { const char *key; double value, unsaid;
	} numbers[] = {
		{"Antialias_Depth", o->depth, -1},
		{"Antialias_Gamma", o->antialias_gamma, -1},
		{"Antialias_Threshold", o->threshold, -1},
		{"Bits_Per_Color", o->bits, -1},
		{"Clock", o->clock, o->clock_said ? o->clock - 1 : o->clock},
		{"End_Column", o->end_column, -1},
		{"End_Row", o->end_row, -1},
		{"Final_Clock", o->final_clock, 1},
		{"Final_Frame", o->final_frame, -1},
		{"Frame_Step", o->frame_step, 1},
		{"Height", o->height, -1},
		{"Initial_Clock", o->initial_clock, 0},
		{"Initial_Frame", o->initial_frame, -1},
		{"Jitter_Amount", o->jitter_amount, -1},
		{"Quality", o->quality, -1},
		{"Sampling_Method", o->sampling_method, -1},
		{"Start_Column", o->start_column, -1},
		{"Start_Row", o->start_row, -1},
		{"Subset_End_Frame", o->subset_end, -1},
		{"Subset_Start_Frame", o->subset_start, -1},
		{"Version", o->version, 0},
		{"Width", o->width, -1},
		{"Work_Threads", o->threads, 0},
	};
	for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
		if (numbers[i].value != numbers[i].unsaid)
			fprintf(out, "%s=%.12g\n", numbers[i].key, numbers[i].value);
}

static void write_texts(const Options *o, FILE *out)
{
	for (int i = 0; i < o->constant_count; i++)
		fprintf(out, o->constants[i].is_string ? "Declare=%s=\"%s\"\n" : "Declare=%s=%s\n",
			o->constants[i].name, o->constants[i].text);
	if (o->include_header)
		fprintf(out, "Include_Header=\"%s\"\n", o->include_header);
	if (o->input)
		fprintf(out, "Input_File_Name=\"%s\"\n", o->input);
	for (int i = 0; i < o->library_path_count; i++)
		fprintf(out, "Library_Path=\"%s\"\n", o->library_paths[i]);
	if (o->output)
		fprintf(out, "Output_File_Name=\"%s\"\n", o->output);
	fprintf(out, "Output_File_Type=%s\n", o->file_type);
}

bool options_write_ini(const Options *options, const char *path, Diag *diag)
{
	OutputFile file;
	if (!output_file_open(&file, path, diag))
		return false;
	write_flags(options, file.stream);
	write_numbers(options, file.stream);
	write_texts(options, file.stream);
	return output_file_commit(&file, diag);
}
