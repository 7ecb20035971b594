#include "cli/options.h"

#include <ctype.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef enum KeyKind {
	KEY_FLAG, /* bool */
	KEY_WHOLE, /* int; "493.0023" is cut to 493, as POV-Ray does */
	KEY_REAL, /* double */
	KEY_TEXT, /* const char * */
	KEY_CALL, /* a function of its own */
	KEY_NOTHING_FLAG,
	KEY_NOTHING_WHOLE,
	KEY_NOTHING_REAL,
	KEY_NOTHING_TEXT /* taken, means nothing here */
} KeyKind;

typedef bool KeyCall(Options *options, const char *value);

typedef struct Key {
	const char *name;
	KeyKind kind;
	size_t field;
	double lowest, highest; /* values outside are moved to the nearest */
	KeyCall *call;
} Key;

static KeyCall set_file_type, set_gamma, set_clock, set_declare, set_library_path,
	set_dither_method, set_create_ini, set_verbose, set_jitter, set_all_console, set_version,
	set_statistics_file, set_block_size;

#define FIELD(name) offsetof(Options, name)
#define NOTHING(kind) KEY_NOTHING_##kind, 0, 0, 0, NULL
#define CALL(function) KEY_CALL, 0, 0, 0, function
#define FLAG(name) KEY_FLAG, FIELD(name), 0, 0, NULL
#define TEXT(name) KEY_TEXT, FIELD(name), 0, 0, NULL
#define ANY -1e300, 1e300, NULL

