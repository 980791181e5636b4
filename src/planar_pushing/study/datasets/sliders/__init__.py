"""Datasets of the study of sliders: a gallery of supports."""
