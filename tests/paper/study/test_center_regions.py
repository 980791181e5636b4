"""Regions of acceleration centers: the exact set lies in the paper's bound, line by line."""

import numpy as np
import pytest

import planar_pushing as pp


@pytest.fixture
def regions(results):
    """Distances along the line of centers from the ring center, signed, of the ends of both regions."""
    found = pp.open_dataset("center_regions", results)
    psi, phi = np.deg2rad(found.rod_angle), np.deg2rad(found.force_angle)
    arm = found.rod_length * np.sin(psi - phi)
    along = np.sin(phi), -np.cos(phi)
    distance = {}
    for name in ("bound", "exact"):
        apart = (
            found[f"{name}_x"] - found.rod_length * np.cos(psi),
            found[f"{name}_y"] - found.rod_length * np.sin(psi),
        )
        parts = [a * b for a, b in zip(apart, along, strict=True)]
        distance[name] = sum(
            part.where(abs(each) > 1e-9, 0) for part, each in zip(parts, along, strict=True)
        )
    return found, arm, -distance["bound"], -distance["exact"]


def test_axes_are_those_of_the_grid(results):
    found = pp.open_dataset("center_regions", results)
    assert found.force_angle.min() == 0
    assert found.force_angle.max() == 180
    assert {"rod_length", "rod_angle"} <= set(found.bound_x.dims) & set(found.exact_x.dims)


def test_the_paper_cases(regions):
    """Outside the ring the center is in it, on a tangent on it, else beyond it, opposite the line."""
    _, arm, bound, _ = regions
    inner, outer = (abs(bound.sel(bound_end=end)) for end in ("inner", "outer"))
    cases = ((abs(arm) > 1 + 1e-9, 0, 1), (abs(abs(arm) - 1) < 1e-9, 1, 1))
    for case, low, high in (*cases, ((abs(arm) > 1e-9) & (abs(arm) < 1 - 1e-9), 1, np.inf)):
        assert case.any()
        np.testing.assert_allclose(inner.where(case, low), low, atol=1e-12)
        np.testing.assert_allclose(outer.where(case, high), high, atol=1e-12)
    translates = (abs(arm) < 1e-9).broadcast_like(inner)
    assert np.isinf(inner.where(translates, np.inf)).all()


def test_the_exact_set_lies_in_the_bound(regions):
    _, arm, bound, exact = regions
    turns = abs(arm) > 1e-9
    side = np.sign(arm)
    low, high = bound.sel(bound_end="inner") * side, bound.sel(bound_end="outer") * side
    inside = (low - 1e-12 <= exact * side) & (exact * side <= high + 1e-12)
    assert inside.where(turns, True).all()


def test_the_exact_ends_are_motion_centers(regions):
    found = regions[0]
    slider = pp.Slider(rod_length=2, rod_angle=np.pi / 2)
    for end, effect in (("support_friction", pp.RingFriction()), ("inertia", pp.Inertia())):
        scene = pp.Scene(slider=slider, contact=pp.InfiniteFriction(), effects=(effect,))
        here = found.sel(rod_length=2, rod_angle=90, exact_end=end)
        expected = pp.motion_centers(scene, np.deg2rad(found.force_angle.values))
        np.testing.assert_allclose(here.exact_x, expected[:, 0], rtol=1e-12, atol=1e-15)
        np.testing.assert_allclose(here.exact_y, expected[:, 1], rtol=1e-12, atol=1e-15)
