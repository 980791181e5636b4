"""Logs of motion over time: each entry's kinematics, force law and balance of energy."""

from planar_pushing.evidence.golden.residual.simulations.residuals import residuals as residuals
