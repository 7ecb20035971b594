/* From text to trees: directives, macros, expressions as the grammar and the directive layer see
 * them. */
#include <stdlib.h>

#include "check.h"
#include "parser_stub.h"

static void check_scene(const char *scene, const char *expected)
{
	char *text = parser_stub_read(scene);
	CHECK(text != NULL);
	if (text && strcmp(text, expected) != 0) {
		check_failures++;
		printf("---- of\n%s\n---- expected\n%s---- got\n%s", scene, expected, text);
	}
	free(text);
}

static void test_items(void)
{
	check_scene("sphere { <0,1,0>, 2 hollow scale 3 }", "(sphere <0,1,0> 2 hollow scale 3)\n");
	check_scene("union { box { 0, 1 } texture { pigment { color_map { [0, 0.5 rgb 1] } } } }",
	            "(union (box 0 1) (texture (pigment (color_map [0 0.5 color<1,1,1,0,0>]))))\n");
	check_scene("#declare T = texture { } texture { }\nsphere { T }", "(sphere {a texture})\n");
	check_scene("default { finish { ambient 1 } } #default { pigment { rgb 0 } }",
	            "default: (finish ambient 1)\ndefault: (pigment color<0,0,0,0,0>)\n");
	check_scene("/* a /* nested */ comment */ box { 1 } // end", "(box 1)\n");
	check_scene("box { \"a\\\"\\u00e9\" }", "(box \"a\"\xc3\xa9\")\n");
}

static void test_expressions(void)
{
	check_scene("box { 1+2*3 -1 }", "(box 6)\n");
	check_scene("box { (1 < 2 ? 5 : 6) <1,2,3>*2 -x }", "(box 5 <1,4,6>)\n");
	check_scene("box { <1 2 3>.y }", "(box 2)\n");
	check_scene("box { color red 1 green 0.5 filter 0.25 }", "(box color<1,0.5,0,0.25,0>)\n");
	check_scene("box { rgb <1,0.5,0> transmit 0.3 }", "(box color<1,0.5,0,0,0.3>)\n");
	check_scene("image_map { png \"a\" map_type 1 filter all 0.5 }",
		    "(image_map png \"a\" map_type 1 filter all 0.5)\n");
	check_scene("julia_fractal { 0 hypercomplex pwr(1 + 1, 0.3) }",
		    "(julia_fractal 0 hypercomplex pwr {2 0.3})\n");
	check_scene("global_settings { assumed_gamma srgb }",
		    "(global_settings assumed_gamma srgb)\n");
	check_scene("box { (1 | 0 & 0) (0 & 0 | 1) }", "(box 0 1)\n");
	check_scene("#declare F = function(x) { x | 0 & 0 } box { F(1) }", "(box 1)\n");
	check_scene("max_trace_level 1 + 6 box { 2 }", "max_trace_level 7\n(box 2)\n");
	check_scene("polynomial { 2, xyz(2,0,1-1): -1 xyz(0,0,0): 3, 0.5 }",
		    "(polynomial 2 [2 0 0 -1] [0 0 0 3] 0.5)\n");
	check_scene("#declare S = spline { linear_spline 0,<0,0> 1,<2,2> 2,<0,0> }\n"
		    "box { S(0.5) S(0.5, quadratic_spline) }",
	            "(box <1,1> <1.5,1.5>)\n");
}

static void test_directives(void)
{
	check_scene("#version 3.1 #declare A = 1 #declare B = A + 1\nbox { A B }", "(box 1 2)\n");
	check_scene("#if (0) box { 1 } #elseif (1) box { 2 } #else box { 3 } #end", "(box 2)\n");
	check_scene("#declare i = 0;\nunion { #while (i < 3) i #declare i = i + 1; #end }",
		    "(union 0 1 2)\n");
	check_scene("box { #for (I, 1, 2, 0.25) I, #end }", "(box 1 1.25 1.5 1.75 2)\n");
	check_scene("box { #switch (2) #case (1) 1 #break #range (2, 3) 2 #case (7) 3 #break #else "
		    "4 #end }", "(box 2 3)\n");
	check_scene("box { 1 + #if (1) 2 #else 3 #end }", "(box 3)\n");
	check_scene("#ifdef (A) box { 1 } #end #ifndef (A) box { 2 } #end #if (defined(A)) #end",
		    "(box 2)\n");
	check_scene("#declare A = array[2][2] { {1, 2}, {3, 4} }\n#declare A[1][0] = 7;\n"
		    "box { A[1][0] A[0][1] }", "(box 7 2)\n");
	check_scene("#declare S = array[2] { sphere { 0, 1 } box { 0, 1 } } object { S[1] }",
		    "(object {an object})\n");
}

static void test_macros(void)
{
	check_scene("#macro M(A, B) A + B #end box { 2 * M(3, 4) }", "(box 10)\n");
	check_scene("#macro M(A) #declare A = A + 1; #end #declare K = 1; M(K) M(K) box { K }",
		    "(box 3)\n");
	check_scene("#macro M(A) #declare A = 5; #end #declare K = array[2] {1, 2} M(K[1]) "
		    "box { K[0] K[1] }", "(box 1 5)\n");
	check_scene("#macro M() scale 2 rotate #end box { 1 M() x }",
		    "(box 1 scale 2 rotate <1,0,0>)\n");
	check_scene("#macro F(N) #if (N <= 1) 1 #else N * F(N - 1) #end #end box { F(5) }",
		    "(box 120)\n");
	check_scene("#macro M(N) #local R = N * 2; R #end #local R = 1; #local Q = M(4); box "
		    "{ R Q }", "(box 1 8)\n");
	check_scene("#macro M(A B,) box { A } box { B } #end #macro N() 1 #local T = 2; #end union "
		    "{ M(N() -2, 3) M(4 <1,2>) }",
	            "(union (box -1) (box 3) (box 4) (box <1,2>))\n");
	check_scene("#macro M() #local L = 5; L; #end #local Q = M() #if (Q = 5) box { Q } #end",
		    "(box 5)\n");
	check_scene("#macro M(T) box { T } #end #declare T = texture { } M(T)",
		    "(box {a texture})\n");
	check_scene("#macro M() #while (1) 1 #break #end #break 2 #end box { M() }", "(box 1)\n");
}

/* What #write makes of words for binary formats; as POV-Ray writes it. */
static void test_binary(void)
{
	static const unsigned char expected[] = {1, '2', 255, '|', 2, 1, 0, 1, 1, 2, 255, 255, 255,
						 254, '7'};
	unsigned char bytes[64];
	check_scene("#fopen F \"test_reader.bytes\" write #write (F, sint8 1, 2, uint8 300, \"|\", "
		    "uint16le 258 <256.4, 513>,"
	            "sint32be -2, uint8, 7)\n#fclose F box { 1 }", "(box 1)\n");
	FILE *file = fopen("test_reader.bytes", "rb");
	size_t length = file ? fread(bytes, 1, sizeof bytes, file) : 0;
	if (file)
		fclose(file);
	remove("test_reader.bytes");
	CHECK(length == sizeof expected && memcmp(bytes, expected, length) == 0);
}

int main(void)
{
	test_binary();
	test_items();
	test_expressions();
	test_directives();
	test_macros();
	return CHECK_RESULT();
}
