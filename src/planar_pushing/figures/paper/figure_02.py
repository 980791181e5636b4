"""Figure 2: quasi-static pushing."""

from __future__ import annotations

from planar_pushing.figures.parts import scene
from planar_pushing.figures.style import COLUMN_WIDTH

SIZE = (COLUMN_WIDTH, 2.8)
LAYERS = (
    scene.body,
    scene.force,
    scene.line_of_force,
    scene.motions,
    scene.center,
    scene.support_friction,
)

select, draw = scene.scene_figure("figure_02", LAYERS)
