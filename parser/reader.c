#include "parser/reader.h"

#include <stdlib.h>
#include <string.h>

#include "base/path.h"
#include "lang/build.h"
#include "lang/files.h"
#include "parser/grammar.h"
#include "parser/state.h"

/* What a scene without #version is rendered as, though the word `version` reads 3.7; as POV-Ray 3.7
 * has it. */
static const double VERSION_UNSAID = 3.62;

bool reader_has_failed(const Reader *reader)
{
	return diag_errors(reader->context.diag) > reader->errors_before;
}

/* The scene's own folder stands first among the library paths. */
static void set_library_paths(Context *context, const ReaderOptions *options)
{
	int count = options->library_path_count + 1;
	const char **paths = ARENA_ARRAY(context->parse, const char *, count);
	const char *slash = strrchr(options->path, '/');
	paths[0] = slash ? arena_strndup(context->parse, options->path,
					 (size_t)(slash - options->path + 1))
			 : "";
	for (int i = 1; i < count; i++)
		paths[i] = options->library_paths[i - 1];
	context->library_paths = paths;
	context->library_path_count = count;
}

static void set_context(Reader *reader, const ReaderOptions *options, SceneBuilder *builder,
			Diag *diag)
{
	reader->context = (Context){
		.diag = diag,
		.parse = arena_create(),
		.items = arena_create(),
		.builder = builder,
		.reader = reader,
		.clock = options->clock,
		.clock_delta = options->clock_delta,
		.initial_clock = options->initial_clock,
		.final_clock = options->final_clock,
		.frame_number = options->frame_number,
		.initial_frame = options->initial_frame,
		.final_frame = options->final_frame,
		.input_file_name = path_file_name(options->path),
		.clock_on = options->clock_on,
		.image_width = options->image_width,
		.image_height = options->image_height,
		.quick_colors = options->quick_colors,
		.version = options->version > 0 ? options->version : 3.7,
		.allow_write_anywhere = options->allow_write_anywhere,
		.read_paths = options->allowed_read_paths,
		.read_path_count = options->allowed_read_path_count,
	};
	set_library_paths(&reader->context, options);
	reader->context.symbols = reader->symbols = symbols_create(builder->arena);
	build_init(&reader->context);
}

static void declare_constants(Reader *reader, const ReaderOptions *options)
{
	for (int i = 0; i < options->constant_count; i++) {
		const ReaderConstant *constant = &options->constants[i];
		Name *name = symbols_intern(reader->symbols, constant->name,
					    strlen(constant->name));
		Value value = constant->is_string ? value_string(arena_strdup(reader->context.parse,
									      constant->text))
						  : value_float(constant->number);
		symbols_declare(reader->symbols, name, value, false);
	}
}

static bool begins_item(Reader *reader, const Token *token)
{
	const Token *next = source_peek(reader, 1);
	if (token->kind == TOKEN_DIRECTIVE)
		return true;
	if (token->kind != TOKEN_NAME || !next || next->kind != TOKEN_SIGN)
		return false;
	const Symbol *symbol = token->name->symbol;
	if (symbol && symbol->value.kind == VALUE_MACRO)
		return next->code == '(';
	return token->name->word != W_NONE && next->code == '{';
}

/* After a mistake between items: on to what looks like the next one, behind what is open. */
static void skip_to_item(Reader *reader)
{
	const Token *token;
	reader->has_ahead = false;
	while ((token = source_peek(reader, 0)) && !begins_item(reader, token))
		source_top(reader)->position++;
}

static void give_to_builder(Reader *reader, const Node *item)
{
	if (item->word == W_default)
		build_defaults(&reader->context, item->children);
	else
		build_scene_item(&reader->context, item);
}

static bool read_item(Reader *reader)
{
	Frame frame;
	ArenaMark mark = arena_mark(reader->context.items);
	bool good = frame_parse(reader, S_ITEM, FRAME_RUNS_ON, &frame);
	if (good && !frame.at_end)
		give_to_builder(reader, frame.nodes);
	else if (!good && !frame.nodes && !reader->stopped)
		skip_to_item(reader);
	arena_rewind(reader->context.items, mark);
	return !frame.at_end && !reader->stopped && !diag_is_full(reader->context.diag);
}

static void read_scene(Reader *reader, const ReaderOptions *options)
{
	Location nowhere = {0};
	declare_constants(reader, options);
	if (!include_file(reader, options->path, nowhere))
		return;
	if (options->header_include && !include_file(reader, options->header_include, nowhere))
		return;
	while (read_item(reader))
		;
	if (!reader->version_given)
		reader->context.builder->settings.version = VERSION_UNSAID;
}

static void destroy(Reader *reader)
{
	for (TokenFile *file = reader->files; file; file = file->next)
		free(file->tokens);
	symbols_destroy(reader->symbols);
	arena_destroy(reader->context.items);
	arena_destroy(reader->context.parse);
	free(reader->sources);
	free(reader->loops);
	free(reader->values);
	free(reader->braces);
	free(reader);
}

bool reader_read(const ReaderOptions *options, SceneBuilder *builder, Diag *diag)
{
	Reader *reader = memory_alloc(sizeof *reader);
	memset(reader, 0, sizeof *reader);
	reader->options = options;
	reader->errors_before = diag_errors(diag);
	set_context(reader, options, builder, diag);
	if (options->version > 0)
		builder->settings.version = options->version;
	reader->version_given = options->version > 0;
	read_scene(reader, options);
	files_close_all(&reader->context);
	bool interrupted = options->interrupted && *options->interrupted;
	bool good = !reader_has_failed(reader) && !interrupted;
	destroy(reader);
	return good;
}
