"""Figure 3: quasi-static pulling."""

from __future__ import annotations

from planar_pushing.figures import scene
from planar_pushing.figures.style import COLUMN_WIDTH

SIZE = (COLUMN_WIDTH, 3.1)
CAPTION = (
    "Quasi-static pulling. The force f passes close by the ring centre on its other side: the contact "
    "sticks although the pusher moves away from the slider."
)
LAYERS = (
    scene.body,
    scene.force,
    scene.line_of_force,
    scene.motions,
    scene.center,
    scene.support_friction,
)

select, draw = scene.scene_figure("figure_03", LAYERS)
