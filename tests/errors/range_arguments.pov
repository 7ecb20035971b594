#switch (1)
	#range (1)
#end
#switch (1)
	#case ("a")
#end
