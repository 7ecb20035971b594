// Contact sheet of figure 9: see figures.sh.
#include "sheet.inc"
#macro Close(File, Column, Caption)
  Panel(concat("9-", File, ".png"), <480, 360>, <0, 0>, <480, 360>, <8 + Column * 488, 8>, 1, Caption)
#end
Close("466000", 0, concat("(a) ", str(Stored / 5000, 0, 0), "k photons, constrained relaxation"))
Close("2330000", 1, concat("(b) ", str(Stored / 1000, 0, 0), "k photons, constrained relaxation"))
Close("11500000", 2, concat("(c) ", str(Stored / 1000000 * 4.93, 0, 1), "M photons, constrained relaxation"))
Close("4", 3, "(d) reference: progressive passes")
Panel("9-wide.png", <480, 360>, <0, 0>, <480, 360>, <8 + 4 * 488, 8>, 1, "All of (b)")
