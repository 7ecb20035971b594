#if (defined A) #end
#ifdef A #end
