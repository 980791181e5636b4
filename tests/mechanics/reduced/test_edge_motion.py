"""The motion under a force on an edge, against the slip with a normal motion."""

import numpy as np
import pytest

from planar_pushing.mechanics.effects.any_support import Support
from planar_pushing.mechanics.effects.support_friction import RingSupport
from planar_pushing.mechanics.plane import contact_motion, rod, toward
from planar_pushing.mechanics.reduced.base import MOTION, edge_motion, slips
from planar_pushing.mechanics.supports import Polygon
from planar_pushing.mechanics.supports.pressure.assembly import assembled

L = Polygon([(-1, -1), (1, -1), (1, -0.3), (-0.3, -0.3), (-0.3, 1), (-1, 1)])
EFFECTS = {
    "ring": RingSupport(0.7),
    "L": Support(0.7, L.extent, assembled(L.pieces(), L.extent), 1.0, 0.0),
}


@pytest.mark.parametrize("effect", EFFECTS.values(), ids=EFFECTS)
@pytest.mark.parametrize("length", [0.0, 0.5, 5.0, 1e3])
@pytest.mark.parametrize("angle", [1.0, 2.0])
def test_a_slip_is_a_multiple_of_the_motion_of_unit_size(effect, length, angle):
    effects, own = (effect,), rod(length, 0.8)
    v_x, v_y, spin, f_x, f_y = edge_motion(effects, own, toward(own, angle))
    assert max(np.hypot(v_x, v_y), abs(spin)) == pytest.approx(1, rel=1e-14, abs=0)
    advance, found = contact_motion(own, v_x, v_y, spin)[1], np.empty((8, MOTION))
    assert slips(effects, own, toward(own, angle), advance, 0.0, found) == 1
    expected = [v_x, v_y, spin, f_x, f_y, f_x, f_y, -1]
    assert found[0] == pytest.approx(expected, rel=1e-9, abs=1e-12)
