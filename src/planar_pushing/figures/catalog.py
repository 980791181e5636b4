"""The figures and the datasets that each is drawn from; read without importing matplotlib."""

from __future__ import annotations

#: Name of the figure's module: datasets as `open_dataset` names them.
FIGURES: dict[str, tuple[str, ...]] = {
    "figure_01": ("motion_cones",),
    "figure_02": ("scenes/figure_02",),
    "figure_03": ("scenes/figure_03",),
    "figure_04": ("scenes/figure_02",),
    "figure_05": ("limit_curves",),
    "figure_06": ("limit_curves", "motion_cones"),
    "figure_07": ("motion_cones",),
    "figure_08": ("scenes/figure_08",),
    "figure_09": ("scenes/figure_09a", "scenes/figure_09b"),
    "figure_10": ("limit_curves", "motion_cones"),
    "figure_11": ("scenes/figure_11",),
    "figure_12": ("acceleration_centers", "scenes/figure_12"),
    "figure_13": ("contact_modes", "motion_cones"),
}