static const Key keys[] = {
	{"All_Console", CALL(set_all_console)},
	{"All_File", NOTHING(TEXT)},
	{"Antialias", FLAG(antialias)},
	{"Antialias_Depth", KEY_WHOLE, FIELD(depth), 1, 9, NULL},
	{"Antialias_Gamma", KEY_REAL, FIELD(antialias_gamma), 1e-3, 100, NULL},
	{"Antialias_Threshold", KEY_REAL, FIELD(threshold), 0, 1e300, NULL},
	{"Append_File", NOTHING(FLAG)},
	{"Bits_Per_Color", KEY_WHOLE, FIELD(bits), 5, 16, NULL},
	{"Bounding", NOTHING(FLAG)},
	{"Bounding_Method", NOTHING(WHOLE)},
	{"Bounding_Threshold", NOTHING(WHOLE)},
	{"BSP_BaseAccessCost", NOTHING(REAL)},
	{"BSP_ChildAccessCost", NOTHING(REAL)},
	{"BSP_IsectCost", NOTHING(REAL)},
	{"BSP_MaxDepth", NOTHING(WHOLE)},
	{"BSP_MissChance", NOTHING(REAL)},
	{"Clock", CALL(set_clock)},
	{"Compression", KEY_WHOLE, FIELD(compression), 0, 100, NULL},
	{"Continue_Trace", FLAG(resume)},
	{"Create_Ini", CALL(set_create_ini)},
	{"Cyclic_Animation", FLAG(cyclic)},
	{"Debug_Console", FLAG(show_debug)},
	{"Debug_File", NOTHING(TEXT)},
	{"Declare", CALL(set_declare)},
	{"Display", NOTHING(FLAG)},
	{"Display_Gamma", NOTHING(TEXT)},
	{"Dither", FLAG(dither)},
	{"Dither_Method", CALL(set_dither_method)},
	{"Draw_Vistas", NOTHING(FLAG)},
	{"End_Column", KEY_REAL, FIELD(end_column), ANY},
	{"End_Row", KEY_REAL, FIELD(end_row), ANY},
	{"Fatal_Console", NOTHING(FLAG)},
	{"Fatal_Error_Command", TEXT(shell_command[SHELL_FATAL_ERROR])},
	{"Fatal_Error_Return", TEXT(shell_return[SHELL_FATAL_ERROR])},
	{"Fatal_File", NOTHING(TEXT)},
	{"Field_Render", NOTHING(FLAG)},
	{"File_Gamma", CALL(set_gamma)},
	{"Final_Clock", KEY_REAL, FIELD(final_clock), ANY},
	{"Final_Frame", KEY_WHOLE, FIELD(final_frame), 0, OPTIONS_MOST_WHOLE, NULL},
	{"Frame_Step", KEY_WHOLE, FIELD(frame_step), 1, OPTIONS_MOST_WHOLE, NULL},
	{"Grayscale_Output", FLAG(gray)},
	{"Height", KEY_WHOLE, FIELD(height), 0, OPTIONS_MOST_WHOLE, NULL},
	{"High_Reproducibility", NOTHING(FLAG)},
	{"Include_Header", TEXT(include_header)},
	{"Initial_Clock", KEY_REAL, FIELD(initial_clock), ANY},
	{"Initial_Frame", KEY_WHOLE, FIELD(initial_frame), 0, OPTIONS_MOST_WHOLE, NULL},
	{"Input_File_Name", TEXT(input)},
	{"Jitter", FLAG(jitter)},
	{"Jitter_Amount", CALL(set_jitter)},
	{"Library_Path", CALL(set_library_path)},
	{"Light_Buffer", NOTHING(FLAG)},
	{"Max_Image_Buffer_Memory", NOTHING(WHOLE)},
	{"Odd_Field", NOTHING(FLAG)},
	{"Output_Alpha", FLAG(alpha)},
	{"Output_File_Name", TEXT(output)},
	{"Output_File_Type", CALL(set_file_type)},
	{"Output_To_File", FLAG(to_file)},
	{"Palette", NOTHING(TEXT)},
	{"Pause_When_Done", NOTHING(FLAG)},
	{"Post_Frame_Command", TEXT(shell_command[SHELL_POST_FRAME])},
	{"Post_Frame_Return", TEXT(shell_return[SHELL_POST_FRAME])},
	{"Post_Scene_Command", TEXT(shell_command[SHELL_POST_SCENE])},
	{"Post_Scene_Return", TEXT(shell_return[SHELL_POST_SCENE])},
	{"Pre_Frame_Command", TEXT(shell_command[SHELL_PRE_FRAME])},
	{"Pre_Frame_Return", TEXT(shell_return[SHELL_PRE_FRAME])},
	{"Pre_Scene_Command", TEXT(shell_command[SHELL_PRE_SCENE])},
	{"Pre_Scene_Return", TEXT(shell_return[SHELL_PRE_SCENE])},
	{"Preview_End_Size", NOTHING(WHOLE)},
	{"Preview_Start_Size", NOTHING(WHOLE)},
	{"Quality", KEY_WHOLE, FIELD(quality), 0, 11, NULL},
	{"Radiosity_File_Name", NOTHING(TEXT)},
	{"Radiosity_From_File", NOTHING(FLAG)},
	{"Radiosity_To_File", NOTHING(FLAG)},
	{"Radiosity_Vain_Pretrace", NOTHING(FLAG)},
	{"Real_Time_Raytracing", NOTHING(FLAG)},
	{"Remove_Bounds", NOTHING(FLAG)},
	{"Render_Block_Size", CALL(set_block_size)},
	{"Render_Block_Step", NOTHING(WHOLE)},
	{"Render_Console", FLAG(show_render)},
	{"Render_File", NOTHING(TEXT)},
	{"Render_Pattern", NOTHING(WHOLE)},
	{"Sampling_Method", KEY_WHOLE, FIELD(sampling_method), 1, 2, NULL},
	{"Split_Unions", NOTHING(FLAG)},
	{"Start_Column", KEY_REAL, FIELD(start_column), ANY},
	{"Start_Row", KEY_REAL, FIELD(start_row), ANY},
	{"Statistic_Console", FLAG(show_statistics)},
	{"Statistic_File", CALL(set_statistics_file)},
	{"Subset_End_Frame", KEY_REAL, FIELD(subset_end), ANY},
	{"Subset_Start_Frame", KEY_REAL, FIELD(subset_start), ANY},
	{"Test_Abort", NOTHING(FLAG)},
	{"Test_Abort_Count", NOTHING(WHOLE)},
	{"User_Abort_Command", TEXT(shell_command[SHELL_USER_ABORT])},
	{"User_Abort_Return", TEXT(shell_return[SHELL_USER_ABORT])},
	{"Verbose", CALL(set_verbose)},
	{"Version", CALL(set_version)},
	{"Video_Mode", NOTHING(TEXT)},
	{"Vista_Buffer", NOTHING(FLAG)},
	{"Warning_Console", FLAG(show_warnings)},
	{"Warning_File", NOTHING(TEXT)},
	{"Warning_Level", KEY_WHOLE, FIELD(warning_level), 0, 10, NULL},
	{"Width", KEY_WHOLE, FIELD(width), 0, OPTIONS_MOST_WHOLE, NULL},
	{"Work_Threads", KEY_WHOLE, FIELD(threads), 0, 512, NULL},
};

