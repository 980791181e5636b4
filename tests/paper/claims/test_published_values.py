"""The table of check values: degrees, R = rho = 1, psi = 45 degrees."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import FRICTION, INERTIA, PSI, make_scene
from mpmath import mp

import planar_pushing as pp
import reference

TABLE = [
    (2.0, 2.0, FRICTION, -20.038457551638, 140.16416973393),
    (2.0, 2.0, INERTIA, -14.036243467926, 138.81407483429),
    (0.5, np.inf, FRICTION, -9.9905001844019, 170.0094998156),
    (0.5, np.inf, INERTIA, -6.3401917459099, 173.65980825409),
    (1.0, np.inf, FRICTION, -21.298139595247, 158.70186040475),
    (1.0, np.inf, INERTIA, -18.434948822922, 161.56505117708),
    (2.0, np.inf, FRICTION, -31.389608677922, 148.61039132208),
    (2.0, np.inf, INERTIA, -33.69006752598, 146.30993247402),
    (5.0, np.inf, FRICTION, -41.160027835239, 138.83997216476),
    (5.0, np.inf, INERTIA, -42.797401838234, 137.20259816177),
]
EVERY_ROW = pytest.mark.parametrize(("length", "mu", "effects", "right", "left"), TABLE)


@EVERY_ROW
def test_motion_cones(length, mu, effects, right, left):
    cone = pp.motion_cone(make_scene(length, mu, effects))
    assert np.rad2deg([cone.right, cone.left]) == pytest.approx([right, left], rel=1e-13, abs=6e-12)


@EVERY_ROW
def test_reference_motion_cones(length, mu, effects, right, left):
    """The transcription has the same values: the table and the code are not wrong together."""
    angle = (
        reference.friction_motion_angle if effects == FRICTION else reference.inertia_motion_angle
    )
    half = mp.pi / 2 if np.isinf(mu) else mp.atan(mu)
    edges = [mp.degrees(angle(length, mp.pi / 2 + side * half, mp.pi / 4)) for side in (-1, 1)]
    assert [float(edge) for edge in edges] == pytest.approx([right, left], rel=1e-13, abs=0)


def test_both_effects_join_the_outer_edges():
    for length, mu, _, right, left in TABLE[::2]:
        cone = pp.motion_cone(make_scene(length, mu, FRICTION + INERTIA))
        pure = [pp.motion_cone(make_scene(length, mu, kind)) for kind in (FRICTION, INERTIA)]
        ends = min(each.right for each in pure), max(each.left for each in pure)
        assert (cone.right, cone.left) == pytest.approx(ends, rel=1e-15, abs=1e-15)
        assert ends[0] <= np.deg2rad(right) + 1e-13
        assert ends[1] >= np.deg2rad(left) - 1e-13


def test_force_on_the_ring_center_line_has_the_ring_constants():
    """f(1) = t(1) = 2 / pi, where the tangent force has the center on the ring."""
    curve = pp.limit_curve(make_scene(5.0), PSI - np.arcsin(1 / 5))
    assert curve.magnitude == pytest.approx(2 / np.pi, rel=1e-13, abs=0)
