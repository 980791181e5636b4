"""Figure 10."""

import numpy as np
from matplotlib.patches import FancyArrowPatch
from numpy.testing import assert_allclose


def test_ellipses_have_their_minor_axis_across_the_rod(plotted):
    data = plotted["figure_10"].sel(force_angle=[45.0, 135.0])
    lengths = data.rod_length.values
    size = np.hypot(data.force_x, data.force_y)
    assert_allclose(size.isel(force_angle=0), 1, rtol=1e-14)
    assert_allclose(size.isel(force_angle=1), 1 / np.sqrt(1 + lengths**2), rtol=1e-14)


def test_accelerations_are_those_of_the_equations(plotted):
    data = plotted["figure_10"]
    phi = np.deg2rad(data.mapped_force_angle.values)
    x, y = np.cos(phi), np.sin(phi)  # Eqs. (11) and (12) for l = 1, psi = 45 degrees
    angle = np.rad2deg(np.arctan2(1.5 * y - 0.5 * x, 1.5 * x - 0.5 * y))
    assert_allclose(data.mapped_motion_angle, angle, rtol=1e-12)


def test_labels_stand_on_the_side_of_the_fence_of_their_arrows(pictures):
    figure = pictures["figure_10"]
    for ax in figure.axes[:2]:  # the friction cone and the acceleration cone
        fence = ax.transData.transform((0, 0))[1]
        heads = [p for p in ax.patches if isinstance(p, FancyArrowPatch)]
        names = [text for text in ax.texts if "mathbf" in text.get_text()]
        assert len(heads) == len(names) == 4
        above = [p.get_path().vertices[:, 1].max() > 1e-3 for p in heads]
        assert sorted(above) == sorted(text.get_window_extent().y0 > fence for text in names)
    text = next(each for each in names if "_{1}" in each.get_text())
    assert text.get_window_extent().y1 < fence
