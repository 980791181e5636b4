"""The datasets of a study of sliders, in balls: any support, its motion cones and contact modes."""

from planar_pushing.evidence.golden.residual.sliders import cones, modes, supports

__all__ = ["cones", "modes", "supports"]
