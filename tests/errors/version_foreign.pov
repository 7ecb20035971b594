#version unofficial megapov 1.21;
