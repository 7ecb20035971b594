/*
 * POV-Ray's switches. A switch is short for a key that its sign turns on or off, a key that takes
 * the rest of the word, or both: +A0.1 is Antialias=on and Antialias_Threshold=0.1.
 */
#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "cli/options.h"

typedef enum Rest {
	REST_NONE,     /* nothing may follow */
	REST_OPTIONAL, /* a value may follow */
	REST_NEEDED    /* a value must follow */
} Rest;

typedef struct Switch {
	const char *letters;
	const char *flag;  /* turned on by +, off by -; or NULL */
	const char *value; /* gets what follows; or NULL */
	Rest rest;
} Switch;

/* The longest letters that fit count, so the order is free but for reading. */
static const Switch switches[] = {
	{"A", "Antialias", "Antialias_Threshold", REST_OPTIONAL},
	{"AG", NULL, "Antialias_Gamma", REST_NEEDED},
	{"AM", NULL, "Sampling_Method", REST_NEEDED},
	{"B", "Light_Buffer", NULL, REST_NONE}, /* POV-Ray's long gone Buffer_Output */
	{"BM", NULL, "Bounding_Method", REST_NEEDED},
	{"BS", NULL, "Render_Block_Size", REST_NEEDED},
	{"C", "Continue_Trace", NULL, REST_NONE},
	{"D", "Display", "Video_Mode", REST_OPTIONAL},
	{"EC", NULL, "End_Column", REST_NEEDED},
	{"EF", NULL, "Subset_End_Frame", REST_NEEDED},
	{"EP", NULL, "Preview_End_Size", REST_NEEDED},
	{"ER", NULL, "End_Row", REST_NEEDED},
	{"F", "Output_To_File", "Output_File_Type", REST_OPTIONAL},
	{"GA", "All_Console", "All_File", REST_OPTIONAL},
	{"GD", "Debug_Console", "Debug_File", REST_OPTIONAL},
	{"GF", "Fatal_Console", "Fatal_File", REST_OPTIONAL},
	{"GI", NULL, "Create_Ini", REST_NEEDED},
	{"GP", "Append_File", NULL, REST_NONE},
	{"GR", "Render_Console", "Render_File", REST_OPTIONAL},
	{"GS", "Statistic_Console", "Statistic_File", REST_OPTIONAL},
	{"GW", "Warning_Console", "Warning_File", REST_OPTIONAL},
	{"H", NULL, "Height", REST_NEEDED},
	{"HI", NULL, "Include_Header", REST_NEEDED},
	{"HR", "High_Reproducibility", NULL, REST_NONE},
	{"I", NULL, "Input_File_Name", REST_NEEDED},
	{"J", "Jitter", "Jitter_Amount", REST_OPTIONAL},
	{"K", NULL, "Clock", REST_NEEDED},
	{"KC", "Cyclic_Animation", NULL, REST_NONE},
	{"KF", NULL, "Final_Clock", REST_NEEDED},
	{"KFF", NULL, "Final_Frame", REST_NEEDED},
	{"KFI", NULL, "Initial_Frame", REST_NEEDED},
	{"KI", NULL, "Initial_Clock", REST_NEEDED},
	{"L", NULL, "Library_Path", REST_NEEDED},
	{"MB", "Bounding", "Bounding_Threshold", REST_OPTIONAL},
	{"MI", NULL, "Max_Image_Buffer_Memory", REST_NEEDED},
	{"MV", NULL, "Version", REST_NEEDED},
	{"O", NULL, "Output_File_Name", REST_NEEDED},
	{"P", "Pause_When_Done", NULL, REST_NONE},
	{"Q", NULL, "Quality", REST_NEEDED},
	{"R", NULL, "Antialias_Depth", REST_NEEDED},
	{"RF", NULL, "Radiosity_File_Name", REST_NEEDED},
	{"RFI", "Radiosity_From_File", NULL, REST_NONE},
	{"RFO", "Radiosity_To_File", NULL, REST_NONE},
	{"RP", NULL, "Render_Pattern", REST_NEEDED},
	{"RS", NULL, "Render_Block_Step", REST_NEEDED},
	{"RTR", "Real_Time_Raytracing", NULL, REST_NONE},
	{"RVP", "Radiosity_Vain_Pretrace", NULL, REST_NONE},
	{"SC", NULL, "Start_Column", REST_NEEDED},
	{"SF", NULL, "Subset_Start_Frame", REST_NEEDED},
	{"SP", NULL, "Preview_Start_Size", REST_NEEDED},
	{"SR", NULL, "Start_Row", REST_NEEDED},
	{"STP", NULL, "Frame_Step", REST_NEEDED},
	{"SU", "Split_Unions", NULL, REST_NONE},
	{"TH", "Dither", "Dither_Method", REST_OPTIONAL},
	{"UA", "Output_Alpha", NULL, REST_NONE},
	{"UD", "Draw_Vistas", NULL, REST_NONE},
	{"UF", "Field_Render", NULL, REST_NONE},
	{"UL", "Light_Buffer", NULL, REST_NONE},
	{"UO", "Odd_Field", NULL, REST_NONE},
	{"UR", "Remove_Bounds", NULL, REST_NONE},
	{"UV", "Vista_Buffer", NULL, REST_NONE},
	{"V", "Verbose", NULL, REST_NONE},
	{"W", NULL, "Width", REST_NEEDED},
	{"WL", NULL, "Warning_Level", REST_NEEDED},
	{"WT", NULL, "Work_Threads", REST_NEEDED},
	{"X", "Test_Abort", "Test_Abort_Count", REST_OPTIONAL},
};

static bool rest_fits(Rest rest, const char *text)
{
	return rest == REST_OPTIONAL || (rest == REST_NEEDED) == (*text != 0);
}

/* The switch with the longest letters that start the text and leave a fitting rest; NULL for none.
 */
static const Switch *find_switch(const char *text)
{
	const Switch *best = NULL;
	size_t longest = 0;
	for (size_t i = 0; i < sizeof switches / sizeof *switches; i++) {
		size_t length = strlen(switches[i].letters);
		if (length > longest && strncasecmp(text, switches[i].letters, length) == 0 &&
		    rest_fits(switches[i].rest, text + length)) {
			best = &switches[i];
			longest = length;
		}
	}
	return best;
}

/* Without one pair of enclosing quotes: +RF"name". */
static const char *unquoted(Options *options, const char *text)
{
	size_t length = strlen(text);
	if (length >= 2 && (*text == '"' || *text == '\'') && text[length - 1] == *text)
		return arena_strndup(options->arena, text + 1, length - 2);
	return text;
}

bool options_switch(Options *options, const char *word, Diag *diag)
{
	const Switch *found = find_switch(word + 1);
	if (!found) {
		diag_fail(diag, "unknown switch %s", word);
		return false;
	}
	const char *rest = word + 1 + strlen(found->letters);
	if (found->flag && !options_set(options, found->flag, *word == '+' ? "on" : "off", diag))
		return false;
	if (!*rest)
		return true;
	return options_set(options, found->value, unquoted(options, rest), diag);
}