Options options_default(Arena *arena)
{
	Options options = {
		.arena = arena,
		.width = 800,
		.height = 600,
		.start_column = -1,
		.end_column = -1,
		.start_row = -1,
		.end_row = -1,
		.to_file = true,
		.file_type = "N",
		.format = IMAGE_PNG,
		.bits = 8,
		.file_gamma = -1,
		.quality = 9,
		.sampling_method = 1,
		.threshold = 0.3,
		.depth = 3,
		.jitter = true,
		.jitter_amount = 1,
		.antialias_gamma = 2.5,
		.initial_frame = -1,
		.final_frame = -1,
		.final_clock = 1,
		.subset_start = -1,
		.subset_end = -1,
		.frame_step = 1,
		.show_debug = true,
		.show_render = true,
		.show_statistics = true,
		.show_warnings = true,
		.warning_level = 10,
		.ignored = "",
	};
	return options;
}

bool options_truth(const char *text)
{
	static const char *const words[] = {"yes", "on", "true", "1"};
	for (size_t i = 0; i < sizeof words / sizeof *words; i++)
		if (strcasecmp(text, words[i]) == 0)
			return true;
	return false;
}

/* A number that is the whole text and starts with a sign or digit: POV-Ray refuses ".3". */
static bool read_number(const char *text, double *out)
{
	const char *first = *text == '+' || *text == '-' ? text + 1 : text;
	const char *digit = *first == '.' ? first + 1 : first;
	char *end;
	if (!isdigit((unsigned char)*digit) || first[1] == 'x' || first[1] == 'X')
		return false;
	*out = strtod(text, &end);
	return *end == 0;
}

static double clamped(const Key *key, double value)
{
	return value < key->lowest ? key->lowest : value > key->highest ? key->highest : value;
}

/* Turning such a thing off is no news to anybody, so only what is turned on gets here. */
static void ignore(Options *options, const char *name)
{
	if (!strstr(options->ignored, name))
		options->ignored = arena_printf(options->arena, "%s%s%s", options->ignored,
						*options->ignored ? ", " : "", name);
}

static bool set_field(Options *options, const Key *key, const char *value)
{
	char *field = (char *)options + key->field;
	double number = 0;
	bool numeric = key->kind == KEY_WHOLE || key->kind == KEY_REAL ||
		       key->kind == KEY_NOTHING_WHOLE || key->kind == KEY_NOTHING_REAL;
	if (numeric && !read_number(value, &number))
		return false;
	switch (key->kind) {
	case KEY_FLAG: *(bool *)field = options_truth(value); return true;
	case KEY_WHOLE:
		*(int *)field = (int)clamped(key, number);
		return fabs(number) <= OPTIONS_MOST_WHOLE;
	case KEY_REAL: *(double *)field = clamped(key, number); return true;
	case KEY_TEXT:
		*(const char **)field = arena_strdup(options->arena, value);
		return *value != 0;
	case KEY_CALL: return key->call(options, value);
	case KEY_NOTHING_FLAG:
		if (options_truth(value))
			ignore(options, key->name);
		return true;
	case KEY_NOTHING_WHOLE:
	case KEY_NOTHING_REAL:
	case KEY_NOTHING_TEXT: ignore(options, key->name); return true;
	}
	return false;
}

bool options_set(Options *options, const char *name, const char *value, Diag *diag)
{
	if (strcasecmp(name, "Include_Ini") == 0)
		return options_read_ini(options, value, diag);
	for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
		if (strcasecmp(keys[i].name, name) != 0)
			continue;
		if (set_field(options, &keys[i], value))
			return true;
		diag_fail(diag, "the option %s does not take \"%s\"%s", keys[i].name, value,
			  keys[i].kind == KEY_WHOLE ? ", only whole numbers up to a billion" : "");
		return false;
	}
	diag_fail(diag, "unknown option %s=%s", name, value);
	return false;
}

