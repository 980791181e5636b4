"""Scenes of the figures: their cones, and the motion and forces of every solution."""

from planar_pushing.evidence.golden.residual.scenes.residuals import residuals as residuals
