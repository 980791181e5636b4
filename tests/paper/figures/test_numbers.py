"""What figures derive from their datasets: mapped forces, resistances, sectors of centers."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from planar_pushing.drawing.sketch import Sketch
from planar_pushing.terms.numbers import in_radians
from pulling_by_pushing.figures.paper import figure_05, figure_12, mappings, schematics


def test_edges_of_the_velocity_cone_are_the_published_ones(plotted):
    forces, angles, motions = mappings.map_cone(plotted["figure_06"])
    half = np.rad2deg(np.arctan(2))
    assert_allclose(angles, [90 - half, 45, 90, 90 + half], rtol=1e-14)
    assert_allclose(motions[[0, -1]], [-20.038457551638, 140.16416973393], rtol=1e-12)
    assert motions[1] == pytest.approx(45, rel=1e-14, abs=0)  # along the rod
    assert_allclose(np.rad2deg(np.arctan2(*forces.T[::-1])), angles, rtol=1e-13)


def test_accelerations_are_those_of_the_equations(plotted):
    _, angles, motions = mappings.map_cone(plotted["figure_10"])
    x, y = np.cos(in_radians(angles)), np.sin(in_radians(angles))
    # Eqs. (11) and (12) for l = 1, psi = 45 degrees
    found = np.rad2deg(np.arctan2(1.5 * y - 0.5 * x, 1.5 * x - 0.5 * y))
    assert_allclose(motions, found, rtol=1e-12)


def test_forces_along_the_rod_are_the_weight_and_between_grid_angles_are_interpolated(plotted):
    curves = plotted["figure_05"]["curves"]
    assert_allclose(figure_05.forces(curves, 45.0), 1, rtol=1e-14)
    low, middle, high = (figure_05.forces(curves, angle) for angle in (363.0, 364.5, 366.0))
    assert_allclose(middle, (low + high) / 2, rtol=1e-14)


def test_resistances_of_figure_11_balance_the_force_along_one_line_tangent_to_the_ring(plotted):
    scene = schematics.solution(plotted["figure_11"])
    sketch = Sketch.of_dataset(scene)
    one = sketch.solution
    heading = one.force / np.hypot(*one.force)
    foot = (heading @ sketch.center) * heading
    assert foot - sketch.center == pytest.approx(sketch.center - one.center)
    friction, inertial = schematics.resistances(scene).values()
    assert friction + inertial == pytest.approx(-one.force)
    mean = scene.support_force.isel(solution=0).mean("support_angle").values
    assert 2 * np.pi * mean == pytest.approx(friction, abs=0.03)
    for part in (friction, inertial):
        assert part @ heading == pytest.approx(-np.hypot(*part))


def test_exact_centers_lie_in_the_papers_sectors(plotted):
    scene = plotted["figure_12"]["scenes/figure_12"]
    around = (scene.cone_center - scene.ring_center).transpose(..., "xy").values.reshape(-1, 2)
    x, y = around[np.isfinite(around).all(axis=-1)].T
    assert len(x) == 2 * 180  # without the translation along the rod
    angle, beyond = np.rad2deg(np.arctan2(y, x)), np.hypot(x, y) > 1
    held = [
        (angle > start - 1e-9) & (angle < stop + 1e-9) & (beyond == outside)
        for _, start, stop, outside in figure_12.sectors(scene)
    ]
    assert np.any(held, axis=0).all()


@pytest.mark.parametrize(
    ("length", "sectors"),
    [
        (2.0, [(1, 90, 105, False), (3, 105, 135, True), (5, -45, -15, True), (7, -15, 90, False)]),
        (0.5, [(3, 90, 135, True), (5, -45, 90, True)]),
    ],
)
def test_sectors_meet_and_open_with_the_ring_seen_from_the_contact(plotted, length, sectors):
    scene = plotted["figure_12"]["scenes/figure_12"].assign(rod_length=length)
    assert_allclose(list(figure_12.sectors(scene)), sectors, rtol=1e-14)
