#fclose Nothing
