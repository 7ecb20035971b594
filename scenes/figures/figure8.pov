// Contact sheet of figure 8: see figures.sh.
#include "sheet.inc"
#declare Photons = concat(str(Stored / 1000, 0, 0), "k photons, ");
#macro Close(File, Column, Row, Caption)
  Panel(concat("8-", File, ".png"), <480, 400>, <0, 0>, <480, 400>,
    <8 + Column * 488, 8 + Row * 432>, 1, Caption)
#end
Close("0", 0, 0, concat("(a) ", Photons, "15 nearest"))
Close("1", 1, 0, concat("(b) ", Photons, "plain relaxation, 15 nearest"))
Close("2", 2, 0, concat("(c) ", Photons, "diffusion of 500"))
Close("d", 0, 1, "(d) where they left the lamp")
Close("e", 1, 1, "(e) constraints of (f), red")
Close("3", 2, 1, concat("(f) ", Photons, "constrained relaxation, 15 nearest"))
