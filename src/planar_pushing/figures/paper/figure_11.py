"""Figure 11: pulling, with support friction and inertia."""

from __future__ import annotations

from planar_pushing.figures.parts import scene
from planar_pushing.figures.style import COLUMN_WIDTH

SIZE = (COLUMN_WIDTH, 3.3)
LAYERS = (
    scene.body,
    scene.force,
    scene.line_of_force,
    scene.motions,
    scene.center,
    scene.moment_arm,
)

select, draw = scene.scene_figure("figure_11", LAYERS)
