"""Golden data of the study of sliders."""
