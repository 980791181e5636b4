"""The datasets of a study of sliders, in balls: any support, its motion cones and contact modes."""
