#declare sphere = 1;
#local pi = 3;
#declare image_width = 10;
