/* #debug, #warning, #error... and #fopen, #read, #write, #fclose. */
#include "lang/files.h"
#include "parser/grammar.h"
#include "parser/state.h"

void stream_directive(Reader *reader, Word word, Location where)
{
	const char *text;
	if (!frame_string(reader, &text))
		return;
	if (word == W_error) {
		diag_error(reader->context.diag, where, "%s", text);
		reader->stopped = true;
	} else {
		diag_text(reader->context.diag, text);
	}
}

/* The open file that a name stands for; NULL after a report. */
static SceneFile *read_file(Reader *reader, Name **name)
{
	Location where = source_here(reader);
	*name = source_take_name(reader, "a file's name");
	if (!*name)
		return NULL;
	const Value *value = (*name)->symbol ? symbol_value((*name)->symbol) : NULL;
	if (value && value->kind == VALUE_FILE)
		return value->file;
	diag_error(reader->context.diag, where, "'%s' is no open file", (*name)->text);
	return NULL;
}

static bool read_mode(Reader *reader, FileMode *mode)
{
	Location where = source_here(reader);
	const Token *token = source_peek(reader, 0);
	switch (token && token->kind == TOKEN_NAME ? token->name->word : W_NONE) {
	case W_read: *mode = FILE_READ; break;
	case W_write: *mode = FILE_WRITE; break;
	case W_append: *mode = FILE_APPEND; break;
	default:
		diag_error(reader->context.diag, where, "expected read, write or append");
		return false;
	}
	source_top(reader)->position++;
	return true;
}

static void run_fopen(Reader *reader)
{
	const char *path;
	FileMode mode;
	Name *name = source_take_name(reader, "an identifier for the file");
	Location where = source_here(reader);
	if (!name || !frame_string(reader, &path) || !read_mode(reader, &mode))
		return;
	SceneFile *file = files_open(&reader->context, path, mode, where);
	Value value = file ? (Value){.kind = VALUE_FILE, .file = file} : value_none();
	symbols_declare(reader->symbols, name, value, false)->poisoned = !file;
}

static void run_fclose(Reader *reader)
{
	Name *name;
	const Token *next = source_peek(reader, 0);
	if (next && next->kind == TOKEN_NAME &&
	    !next->name->symbol) { /* #read reached the end and closed it */
		source_top(reader)->position++;
		return;
	}
	SceneFile *file = read_file(reader, &name);
	if (!file)
		return;
	files_close(file);
	symbols_remove(reader->symbols, name);
}

/* Variables for which nothing is left stay as they are. */
static bool read_variable(Reader *reader, SceneFile *file)
{
	Value value;
	return files_read(&reader->context, file, &value, source_here(reader)) &&
	       declare_assign(reader, value);
}

static void run_read(Reader *reader)
{
	Name *name;
	if (!source_take_sign(reader, '(', "#read"))
		return;
	SceneFile *file = read_file(reader, &name);
	bool good = file != NULL;
	while (good && source_accept_sign(reader, ','))
		good = read_variable(reader, file);
	if (good)
		source_take_sign(reader, ')', "the variables");
	else
		lexer_skip_rest(reader, '(', ')');
	/* `#while (defined(File))` is how scenes read to the end. */
	if (file && files_at_end(file)) {
		files_close(file);
		symbols_remove(reader->symbols, name);
	}
}

/* uint8, sint16le...: how the values up to the next comma are written; NULL when none of these
 * words is next. */
static const FileInteger *read_integer_format(Reader *reader)
{
	const Token *token = source_peek(reader, 0);
	const FileInteger *format = !reader->has_ahead && token && token->kind == TOKEN_NAME &&
						    !token->name->symbol
					    ? files_integer(token->name->word)
					    : NULL;
	source_top(reader)->position += format != NULL;
	return format && source_accept_sign(reader, ',')
		       ? NULL
		       : format; /* a comma ends what the word holds for */
}

/* One value; *format lasts to the next comma. The sign behind it, or 0 when another value follows
 * or after a report. */
static int write_value(Reader *reader, SceneFile *file, const FileInteger *format)
{
	Frame frame;
	Semantic value;
	Location where = source_here(reader);
	if (!frame_parse(reader, S_EXPRESSION, FRAME_RUNS_ON, &frame))
		return ')';
	if (format)
		files_write_integer(&reader->context, file, format, frame.value, where);
	else
		files_write(&reader->context, file, frame.value, where);
	int kind = lexer_fetch(reader, &value, &where);
	if (kind == READER_YYEOF && !reader->stopped)
		diag_error(reader->context.diag, where, "the arguments of #write are never closed");
	if (kind == READER_YYEOF || kind == ')')
		return ')';
	if (kind != ',')
		lexer_give_back(reader, kind, &value, where);
	return kind == ',' ? ',' : 0;
}

static void run_write(Reader *reader)
{
	Name *name;
	if (!source_take_sign(reader, '(', "#write"))
		return;
	SceneFile *file = read_file(reader, &name);
	if (!file || source_accept_sign(reader, ')'))
		return;
	source_accept_sign(reader, ',');
	int sign = ',';
	const FileInteger *format = NULL;
	while (sign != ')' && !reader->stopped) {
		if (sign == ',')
			format = read_integer_format(reader);
		sign = write_value(reader, file, format);
	}
}

void file_directive(Reader *reader, Word word, Location where)
{
	(void)where;
	switch (word) {
	case W_fopen: run_fopen(reader); break;
	case W_fclose: run_fclose(reader); break;
	case W_read: run_read(reader); break;
	default: run_write(reader); break;
	}
}
