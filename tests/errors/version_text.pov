#version "3.7";
