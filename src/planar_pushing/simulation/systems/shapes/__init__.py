"""Shapes of pushers: a fence touches a point of the slider, and a finger touches a flat side."""
