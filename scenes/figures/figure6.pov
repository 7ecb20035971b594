// Contact sheet of figure 6: see figures.sh.
#include "sheet.inc"
#declare Photons = concat(str(Stored / 1000, 0, 0), "k photons, ");
#macro Whole(File, Column, Row, Caption)
  Panel(concat("6-", File, ".png"), <480, 360>, <0, 0>, <480, 360>,
    <8 + Column * 488, 8 + Row * 392>, 1, Caption)
#end
Whole("0", 0, 0, concat("(a) ", Photons, "15 nearest"))
Whole("1", 1, 0, concat("(b) ", Photons, "plain relaxation, 15 nearest"))
Whole("2", 2, 0, concat("(c) ", Photons, "diffusion of 500"))
Whole("3", 3, 0, concat("(d) ", Photons, "constrained relaxation, 15 nearest"))
Whole("e", 0, 1, "(e) where they left the lamp")
Whole("f", 1, 1, "(f) edges of their paths, 3 blue to 6 red")
Whole("g", 2, 1, "(g) constraints of (d), red")
Whole("4", 3, 1, "(h) reference: progressive passes")
