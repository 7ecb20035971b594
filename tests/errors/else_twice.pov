#else
#elseif (1)
