"""Objects of another kind than a function takes: a scene, a slider, an origin, a twist."""

from __future__ import annotations

import numpy as np
import pytest
from mechanics.builders import FRICTION, make_scene
from terms.test_domain import check

import planar_pushing as pp


@pytest.mark.parametrize("given", [(2.0, 1.0), {"rod_length": 2.0}, None, pp.Slider], ids=str)
def test_a_slider_is_a_slider(given):
    check(
        lambda: pp.Scene(slider=given, contact=pp.Coulomb(1.0), effects=FRICTION), "slider", given,
        "a Slider", "construct one",
    )  # fmt: skip


#: Every public function of a scene.
OF_SCENES = [
    pp.can_pull, pp.conservative_motion_cone, pp.friction_cone, pp.motion_cone, pp.slips_while_pushing,
    lambda scene: pp.limit_curve(scene, 1.0), lambda scene: pp.motion_angle(scene, 1.0),
    lambda scene: pp.motion_centers(scene, 1.0), lambda scene: pp.spin_ratio(scene, 1.0),
    lambda scene: pp.solve(scene, 1.0), lambda scene: pp.save_scene(scene, "scene.yaml"),
    lambda scene: pp.simulate(scene, pusher=pp.Pusher(velocity=(0.0, 1.0)), duration=1.0),
]  # fmt: skip


@pytest.mark.parametrize("function", OF_SCENES)
@pytest.mark.parametrize("given", ["scene.yaml", None, pp.Scene], ids=str)
def test_a_scene_is_a_scene(function, given):
    check(
        lambda: function(given), "scene", given, "a Scene",
        "read a file with load_scene, or construct one",
    )  # fmt: skip


@pytest.mark.parametrize("given", [None, "", "center", 0, ["contact"]], ids=repr)
def test_origin_of_centers(given):
    check(
        lambda: pp.motion_centers(make_scene(1.0), 1.0, origin=given), "origin", given,
        "contact, slider-center", "name one of these points",
    )  # fmt: skip


@pytest.mark.parametrize("function", [pp.wrench, pp.potential])
@pytest.mark.parametrize(("given", "shown", "allowed"), [
    ((1.0, 0.0), (1.0, 0.0), "shape S + (3,)"),
    (1.0, 1.0, "shape S + (3,)"),
    (("1", 0.0, 0.0), ("1", 0.0, 0.0), "finite numbers"),
    ((1.0, np.inf, 0.0), np.inf, "finite numbers"),
    (None, None, "finite numbers"),
])  # fmt: skip
def test_twist(function, given, shown, allowed):
    with pytest.raises(pp.InvalidValue) as caught:
        function(pp.Inertia(), given)
    assert (caught.value.name, caught.value.given) == ("twist", shown)
    assert caught.value.allowed == allowed
