// Contact sheet of figure 1: see figures.sh.
#include "sheet.inc"
#declare Photons = concat(str(Stored / 1000, 0, 0), "k photons, ");
#macro Place(Column) <8 + Column * 488, 8> #end
#macro Close(Method, Column, Caption)
  Panel(concat("1-", Method, ".png"), <1600, 1200>, <640, 780>, <480, 360>,
    Place(Column), 1, Caption)
#end
Close("0", 0, concat("(a) ", Photons, "15 nearest"))
Close("1", 1, concat("(b) ", Photons, "plain relaxation, 15 nearest"))
Close("6", 2, concat("(c) ", Photons, "constrained relaxation, the paper's steps"))
Close("3", 3, concat("(d) ", Photons, "constrained relaxation, 15 nearest"))
