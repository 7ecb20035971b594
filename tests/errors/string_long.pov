#version 3.7;
#declare Text = "0123456789abcdef";
#for (I, 1, 23)
  #declare Text = concat(Text, Text);
#end
