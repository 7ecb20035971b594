# Scenes that come with the program.
