"""A scene as a model of MuJoCo: the XML, and MuJoCo's answers where it is installed."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.terms.errors import InvalidValue

CORNERS = [(-0.15, -0.1), (0.15, -0.1), (0.15, 0.1), (-0.15, 0.1)]
FEET = pp.Points([(0.12, 0.0), (-0.1, 0.08), (-0.1, -0.08)], [0.4, 0.3, 0.3])
MASS, WEIGHT, GYRATION = 1.2, pp.weight(1.2, 0.3), 0.104
MASS_CENTER = (0.01, -0.02)


def box(point=(-0.05, -0.1), normal=None, *, mu=0.5, support=FEET, inertia=True):
    """A box in SI units, on three feet, touched at a point of its outline."""
    effects = (pp.SupportFriction(support=support, weight=WEIGHT),)
    if inertia:
        effects += (pp.Inertia(mass=MASS, gyration_radius=GYRATION, center=MASS_CENTER),)
    return pp.scene_at(point, normal, effects=effects, contact=pp.Coulomb(mu), outline=CORNERS)


def numbers(element, name):
    return np.array(element.get(name).split(), dtype=float)


@pytest.fixture(scope="module")
def tree():
    return ElementTree.fromstring(pp.to_mjcf(box()))


def test_feet_and_body_have_the_inertia_of_the_scene(tree):
    """Sums over the elements, in the body frame."""
    scene, body = box(), tree.find("worldbody/body[@name='slider']")
    own = body.find("inertial")
    masses = [float(own.get("mass"))] + [
        float(each.find("geom").get("mass")) for each in body.iter("body") if each is not body
    ]
    places = [numbers(own, "pos")[:2]] + [numbers(each, "pos")[:2] for each in body.findall("body")]
    masses, places = np.array(masses), np.array(places)
    center = masses @ places / masses.sum()
    moment = numbers(own, "diaginertia")[2] + masses @ ((places - center) ** 2).sum(axis=1)
    assert masses.min() > 0
    assert masses.sum() == pytest.approx(MASS, rel=1e-9)
    np.testing.assert_allclose(center, scene.effects[1].center, atol=1e-9)
    assert moment == pytest.approx(MASS * GYRATION**2, rel=1e-9)
    np.testing.assert_allclose(scene.to_object([0.0, 0.0], "point"), (-0.05, -0.1), atol=1e-12)


def test_springs_and_coefficient_give_each_foot_its_share(tree):
    found = []
    for foot in tree.findall("worldbody/body/body"):
        joint, name = foot.find("joint"), foot.get("name")
        (pair,) = (each for each in tree.iter("pair") if each.get("geom2") == name)
        force = -float(joint.get("stiffness")) * float(joint.get("springref"))
        found.append(force * numbers(pair, "friction")[0])
    np.testing.assert_allclose(found, WEIGHT * np.array(FEET.weights), rtol=1e-9)


def test_sides_join_the_corners_of_the_outline(tree):
    body, scene = tree.find("worldbody/body[@name='slider']"), box()
    ends = np.array([numbers(each, "fromto") for each in body.findall("geom")])
    np.testing.assert_allclose(ends[:, :2], scene.slider.outline_in_body().corners, atol=1e-12)
    np.testing.assert_allclose(ends[:, 3:5], np.roll(ends[:, :2], -1, axis=0), atol=1e-12)
    assert len([each for each in tree.iter("pair") if each.get("geom1") == "pusher"]) == 4


def test_arcs_are_chains_of_sides_within_a_thousandth_of_the_size():
    law = pp.Coulomb(0.5)
    friction = pp.SupportFriction(support=FEET, weight=WEIGHT)
    effects = (friction, pp.Inertia(mass=MASS, gyration_radius=GYRATION))
    scene = pp.scene_at((0.0, -0.2), effects=effects, contact=law, outline=pp.Disc(0.2))
    body = ElementTree.fromstring(pp.to_mjcf(scene)).find("worldbody/body[@name='slider']")
    ends = np.array([numbers(each, "fromto") for each in body.findall("geom")])
    ends = ends.reshape(-1, 2, 3)[..., :2]
    ends = scene.slider.outline_frame.point_out(ends)
    middles = np.hypot(*ends.mean(axis=1).T)
    on_disc = np.abs(np.hypot(*np.moveaxis(ends, -1, 0)) - 0.2).max(axis=1) < 1e-12
    assert on_disc.sum() >= 30
    assert 0.2 - 0.4e-3 <= middles[on_disc].min() < 0.2


def test_a_light_slider_of_small_gyration_keeps_a_positive_moment():
    effects = (pp.SupportFriction(support=FEET), pp.Inertia(gyration_radius=1e-3))
    with pytest.warns(pp.SceneWarning, match="gyration_radius: 0.001 beside"):
        scene = pp.scene_at(
            (-0.05, -0.1), effects=effects, contact=pp.Coulomb(0.5), outline=CORNERS
        )
    own = ElementTree.fromstring(pp.to_mjcf(scene)).find("worldbody/body/inertial")
    assert 0 < numbers(own, "diaginertia")[2] < 1e-6


def test_the_error_is_a_number_and_a_remark():
    text = pp.to_mjcf(box(support=pp.Polygon(CORNERS)), feet=16)
    found = {
        each.get("name"): float(each.get("data"))
        for each in ElementTree.fromstring(text).iter("numeric")
    }
    assert 0.001 < found["mean_force_error"] < found["worst_force_error"] < 0.2
    assert f"{np.rad2deg(found['mean_force_error']):.2g} degrees on average" in text
    exact = ElementTree.fromstring(pp.to_mjcf(box()))
    assert max(float(each.get("data")) for each in exact.iter("numeric")) < 1e-12


def changed(**fields):
    given = {"slider": box().slider, "contact": pp.Coulomb(0.5), "effects": box().effects}
    return pp.Scene(**given | fields)


WRONG = {
    "no outline": (
        lambda: changed(slider=pp.Slider(rod_length=1, rod_angle=1)), {},
        r"outline: None given; allowed: the corners of the slider in order; give Slider\(outline",
    ),
    "law": (lambda: changed(contact=pp.InfiniteFriction()), {}, "contact: .* allowed: Coulomb; "),
    "no inertia": (lambda: box(inertia=False), {}, "effects: .* friction on supports and Inertia; "),
    "no friction": (lambda: changed(effects=(pp.Inertia(),)), {}, "effects: .* Inertia; "),
    "load": (
        lambda: changed(effects=(*box().effects, pp.Load(force=(0.1, 0.0)))), {}, "effects: .* Inertia; ",
    ),
    "film": (
        lambda: changed(effects=(*box().effects, pp.Viscous(support=FEET))), {}, "effects: .* Inertia; ",
    ),
    "array": (
        lambda: changed(contact=pp.Coulomb(np.array([0.1, 0.5]))), {},
        "scene: 'an array of scenes' given; ",
    ),
    "no scene": (lambda: "box.yaml", {}, "scene: 'box.yaml' given; "),
    "pusher": (box, {"pusher": "fnger"}, "pusher: 'fnger' given; allowed: fence, finger; "),
    "few feet": (box, {"feet": 2}, "feet: 2 given; allowed: an integer from 3 to 1000; "),
    "half a foot": (box, {"feet": 3.5}, "feet: 3.5 given; allowed: an integer from 3 to 1000; "),
    "timestep": (box, {"timestep": 0.0}, "timestep: 0.0 given; allowed: a finite number > 0; "),
    "gravity": (box, {"gravity": np.inf}, "gravity: inf given; allowed: a finite number; "),
    "masked gravity": (box, {"gravity": np.ma.masked}, "gravity: masked given; allowed: a finite"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_a_wrong_value_is_refused_in_one_line(case):
    scene, options, message = WRONG[case]
    with pytest.raises(InvalidValue, match=message) as refusal:
        pp.to_mjcf(scene(), **options)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize("gravity", [np.uint8(10), np.uint64(10), np.int8(10), np.float16(10), 10])
def test_gravity_of_any_type_points_down(gravity):
    assert pp.to_mjcf(box(), gravity=gravity) == pp.to_mjcf(box(), gravity=10.0)


def loaded(text):
    """The model and its state, in MuJoCo."""
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_string(text)
    return mujoco, model, mujoco.MjData(model)


@pytest.mark.parametrize("pusher", ["fence", "finger"])
def test_mujoco_loads_it(pusher):
    _, model, data = loaded(pp.to_mjcf(box(), pusher=pusher))
    assert model.nu == 2
    assert model.numeric("mean_force_error").data[0] < 1e-12
    scene = box()
    np.testing.assert_allclose(
        model.body("slider").pos[:2],
        scene.to_fence(scene.to_object((0.0, 0.0), "vector") + FEET.center_of_pressure, "point"),
        atol=1e-9,
    )
    assert data.qpos[:3].tolist() == [0.0, 0.0, 0.0]


def steady_friction(text, twist):
    """Wrench of friction on the slider and its twist in steady sliding, driven by velocity actuators."""
    root = ElementTree.fromstring(text)
    for name in ("x", "y", "turn"):
        ElementTree.SubElement(root.find("actuator"), "velocity", joint=f"slider_{name}", kv="200")
    mujoco, model, data = loaded(ElementTree.tostring(root, encoding="unicode"))
    data.joint("pusher_y").qpos[0] = -9.0  # out of the way
    data.ctrl[2:] = twist
    for _ in range(600):
        data.qpos[:3] = 0.0
        mujoco.mj_step(model, data)
    return data.qfrc_actuator[:3].copy(), data.qvel[:3].copy()


@pytest.mark.parametrize("seed", range(6))
def test_friction_in_mujoco_is_the_scenes_wrench(seed):
    """Five feet, on which the loads of a rigid body would be undetermined; within 1e-4 of W."""
    feet = pp.Points([(1, 0), (-0.5, 0.8), (-0.5, -0.8), (0.2, 0.1), (0, -1)], [2, 1, 1, 4, 0.5])
    friction = pp.SupportFriction(support=feet, weight=2.0)
    slider = pp.Slider(
        rod_length=2.0, rod_angle=np.pi / 2, outline=[(-2, 0), (0, -1), (1, 0), (0, 1)]
    )
    scene = pp.Scene(
        slider=slider, contact=pp.Coulomb(0.5), effects=(friction, pp.Inertia(gyration_radius=0.7))
    )
    twist = np.random.default_rng(seed).normal(size=3)
    given, (v_x, v_y, spin) = steady_friction(
        pp.to_mjcf(scene), 0.5 * twist / np.linalg.norm(twist)
    )
    f_x, f_y, torque = pp.wrench(friction, [v_y, -v_x, spin], scene.slider)
    np.testing.assert_allclose(given, [-f_y, f_x, torque], atol=2e-4)


def pushed(text, velocity, duration, start):
    """Displacement of the slider's center and its turn, the pusher's speed growing during the start."""
    mujoco, model, data = loaded(text)
    while data.time < duration:
        data.ctrl[:] = np.array(velocity) * min(1.0, data.time / start)
        mujoco.mj_step(model, data)
    return data.qpos[:3], data.qvel[:3]


def test_the_unit_of_length_does_not_matter():
    """Lengths in mm, forces in N: masses in tons."""
    friction = pp.SupportFriction(
        support=pp.Points(1e3 * np.array(FEET.positions), FEET.weights), weight=WEIGHT
    )
    inertia = pp.Inertia(
        mass=1e-3 * MASS, gyration_radius=1e3 * GYRATION, center=tuple(1e3 * np.array(MASS_CENTER))
    )
    millimeters = pp.scene_at(
        (-50.0, -100.0), effects=(friction, inertia), contact=pp.Coulomb(0.5),
        outline=1e3 * np.array(CORNERS),
    )  # fmt: skip
    one, _ = pushed(pp.to_mjcf(box(), pusher="finger"), (0.002, 0.01), 1.0, 0.4)
    other, _ = pushed(pp.to_mjcf(millimeters, pusher="finger"), (2.0, 10.0), 1.0, 0.4)
    assert one[1] > 0.007
    np.testing.assert_allclose(other / (1e3, 1e3, 1), one, atol=1e-6)


#: Pushes of the box: point, normal, friction, pusher's angle in degrees, pusher, and what is expected.
PUSHES = {
    "finger sticks": ((-0.05, -0.1), None, 0.5, 80, "finger"),
    "finger slips left": ((-0.05, -0.1), None, 0.5, 45, "finger"),
    "finger slips right": ((0.08, -0.1), None, 0.2, 120, "finger"),
    "fence sticks": ((-0.15, -0.1), (0.6, 0.8), 0.5, 60, "fence"),
    "fence slips left": ((-0.15, -0.1), (0.3, 0.95), 0.1, 120, "fence"),
}
#: The pusher's speed in m/s, from which inertia moves the box by less than the error, and its path in m.
SPEED, PATH = 0.01, 0.04
#: Error of position, and of turn times the radius of gyration, in m: 0.3 percent of the path.
ERROR = 1.2e-4


@pytest.mark.parametrize("push", PUSHES)
def test_a_slow_push_in_mujoco_is_ours(push):
    point, normal, mu, angle, pusher = PUSHES[push]
    velocity = SPEED * np.array([np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))])
    text = pp.to_mjcf(box(point, normal, mu=mu), pusher=pusher)
    found, _ = pushed(text, velocity, PATH / SPEED, 0.4)
    # Without inertia only the path counts: half of the start is at full speed.
    log = pp.simulate(
        box(point, normal, mu=mu, inertia=False),
        pusher=pp.Pusher(velocity=tuple(velocity), shape=pusher), duration=PATH / SPEED - 0.2, samples=2,
    )  # fmt: skip
    assert not log.stopped
    ends = log.isel(time=[0, -1])
    ours = np.append(np.diff(ends.position, axis=0), np.deg2rad(np.diff(ends.rod_angle)))
    scale = 1, 1, GYRATION
    assert np.abs(ours).max() > 0.01
    np.testing.assert_allclose(found * scale, ours * scale, atol=ERROR)


def test_a_pivot_of_solve_stays_in_mujoco():
    """Three equal feet, pushed across the radius of one, beyond the center: creep is 1e-4 of the speed."""
    friction = pp.SupportFriction(support=pp.Points.regular(3, 1.0))

    def scene(*effects):
        square = pp.Polygon.rectangle(3.0, 3.0)
        return pp.scene_at((-0.5, -1.5), effects=effects, contact=pp.Coulomb(0.5), outline=square)

    (solution,) = pp.solve(scene(friction), np.deg2rad(135))
    assert solution.pivot == 0
    given = scene(friction, pp.Inertia(gyration_radius=0.8))
    (_, _, turn), (v_x, v_y, spin) = pushed(
        pp.to_mjcf(given, pusher="finger"), 0.02 * np.array([-1, 1]) / np.sqrt(2), 4.0, 2.0
    )
    # The fence frame has the object's axes here, and the foot is at (1, 0) from the center.
    foot = np.array([v_x - spin * np.sin(turn), v_y + spin * np.cos(turn)])
    assert spin / 0.02 == pytest.approx(solution.twist[2], rel=0.05)
    assert np.hypot(*foot) < 1e-4 * 0.02
