"""Figure 8: slip with infinite friction."""

from __future__ import annotations

from planar_pushing.figures.parts import scene
from planar_pushing.figures.style import COLUMN_WIDTH

SIZE = (COLUMN_WIDTH, 2.8)
LAYERS = (scene.body, scene.motion_cone, scene.force, scene.motions, scene.center)

select, draw = scene.scene_figure("figure_08", LAYERS)
