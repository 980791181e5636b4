"""Figures of sliders on any support."""
