background { rgb "red" }
