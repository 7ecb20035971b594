/* The words of a command line: long options, switches, keys, INI files, scenes. */
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "cli/options.h"

typedef bool LongCall(Options *options, const char *value, Diag *diag);

typedef struct LongOption {
	const char *name;
	const char *key; /* what it is short for; or NULL */
	LongCall *call;
	bool takes_value;
} LongOption;

static bool set_seed(Options *options, const char *value, Diag *diag)
{
	char *end;
	errno = 0;
	options->seed = strtoull(value, &end, 0);
	if (*value && !*end && *value != '-' && errno == 0)
		return true;
	diag_fail(diag, "--seed wants a whole number of at most 64 bits, not %s", value);
	return false;
}

static bool set_stats(Options *options, const char *value, Diag *diag)
{
	(void)diag;
	options->stats = value;
	return true;
}

static bool set_photons(Options *options, const char *value, Diag *diag)
{
	(void)diag;
	options->photons_file = value;
	return true;
}

static bool set_load_photons(Options *options, const char *value, Diag *diag)
{
	(void)diag;
	options->load_photons_file = value;
	return true;
}

static bool set_photons_landed(Options *options, const char *value, Diag *diag)
{
	(void)diag;
	options->photons_landed_file = value;
	return true;
}

static bool set_estimator(Options *options, const char *value, Diag *diag)
{
	options->estimator_said = true;
	if (photon_estimator_named(value, &options->estimator))
		return true;
	diag_fail(diag,
		  "--estimator: %s is no estimator (povray, nearest, diffusion, footprint, deep "
		  "or adaptive)",
		  value);
	return false;
}

static bool set_passes(Options *options, const char *value, Diag *diag)
{
	char *end;
	long passes = strtol(value, &end, 10);
	options->passes = (int)passes;
	if (*value && !*end && passes > 0 && passes <= PROGRESSIVE_MOST_PASSES)
		return true;
	diag_fail(diag, "--passes wants a whole number from 1 to %d, not %s",
		  PROGRESSIVE_MOST_PASSES, value);
	return false;
}

static bool set_update(Options *options, const char *value, Diag *diag)
{
	char *end;
	options->update = strtod(value, &end);
	if (*value && !*end && options->update > 0)
		return true;
	diag_fail(diag, "--update wants a number of seconds above 0, not %s", value);
	return false;
}

static bool set_allow_shell(Options *options, const char *value, Diag *diag)
{
	(void)value;
	(void)diag;
	return options->allow_shell = true;
}

static bool set_allow_write(Options *options, const char *value, Diag *diag)
{
	(void)value;
	(void)diag;
	return options->allow_write = true;
}

static bool set_quiet(Options *options, const char *value, Diag *diag)
{
	(void)value;
	return options_set(options, "All_Console", "off", diag) &&
	       options_set(options, "Verbose", "off", diag);
}

static bool set_help(Options *options, const char *value, Diag *diag)
{
	(void)value;
	(void)diag;
	return options->help = true;
}

static bool set_show_version(Options *options, const char *value, Diag *diag)
{
	(void)value;
	(void)diag;
	return options->show_version = true;
}

static const LongOption long_options[] = {
	{"allow-shell", NULL, set_allow_shell, false},
	{"allow-write", NULL, set_allow_write, false},
	{"declare", "Declare", NULL, true},
	{"estimator", NULL, set_estimator, true},
	{"height", "Height", NULL, true},
	{"help", NULL, set_help, false},
	{"library-path", "Library_Path", NULL, true},
	{"load-photons", NULL, set_load_photons, true},
	{"output", "Output_File_Name", NULL, true},
	{"passes", NULL, set_passes, true},
	{"photons", NULL, set_photons, true},
	{"photons-landed", NULL, set_photons_landed, true},
	{"quality", "Quality", NULL, true},
	{"quiet", NULL, set_quiet, false},
	{"seed", NULL, set_seed, true},
	{"stats", NULL, set_stats, true},
	{"threads", "Work_Threads", NULL, true},
	{"update", NULL, set_update, true},
	{"version", NULL, set_show_version, false},
	{"width", "Width", NULL, true},
};

static const LongOption *find_long(const char *name, size_t length)
{
	for (size_t i = 0; i < sizeof long_options / sizeof *long_options; i++)
		if (strlen(long_options[i].name) == length &&
		    strncmp(long_options[i].name, name, length) == 0)
			return &long_options[i];
	return NULL;
}

/* --name, --name=value or --name value; *at is the word's place and moves over a value. */
static bool read_long(Options *options, int count, char **words, int *at, Diag *diag)
{
	const char *name = words[*at] + 2, *equals = strchr(name, '=');
	const LongOption *option = find_long(name, equals ? (size_t)(equals - name) : strlen(name));
	if (!option) {
		diag_fail(diag, "unknown option %s", words[*at]);
		return false;
	}
	const char *value = equals ? equals + 1 : NULL;
	if (option->takes_value && !value && *at + 1 < count)
		value = words[++*at];
	if (option->takes_value != (value != NULL)) {
		diag_fail(diag, "--%s %s a value", option->name,
			  option->takes_value ? "wants" : "takes no");
		return false;
	}
	return option->key ? options_set(options, option->key, value, diag)
			   : option->call(options, value, diag);
}

/* A name, then =. */
static const char *key_of(const char *word)
{
	const char *c = word;
	while (isalnum((unsigned char)*c) || *c == '_')
		c++;
	return c > word && *c == '=' ? c : NULL;
}

static bool ends_with(const char *word, const char *ending)
{
	size_t length = strlen(word), tail = strlen(ending);
	return length > tail && strcasecmp(word + length - tail, ending) == 0;
}

bool options_word(Options *options, const char *word, Diag *diag)
{
	const char *equals = key_of(word);
	if (*word == '+' || *word == '-')
		return options_switch(options, word, diag);
	if (equals) {
		const char *key = arena_strndup(options->arena, word, (size_t)(equals - word));
		return options_set(options, key, equals + 1, diag);
	}
	if (ends_with(word, ".ini") || (ends_with(word, "]") && strchr(word, '[')))
		return options_read_ini(options, word, diag);
	if (ends_with(word, ".pov"))
		return options_set(options, "Input_File_Name", word, diag);
	diag_fail(diag, "%s: neither a scene (.pov), an INI file (.ini) nor an option", word);
	return false;
}

bool options_command_line(Options *options, int count, char **words, Diag *diag)
{
	for (int i = 1; i < count; i++) {
		bool is_long = strncmp(words[i], "--", 2) == 0;
		if (!(is_long ? read_long(options, count, words, &i, diag)
			      : options_word(options, words[i], diag)))
			return false;
	}
	return true;
}
