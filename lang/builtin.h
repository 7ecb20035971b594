/*
 * The built-in functions of expressions: a row a word (lang/builtin.c), which says what arguments
 * it takes; families of functions have a file each. Shared by those files only; others call
 * expression_call.
 */
#ifndef LANG_BUILTIN_H
#define LANG_BUILTIN_H

#include "lang/expression.h"

/* A call whose arguments fit the row's signature; vectors are promoted to what the signature asks.
 */
typedef struct BuiltinCall {
	Context *context;
	Word word;
	const Value *args;
	int count;
	Location where;
} BuiltinCall;

/* One letter an argument: f float, v vector (or float, colour), s string, o object, a array, *
 * anything. `?` after a letter: it and all that follow may be missing; `+`: once or more often. */
typedef struct BuiltinRow {
	const char *signature;
	bool in_function;              /* may depend on a function's arguments */
	double (*one)(double);         /* what it computes: one of these three */
	double (*two)(double, double);
	Value (*run)(const BuiltinCall *call);
} BuiltinRow;

/* lang/builtin_float.c */
double builtin_int(double x);
double builtin_div(double a, double b);
double builtin_degrees(double radians);
double builtin_radians(double degrees);
double builtin_sqr(double x);
Value builtin_asin(const BuiltinCall *call);
Value builtin_acos(const BuiltinCall *call);
Value builtin_sqrt(const BuiltinCall *call);
Value builtin_logarithm(const BuiltinCall *call);
Value builtin_pow(const BuiltinCall *call);
Value builtin_atan2(const BuiltinCall *call);
Value builtin_extreme(const BuiltinCall *call); /* min, max */
Value builtin_bitwise(const BuiltinCall *call);
Value builtin_select(const BuiltinCall *call);
Value builtin_seed(const BuiltinCall *call);
Value builtin_rand(const BuiltinCall *call);

/* lang/builtin_vector.c */
Value builtin_vlength(const BuiltinCall *call);
Value builtin_vdot(const BuiltinCall *call);
Value builtin_vcross(const BuiltinCall *call);
Value builtin_vnormalize(const BuiltinCall *call);
Value builtin_vrotate(const BuiltinCall *call);
Value builtin_vaxis_rotate(const BuiltinCall *call);
Value builtin_vturbulence(const BuiltinCall *call);

/* lang/builtin_scene.c: what asks objects, arrays and files. */
Value builtin_inside(const BuiltinCall *call);
Value builtin_trace(const BuiltinCall *call);
Value builtin_extent(const BuiltinCall *call); /* min_extent, max_extent */
Value builtin_dimensions(const BuiltinCall *call);
Value builtin_dimension_size(const BuiltinCall *call);
Value builtin_defined(const BuiltinCall *call);
Value builtin_file_exists(const BuiltinCall *call);

/* lang/builtin_string.c */
Value builtin_asc(const BuiltinCall *call);
Value builtin_chr(const BuiltinCall *call);
Value builtin_concat(const BuiltinCall *call);
Value builtin_datetime(const BuiltinCall *call);
Value builtin_str(const BuiltinCall *call);
Value builtin_strcmp(const BuiltinCall *call);
Value builtin_strlen(const BuiltinCall *call);
Value builtin_case(const BuiltinCall *call); /* strlwr, strupr */
Value builtin_substr(const BuiltinCall *call);
Value builtin_val(const BuiltinCall *call);
Value builtin_vstr(const BuiltinCall *call);

#endif