/* A letter and, for PNG and PPM, bits per colour; bits outside 5 to 16 are moved inside. */
static bool set_file_type(Options *options, const char *value)
{
	static const struct { char letter; ImageFormat format;
	} types[] = {
		{'B', IMAGE_BMP}, {'C', IMAGE_TGA_RLE}, {'E', IMAGE_EXR}, {'J', IMAGE_JPEG},
		{'N', IMAGE_PNG}, {'P', IMAGE_PPM},     {'T', IMAGE_TGA},
	};
	double bits = options->bits;
	if (value[0] && value[1] && !read_number(value + 1, &bits))
		return false;
	for (size_t i = 0; i < sizeof types / sizeof *types; i++)
		if (toupper((unsigned char)value[0]) == types[i].letter) {
			options->format = types[i].format;
			options->bits = bits < 5 ? 5 : bits > 16 ? 16 : (int)bits;
			options->file_type = arena_strdup(options->arena, value);
			return true;
		}
	return false;
}

static bool set_gamma(Options *options, const char *value)
{
	double gamma;
	if (strcasecmp(value, "srgb") == 0)
		gamma = -1;
	else if (!read_number(value, &gamma) || gamma <= 0)
		return false;
	options->file_gamma = gamma;
	return true;
}

static bool set_clock(Options *options, const char *value)
{
	options->clock_said = true;
	return read_number(value, &options->clock);
}

static bool set_verbose(Options *options, const char *value)
{
	options->verbose = options_truth(value);
	options->verbose_said = true;
	return true;
}

static bool set_version(Options *options, const char *value)
{
	return read_number(value, &options->version) && options->version > 0;
}

static bool set_block_size(Options *options, const char *value)
{
	double size;
	ignore(options, "Render_Block_Size");
	return read_number(value, &size) && size >= 4;
}

static bool set_jitter(Options *options, const char *value)
{
	double amount;
	if (!read_number(value, &amount))
		return false;
	options->jitter_amount = amount > 1 ? 1 : amount > 0 ? amount : 0;
	if (amount <= 0)
		options->jitter = false;
	return true;
}

static bool set_all_console(Options *options, const char *value)
{
	bool shown = options_truth(value);
	options->show_debug = options->show_render = options->show_statistics =
		options->show_warnings = shown;
	return true;
}

static bool set_statistics_file(Options *options, const char *value)
{
	static const char *const refusals[] = {"no", "off", "false", "0"};
	options->statistics_file = arena_strdup(options->arena,
						options_truth(value) ? "STATS.OUT" : value);
	for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++)
		if (strcasecmp(value, refusals[i]) == 0)
			options->statistics_file = NULL;
	return true;
}

static bool set_create_ini(Options *options, const char *value)
{
	static const char *const refusals[] = {"no", "off", "false", "0"};
	options->create_ini = arena_strdup(options->arena, options_truth(value) ? "" : value);
	for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++)
		if (strcasecmp(value, refusals[i]) == 0)
			options->create_ini = NULL;
	return true;
}

/* POV-Ray's other methods are taken, too; all mean Floyd and Steinberg's here. */
static bool set_dither_method(Options *options, const char *value)
{
	static const char *const methods[] = {"B2", "B3", "B4", "D1", "D2", "FS"};
	for (size_t i = 0; i < sizeof methods / sizeof *methods; i++)
		if (strcasecmp(value, methods[i]) == 0) {
			if (i + 1 < sizeof methods / sizeof *methods)
				ignore(options, "Dither_Method");
			return true;
		}
	return false;
}

static bool set_library_path(Options *options, const char *value)
{
	if (*value == 0 || options->library_path_count == OPTIONS_MAXIMUM_PATHS)
		return false;
	for (int i = 0; i < options->library_path_count; i++)
		if (strcmp(options->library_paths[i], value) == 0)
			return true;
	options->library_paths[options->library_path_count++] = arena_strdup(options->arena, value);
	return true;
}

/* Name=number or Name="text"; a number that is none counts as far as it goes, as in POV-Ray. */
static bool set_declare(Options *options, const char *value)
{
	const char *equals = strchr(value, '=');
	size_t length = equals ? (size_t)(equals - value) : strlen(value);
	if (length == 0 || options->constant_count == OPTIONS_MAXIMUM_CONSTANTS)
		return false;
	ReaderConstant *constant = &options->constants[options->constant_count++];
	const char *text = equals ? equals + 1 : "";
	size_t size = strlen(text);
	*constant = (ReaderConstant){.name = arena_strndup(options->arena, value, length)};
	constant->is_string = size >= 2 && text[0] == '"' && text[size - 1] == '"';
	constant->text = constant->is_string ? arena_strndup(options->arena, text + 1, size - 2)
	                                     : arena_strdup(options->arena, text);
	constant->number = strtod(text, NULL);
	return true;
}
