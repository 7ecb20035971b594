#version 3.7;
global_settings { assumed_gamma 1 }
// macros with side effects, arrays of arrays, string functions, #for, #range, #break
camera { location <0, 4, -9> look_at <0, 0, 0> angle 50 }
light_source { <5, 9, -8>, rgb 1 }
light_source { <-8, 3, -3>, rgb <.2, .2, .4> shadowless }
#declare Count = 0;
#macro Bump(N) #declare Count = Count + N; Count #end
#macro Swap(A, B) #local T = A; #declare A = B; #declare B = T; #end
#declare P = 1; #declare Q = 3; Swap(P, Q)
#declare Names = array[3][2] { { "ab", "c" }, { "dEf", "" }, { "ghij", "k" } };
#declare Nested = array[2]; #declare Nested[0] = array[2] { x, y }; #declare Nested[1] = array[3]
    { 1, 2, 3 };
plane { y, -1 pigment { checker rgb .9 rgb .5 } }
#for (I, 0, dimension_size(Names, 1) - 1)
  #for (J, 0, 1)
    #if (strlen(Names[I][J]) = 0) #break #end
    #local S = concat(strupr(Names[I][J]), substr("xyz", J + 1, 1), chr(asc("A") + I));
    cylinder { 0, y * strlen(S) / 3, .3 translate <I * 2 - 3, -1, J * 2>
      pigment { rgb <mod(asc(S), 5) / 5, select(strcmp(S, "CX"), 0, .5, 1), val(str(.25 * I, 0,
          2))> } }
  #end
#end
#for (I, 3, -1, -1.5) sphere { <I, 0, -2>, .25 pigment { rgb <1, .2, Bump(.2)> } } #end
#switch (Q)
  #range (0, .5) box { -.2, .2 translate <-3, 0, -2> pigment { red 1 } }
  #range (1, 2) box { -.2, .4 translate <-3, 0, -2> pigment { green 1 } }
  #case (3) sphere { <-3, 1, 0>, .4 pigment { blue 1 } } #break
  #else sphere { <-3, 1, 2>, 1 }
#end
sphere { Nested[0][1] * 2 + Nested[0][0] * Nested[1][2], .5 pigment { rgb <vlength(<1,2,2>) /
    3, P / 5, 0> } }
text { ttf "timrom.ttf" str(Count, 0, 3) .2, 0 scale .8 translate <-2, 1.2, 0> pigment { rgb <1,
    1, 0> } }
