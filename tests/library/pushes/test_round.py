"""Outlines with arcs and holes wherever pushes have one: files, tables, candidates and scene files."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from pushes.written import SQUARE, small

import planar_pushing as pp
from planar_pushing.pushes.fit.candidates import FAMILIES
from planar_pushing.pushes.logs.combine import of_object, with_outline
from planar_pushing.pushes.logs.measured import measurements_of
from planar_pushing.pushes.logs.schema import outline_of, require_pushes
from planar_pushing.pushes.models import uniform_support
from planar_pushing.pushes.scene_file import save_support

SLOT = [(-30, -20, 0), (30, -20, 1), (30, 20, 0), (-30, 20, 1)]
BOX = 40.0 * np.array(SQUARE)
#: Outlines in mm, and entries of files that describe them.
OUTLINES = {
    "disc": (pp.Outline(pp.Disc(40.0, (3.0, 1.0))), {"disc": {"radius": 40.0, "center": [3.0, 1.0]}}),
    "rounded": (pp.rounded(BOX, 12.0), {"rounded": {"vertices": BOX.tolist(), "radius": 12.0}}),
    "bulges": (pp.Outline.from_bulges(SLOT), {"bulges": [list(row) for row in SLOT]}),
    "ellipse": (pp.Outline.ellipse(65.0, 52.0, 32), {"ellipse": {"a": 65.0, "b": 52.0, "arcs": 32}}),
    "holes": (pp.Outline(BOX, holes=[pp.Disc(15.0)]), None),
    "polygon": (pp.Outline(BOX), BOX.tolist()),
}  # fmt: skip
KINDS = pytest.mark.parametrize("kind", OUTLINES)


def pushed(kind, count=12, **options):
    outline = OUTLINES[kind][0]
    effects = (pp.SupportFriction(support=uniform_support(outline), weight=3.0),)
    return pp.simulate_pushes(effects, outline, count, seed=2, distance=6.0, name=kind, **options)


@KINDS
@pytest.mark.parametrize("radius", [0.0, 5.0])
def test_simulated_pushes_touch_the_outline_and_end_at_it(kind, radius):
    pushes = measurements_of(pushed(kind, finger_radius=radius))
    assert pushes.outline == OUTLINES[kind][0]
    assert pushes.first_places.gap == pytest.approx(0.0, abs=1e-9)
    assert (pushes.first_places.normal * pushes.normal).sum(axis=1) == pytest.approx(1.0, abs=1e-9)
    assert pushes.last_places.gap == pytest.approx(radius, abs=1e-5)


@KINDS
def test_outlines_are_stored_exactly(kind, tmp_path):
    outline, pushes = OUTLINES[kind][0], pushed(kind, 3)
    pp.save_pushes(pushes, tmp_path / "pushes.nc")
    again = pp.load_pushes(tmp_path / "pushes.nc")
    assert again.identical(pushes)
    assert outline_of(again, kind) == outline
    assert ("outline_pieces" in again) == (kind != "polygon")
    # As in any file of pushes, the corners of a polygon, and for others a polygon on the outline.
    corners = again["outline"].values[0]
    assert (np.abs(np.hypot(*(corners - [3.0, 1.0]).T) - 40.0) < 1e-9).all() or kind != "disc"
    assert require_pushes(again).identical(again)


def test_objects_of_several_kinds_are_combined_and_taken_apart():
    parts = [pushed(kind, 3) for kind in OUTLINES]
    joined = pp.concat_pushes(parts)
    for kind, part in zip(OUTLINES, parts, strict=True):
        assert outline_of(joined, kind) == OUTLINES[kind][0]
        alone = of_object(joined, kind)
        assert outline_of(alone, kind) == OUTLINES[kind][0]
        assert alone["displacement"].values.tolist() == part["displacement"].values.tolist()
    with pytest.raises(pp.InvalidValue, match="a different name for each object"):
        pp.concat_pushes([parts[0], with_outline(parts[0], pp.Disc(40.1, (3.0, 1.0)))])


def test_another_outline_replaces_arcs():
    pushes = pushed("ellipse", 3)
    ring = OUTLINES["ellipse"][0].vertices(0.01)
    drawn = with_outline(pushes, ring)
    assert "outline_pieces" not in drawn
    assert outline_of(drawn, "ellipse") == pp.Outline(ring)
    assert (
        outline_of(with_outline(drawn, OUTLINES["ellipse"][0]), "ellipse") == OUTLINES["ellipse"][0]
    )
    with pytest.raises(pp.InvalidValue, match="a point of the outline of ellipse"):
        with_outline(pushes, pp.Disc(52.0))


def test_damaged_pieces_are_refused():
    pushes = pushed("rounded", 3)
    pushes["outline_pieces"].values[0, 1, 2] *= 2.0
    with pytest.raises(
        pp.InvalidValue, match=r"^outline of rounded: .* closed chains whose points"
    ):
        require_pushes(pushes)


@KINDS
@pytest.mark.parametrize("family", FAMILIES)
def test_candidates_are_within_the_outline_and_at_its_edge(kind, family):
    outline = OUTLINES[kind][0]
    places, columns = FAMILIES[family](outline, outline.size / 6.0)
    spots = pp.Outline(outline)
    assert columns.sum(axis=0) == pytest.approx(np.ones(columns.shape[1]))
    x, y = places.T
    if kind == "disc":
        away = np.hypot(x - 3.0, y - 1.0)
        assert away.max() <= 40.0 + 1e-6
        assert (np.abs(away - 40.0) < 1e-9).sum() >= (
            18 if family in ("points", "uniform_and_corners") else 0
        )
    if kind == "holes":
        assert np.hypot(x, y).min() >= 15.0 - 1e-6
    if kind == "rounded":
        beyond = np.maximum(np.abs(places) - 28.0, 0.0)
        assert np.hypot(*beyond.T).max() <= 12.0 + 1e-6
    assert spots == outline


@pytest.mark.parametrize("kind", ["disc", "rounded", "holes"])
def test_a_uniform_pressure_is_that_of_the_plate(kind):
    outline = OUTLINES[kind][0]
    assert uniform_support(outline).center_of_pressure == pytest.approx(outline.centroid, abs=1e-3)
    if kind == "disc":
        assert uniform_support(outline) == pp.Disc(40.0, (3.0, 1.0))
    if kind == "holes":
        # The corners and the hole of a square: the torque of spinning is that of their difference.
        square, hole = 80.0**2 * 0.3825978 * 80.0, np.pi * 15.0**2 * 10.0
        spin = pp.wrench(pp.SupportFriction(support=uniform_support(outline)), (0.0, 0.0, 1.0))[2]
        assert spin == pytest.approx((square - hole) / outline.area, rel=1e-4)


@pytest.mark.parametrize("kind", ["disc", "rounded", "ellipse"])
def test_forces_on_a_round_object_tell_its_friction_and_weight(kind):
    pushes = pushed(kind, 30, contact=pp.Coulomb(0.2), finger_radius=4.0, noise=(0.02, 0.05, 0.01))
    found = pp.identify(pushes, resamples=1)
    assert found.contact_friction == pytest.approx(0.2, abs=0.01)
    assert found.weight == pytest.approx(3.0, rel=0.03)
    comparison = pp.compare(pushes, ["uniform"], resamples=10)
    assert comparison["median"].sel(quantity="pose", model="uniform").item() < 0.2


@pytest.mark.parametrize("kind", OUTLINES)
def test_the_scene_of_a_support_keeps_the_outline(kind, tmp_path):
    pushes = pushed(kind, 3)
    found = pp.Identified(
        support=pp.Points(5.0 * np.array(SQUARE), [1, 1, 1, 1]), weight=2.0, contact_friction=0.3,
        center_of_pressure=np.zeros(2), spin_torque=7.0, intervals={}, weight_intervals=np.zeros((4, 2)),
        residuals=np.zeros(3), facet=np.full(3, -1), length=40.0, spacing=5.0, optimality=0.0,
        undetermined=(),
    )  # fmt: skip
    save_support(found, pushes, tmp_path / "support.yaml")
    moved, outline = pp.load_scene(tmp_path / "support.yaml").slider.outline, OUTLINES[kind][0]
    # In the frame of the scene.
    for column in (2, 5, 6, 7, 8):
        assert moved.pieces[:, column] == pytest.approx(outline.pieces[:, column], abs=1e-9)


def test_what_holds_for_polygons_has_no_pieces():
    """As in files that were written before outlines had arcs."""
    pushes = require_pushes(small())
    assert "outline_pieces" not in pushes
    assert isinstance(pushes, xr.Dataset)
    assert outline_of(pushes, "square") == pp.Outline(SQUARE)
