"""What only the library says of the paper's pushes: closed cones, adhesion, outcomes, pulling, and slip."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import BOTH, DEFINITION_2, EVERY_EFFECT, INERTIA, INFINITE, PSI, make_scene

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction


@pytest.mark.parametrize(("law", "closed"), [(INFINITE, True), (DEFINITION_2, False)], ids=str)
def test_the_definitions_are_a_closed_and_an_open_interval(law, closed):
    """Sec. 5."""
    cone = pp.friction_cone(make_scene(2.0, law))
    assert (cone.right, cone.left, cone.closed) == (0.0, np.pi, closed)
    assert np.all(cone.contains([0.0, np.pi, -np.pi, 2 * np.pi]) == closed)
    assert np.all(cone.contains([1e-9, np.pi - 1e-9]))


@EVERY_EFFECT
@pytest.mark.parametrize("length", [0.0, 0.5, 5.0])
def test_a_rough_contact_is_adhesive_where_infinite_friction_slips(effects, length):
    """Secs. 3.2 and 5: and only there its force leads away from the slider."""
    rough, infinite = (make_scene(length, law, effects) for law in (pp.PerfectlyRough(), INFINITE))
    for angle in np.deg2rad(np.arange(7.5, 180, 15)):
        (stick,), (found,) = pp.solve(rough, angle), pp.solve(infinite, angle)
        assert stick.adhesive == (stick.force[1] < 0) == (found.mode is not pp.ContactMode.STICK)
        assert not found.adhesive
        if not stick.adhesive:
            assert found.force == pytest.approx(stick.force, rel=1e-12, abs=0)


def test_outcomes_are_named_by_the_number_of_solutions():
    """Sec. 2: several solutions are ambiguous, none is inconsistent."""
    pushes = {"UNIQUE": (2.0, 90), "AMBIGUOUS": (2.0, -10), "INCONSISTENT": (DEFINITION_2, 165)}
    for name, (law, degrees) in pushes.items():
        assert pp.solve(make_scene(2.0, law), np.deg2rad(degrees)).outcome.name == name


def test_the_fence_pulls_and_slips_where_the_cone_is_tilted():
    """Secs. 3.2 and 4: Eq. (13) gives mu = 1.5 exactly; a rod along the normal, or none, excludes slip."""
    for mu, pulls in ((1.5, False), (1.5 - 1e-9, False), (1.5 + 1e-9, True)):
        assert pp.can_pull(make_scene(2.0, mu, INERTIA)) == pulls
    for length, psi, slips in ((0.0, PSI, False), (2.0, np.pi / 2, False), (2.0, 1.5, True)):
        assert pp.slips_while_pushing(make_scene(length, psi=psi)) == slips
    assert not pp.slips_while_pushing(make_scene(2.0, DEFINITION_2))


@pytest.mark.parametrize(("angle", "mode"), [(0.3, "SLIP_LEFT"), (2.9, "SLIP_RIGHT")])
def test_friction_opposes_a_slip(angle, mode):
    """Sec. 2: during slip |f_t| = mu f_n."""
    (slip,) = pp.solve(make_scene(2.0, 0.2), angle)
    assert slip.mode.name == mode
    assert abs(slip.force[0]) == pytest.approx(0.2 * slip.force[1], rel=1e-14, abs=0)
    assert slip.force[0] * (slip.contact_motion[0] - np.cos(angle)) < 0


@pytest.mark.parametrize("share", [0.0, 0.2, 0.5, 0.9, 1.0])
def test_a_center_on_the_ring_pulls(share):
    """Fig. 11: l = 5, a force tangent to the ring, whatever the relative magnitudes."""
    scene, tangent = make_scene(5.0, 2.0, BOTH), PSI - np.arcsin(1 / 5)
    assert float(pp.spin_ratio(scene, tangent, share)) == pytest.approx(1.0, abs=2e-14)
    assert -np.pi / 2 < float(pp.motion_angle(scene, tangent, share)) < 0
    center = pp.motion_centers(scene, tangent, share) - 5 * direction(PSI)
    assert np.hypot(*center) == pytest.approx(1.0, abs=2e-14)
