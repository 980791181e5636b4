"""Parts that the drawings share: arrows, labels, sliders, fences, scenes, curves and cones."""
