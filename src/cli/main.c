/* cognac: renders scenes written in POV-Ray's scene language. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/parallel.h"
#include "cli/run.h"
#include "config.h"

static void print_usage(void)
{
	fputs("usage: cognac [+SWITCH | -SWITCH | KEY=VALUE | FILE.ini[SECTION] | --OPTION]... "
	      "SCENE.pov\n"
	      "Renders a scene written in POV-Ray's scene language. Switches and keys are "
	      "POV-Ray's;\namong them:\n\n"
	      "  +IFILE +OFILE +WN +HN     scene, picture, width, height\n"
	      "  +FN +FT +FP +FE           as PNG, TGA, PPM, OpenEXR; +FN16: 16 bits per colour\n"
	      "  +A0.3 +AM2 +R3 +J1        antialiasing: threshold, method, depth, jitter\n"
	      "  +Q9 +LDIR +WTN +UA        quality, library path, threads, alpha\n"
	      "  +KFI1 +KFF20 +KC +SF3     animation: first and last frame, cyclic, subset\n"
	      "  +C                        go on with a render that was stopped\n"
	      "\n"
	      "      --allow-shell         run the shell commands of INI files\n"
	      "      --allow-write         let the scene write files anywhere\n"
	      "      --declare NAME=VALUE  as Declare=NAME=VALUE\n"
	      "      --height N, --width N, --output FILE, --quality N, --library-path DIR\n"
	      "      --quiet               no messages but errors\n"
	      "      --seed N              of all random numbers\n"
	      "      --stats FILE.json     write statistics\n"
	      "      --threads N           use N threads\n"
	      "      --update SECONDS      rewrite the picture so far that often\n"
	      "      --estimator NAME      of photons: povray, nearest, diffusion, footprint\n"
	      "      --photons FILE.ply, --load-photons FILE.ply   write or read the photons\n"
	      "      --photons-landed FILE.ply   write them as they are before relaxation\n"
	      "      --passes N            progressive photon passes\n"
	      "      --help, --version\n",
	      stdout);
}

/* The command line as one text, apart by blanks. */
static const char *joined(Arena *arena, int count, char **words)
{
	const char *text = "";
	for (int i = 1; i < count; i++)
		text = arena_printf(arena, "%s%s%s", text, i > 1 ? " " : "", words[i]);
	return text;
}

/* The INI file that every run starts with: the environment's POVINI, else povray.ini here, else the
 * user's. */
static bool read_first_ini(Options *options, Diag *diag)
{
	const char *named = getenv("POVINI"), *home = getenv("HOME");
	if (named && *named && access(named, R_OK) != 0) {
		diag_note(diag, "POVINI names %s, which cannot be read", named);
		return true;
	}
	if (named && *named)
		return options_read_ini(options, named, diag);
	if (access("povray.ini", R_OK) == 0)
		return options_read_ini(options, "povray.ini", diag);
	const char *own = home ? arena_printf(options->arena, "%s/.povray/3.7/povray.ini", home)
			       : "";
	return access(own, R_OK) != 0 || options_read_ini(options, own, diag);
}

static bool is_help(const char *word)
{
	static const char *const words[] = {"-?", "-h", "-help", "--help", "+H", "-H"};
	for (size_t i = 0; i < sizeof words / sizeof *words; i++)
		if (strcmp(word, words[i]) == 0)
			return true;
	return false;
}

static void prepare_messages(const Options *options, Diag *diag)
{
	diag_set_quiet(diag, !options->show_debug);
	diag_set_warnings(diag, options->show_warnings && options->warning_level > 0);
	if (*options->ignored && options->show_render)
		diag_note(diag, "taken, but without meaning here: %s", options->ignored);
}

static Status run_program(Options *options, int count, char **words, Diag *diag)
{
	if (!read_first_ini(options, diag) || !options_command_line(options, count, words, diag))
		return STATUS_FAILED;
	if (options->help) {
		print_usage();
		return STATUS_DONE;
	}
	if (options->show_version) {
		puts(PACKAGE_STRING);
		return STATUS_DONE;
	}
	if (!options->input) {
		diag_fail(diag, "no scene to render; cognac --help tells how to call it");
		return STATUS_FAILED;
	}
	prepare_messages(options, diag);
	parallel_set_threads(options->threads);
	return run_scene(options, joined(options->arena, count, words), diag);
}

int main(int argc, char **argv)
{
	Arena *arena = arena_create();
	Diag *diag = diag_create(stderr);
	Options options = options_default(arena);
	Status status;
	if (argc == 2 && is_help(argv[1])) {
		print_usage();
		status = STATUS_DONE;
	} else {
		status = run_program(&options, argc, argv, diag);
	}
	diag_destroy(diag);
	arena_destroy(arena);
	return (int)status;
}
