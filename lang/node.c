#include "lang/node_print.h"

static void print_value(FILE *out, Value value)
{
	int count = value.kind == VALUE_VECTOR ? value.size : value.kind == VALUE_COLOR ? 5 : 0;
	if (value.kind == VALUE_FLOAT)
		fprintf(out, "%g", value.number);
	else if (value.kind == VALUE_STRING)
		fprintf(out, "\"%s\"", value.string);
	else if (count == 0)
		fprintf(out, "{%s}", value_describe(value));
	for (int i = 0; i < count; i++)
		fprintf(out, "%s%g%s",
			i                           ? ","
			: value.kind == VALUE_COLOR ? "color<"
						    : "<",
			value.v[i], i + 1 == count ? ">" : "");
}

static void print_one(FILE *out, const Node *node)
{
	switch (node->kind) {
	case NODE_VALUE: case NODE_ITEM:
		print_value(out, node->value);
		break;
	case NODE_WORD:
		fputs(word_text(node->word), out);
		break;
	case NODE_BLOCK: case NODE_ENTRY:
		fprintf(out, node->kind == NODE_BLOCK ? "(%s" : "[%s", word_text(node->word));
		if (node->children && node->kind == NODE_BLOCK)
			putc(' ', out);
		node_print(out, node->children);
		putc(node->kind == NODE_BLOCK ? ')' : ']', out);
		break;
	case NODE_PAIR:
		putc('{', out);
		node_print(out, node->children);
		putc('}', out);
		break;
	}
}

void node_print(FILE *out, const Node *nodes)
{
	for (; nodes; nodes = nodes->next) {
		print_one(out, nodes);
		if (nodes->next)
			putc(' ', out);
	}
}
