"""Figures 2, 3, 8 and 11: one solution of a scene each."""

from __future__ import annotations

from planar_pushing.figures.parts import forces, scene

BALANCE = (scene.body, forces.force, forces.line_of_force, scene.motions, scene.center)

quasi_static = scene.SceneFigure((*BALANCE, forces.support_friction))
slipping = scene.SceneFigure(
    (scene.body, scene.motion_cone, forces.force, scene.motions, scene.center)
)
dynamic = scene.SceneFigure((*BALANCE, scene.moment_arm))
