"""Objects in a frame of their own: scenes, frames, outlines and what is refused."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from scipy.optimize import minimize_scalar

import planar_pushing as pp
from planar_pushing.mechanics.supports import polygon

SQUARE = pp.Polygon.rectangle(2.0, 2.0)
LEGS = pp.Points.rectangle(2.0, 2.0)
HOOK = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (0, 1)]


def scene_of(point, normal=None, support=SQUARE, outline=None, contact=None, more=()):
    effects = [pp.SupportFriction(support=support), *more]
    return pp.scene_at(
        point, normal, effects=effects, contact=contact or pp.Coulomb(1.0), outline=outline
    )


def test_the_check_value_of_the_square():
    """A push at (0.5, -1) of a square of side 2 with the velocity (0.3, 1)."""
    scene = scene_of((0.5, -1), (0, 1))
    (found,) = pp.solve(scene, np.arctan2(1, 0.3), np.hypot(0.3, 1))
    assert found.mode is pp.ContactMode.STICK
    assert scene.to_object(found.twist, "twist")[2] == pytest.approx(0.490713050, abs=1e-9)


OBJECTS = [
    ("square", SQUARE, (0.5, -1.0), (0.0, 1.0)),
    ("middle of a side", SQUARE, (1.0, 0.0), (-1.0, 0.0)),
    ("four feet", LEGS, (-1.0, 0.4), (1.0, 0.0)),
    ("slanted", pp.Polygon([(0, 0), (3, 0), (0, 4)]), (1.5, 2.0), (-4.0, -3.0)),
    ("far from its origin", pp.Disc(2.0, (100.0, -50.0)), (100.0, -52.0), (0.0, 1.0)),
    ("hook, below the fence", pp.Disc(0.5, (3.5, 2.5)), (1.0, 1.0), (0.0, -1.0)),
    ("contact at the center", SQUARE, (0.0, 0.0), (0.6, 0.8)),
    ("center along the fence", SQUARE, (3.0, 0.0), (0.0, 1.0)),
]


@pytest.mark.parametrize(("name", "support", "point", "normal"), OBJECTS)
def test_a_stick_minimizes_the_power_of_the_objects_friction(name, support, point, normal):
    """Route of its own: friction's power in the object's frame, minimized over the rotation."""
    effect = pp.SupportFriction(support=support, weight=3.5)
    scene = pp.scene_at(point, normal, effects=[effect], contact=pp.PerfectlyRough())
    n = np.array(normal) / np.hypot(*normal)
    velocity = 0.8 * n + 0.3 * np.array([n[1], -n[0]])
    found = next(
        each for each in pp.solve(scene, np.arctan2(0.8, 0.3), np.hypot(0.8, 0.3))
        if each.mode is pp.ContactMode.STICK
    )  # fmt: skip

    def twist(omega):
        """About the object's origin, the contact moving as the pusher."""
        return np.array([velocity[0] + omega * point[1], velocity[1] - omega * point[0], omega])

    best = minimize_scalar(
        lambda omega: float(pp.potential(effect, twist(omega))), bracket=(-1, 1), tol=1e-12
    )
    own = scene.to_object(found.twist, "twist")
    assert own == pytest.approx(twist(own[2]), abs=1e-9 * (1 + np.hypot(*point)))
    assert own[2] == pytest.approx(best.x, abs=2e-6)
    if found.pivot < 0:
        lever = scene.slider.rod_length * np.array(
            [np.cos(scene.slider.rod_angle), np.sin(scene.slider.rod_angle)]
        )
        torque = lever[1] * found.force[0] - lever[0] * found.force[1]
        load = scene.to_object([*found.force, torque], "wrench")
        assert load == pytest.approx(pp.wrench(effect, own), abs=1e-9 * (1 + np.hypot(*point)))


def test_the_choice_of_the_objects_frame_is_free():
    """An object that is turned and moved with its contact moves alike."""
    random = np.random.default_rng(5)
    for _ in range(20):
        angle, shift = random.uniform(-np.pi, np.pi), random.normal(size=2)
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        corners = np.array([(0, 0), (3, 0), (2, 2), (0, 1)])
        plain = scene_of((1.0, 0.0), support=pp.Polygon(corners), outline=corners)
        there = corners @ turn.T + shift
        moved = scene_of(turn @ [1.0, 0.0] + shift, support=pp.Polygon(there), outline=there)
        one, other = pp.solve(plain, 1.2)[0], pp.solve(moved, 1.2)[0]
        assert other.force == pytest.approx(one.force, abs=1e-12)
        assert other.twist == pytest.approx(one.twist, abs=1e-12)
        velocity = turn @ plain.to_object(one.contact_motion, "vector")
        assert moved.to_object(other.contact_motion, "vector") == pytest.approx(velocity, abs=1e-12)


@pytest.mark.parametrize("kind", ["vector", "point", "twist", "wrench"])
@pytest.mark.parametrize(("name", "support", "point", "normal"), OBJECTS)
def test_frames_there_and_back(kind, name, support, point, normal):
    scene = scene_of(point, normal, support)
    values = np.random.default_rng(1).normal(size=(4, 5, 2 if kind in ("vector", "point") else 3))
    there = scene.to_object(values, kind)
    assert there.shape == values.shape
    assert scene.to_fence(there, kind) == pytest.approx(values, abs=1e-13 * (1 + np.hypot(*point)))


def test_points_and_power_in_both_frames():
    scene = scene_of((0.5, -1), (0, 1))
    assert scene.to_object((0, 0), "point") == pytest.approx([0.5, -1])
    assert scene.to_object((1, 2), "point") == pytest.approx([1.5, 1])
    twist, wrench = np.random.default_rng(3).normal(size=(2, 3))
    power = scene.to_object(twist, "twist") @ scene.to_object(wrench, "wrench")
    assert power == pytest.approx(twist @ wrench)


def test_without_a_placement_the_objects_frame_is_the_body_frame():
    """`wrench` takes twists of the body frame: one frame for both."""
    slider = pp.Slider(rod_length=2.0, rod_angle=1.0, radius=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(pp.RingFriction(),))
    found = pp.solve(scene, 1.2)[0]
    load = pp.wrench(scene.effects[0], scene.to_object(found.twist, "twist"))
    assert scene.to_fence(load, "wrench")[:2] == pytest.approx(found.force)


@pytest.mark.parametrize("outline", [
    pp.Polygon([(0, 0), (0.31, 0), (0.3, 0.2), (0.02, 0.21)]),
    [(0, 0), (0.32, 0), (0.3, 0.2), (0.02, 0.21)],
], ids=["polygon", "list"])  # fmt: skip
def test_an_object_is_checked_once_for_all_of_its_contacts(monkeypatch, outline):
    called = []
    original = polygon.run

    def counted(name, *arguments):
        called.append(name)
        return original(name, *arguments)

    monkeypatch.setattr(polygon, "run", counted)
    support = pp.Polygon.rectangle(0.1, 0.13, (0.15, 0.1))
    rest = {"effects": (pp.SupportFriction(support=support),), "contact": pp.Coulomb(0.5)}
    called.clear()
    pp.scene_at((0.1, 0.0), outline=outline, **rest)
    first = called.count("crossing_edges")
    pp.scene_at((0.2, 0.0), outline=outline, **rest)
    assert called.count("crossing_edges") == first <= 1


def test_arrays_of_scenes_turn_arrays():
    slider = pp.Slider(rod_length=2.0, rod_angle=np.linspace(0.5, 2.5, 4), radius=1.0)
    scene = pp.Scene(slider=slider, contact=pp.Coulomb(1.0), effects=(pp.RingFriction(),))
    twists = np.random.default_rng(2).normal(size=(4, 3))
    there = scene.to_object(twists, "twist")
    assert scene.to_fence(there, "twist") == pytest.approx(twists)
    one = pp.Scene(
        slider=pp.Slider(rod_length=2.0, rod_angle=2.5, radius=1.0),
        contact=pp.Coulomb(1.0), effects=(pp.RingFriction(),),
    )  # fmt: skip
    assert there[3] == pytest.approx(one.to_object(twists[3], "twist"))


def test_loads_and_masses_are_turned():
    effects = [
        pp.SupportFriction(support=SQUARE, weight=2.0),
        pp.Inertia(center=(0.5, 0.25)),
        pp.Load(force=(0.1, 0.2), center=(0.5, 0.25)),
        pp.Viscous(support=LEGS),
    ]
    scene = pp.scene_at((1, 0), (-1, 0), effects=effects, contact=pp.Coulomb(1.0))
    friction, inertia, load, viscous = scene.effects
    assert load.force == pytest.approx((0.2, -0.1))  # +x is the object's +y, +y its -x
    # The rod points along -x of the object.
    assert inertia.center == pytest.approx((-0.5, -0.25))
    assert load.center == inertia.center
    assert viscous.support.center_of_pressure == pytest.approx((0, 0))
    assert friction.weight == 2.0


def test_an_object_with_inertia_alone_has_its_center_of_mass():
    effects = [pp.Inertia(mass=2.0, gyration_radius=0.3, center=(0.1, 0.2))]
    scene = pp.scene_at((0.1, 0.0), (0, 1), effects=effects, contact=pp.Coulomb(1.0))
    assert scene.slider.rod_length == pytest.approx(0.2)
    assert scene.effects[0].center == pytest.approx((0, 0))


class TestOutline:
    def test_the_side_is_that_of_the_contact(self):
        scene = scene_of((0.5, -1), outline=SQUARE)
        assert scene.slider.side == pytest.approx((-1.5, 0.5))
        assert scene.placement.normal == (0.0, 1.0)

    def test_clockwise_outlines_and_corners_within_a_side(self):
        corners = [(-1, -1), (0, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)]
        scene = scene_of((0, -1), outline=corners[::-1])
        assert scene.slider.side == pytest.approx((-1.0, 1.0))
        assert len(scene.slider.outline_in_body().corners) == 4

    def test_a_normal_that_is_measured_becomes_that_of_the_side(self):
        scene = scene_of((0.5, -1 - 1e-7), (1e-4, 2.0), outline=SQUARE)
        assert scene.placement.normal == (0.0, 1.0)

    def test_a_corner_takes_normals_between_those_of_its_sides(self):
        scene = scene_of((-1, -1), (1, 2), outline=SQUARE)
        assert scene.slider.side == (0.0, 0.0)
        for normal in [(1, -1), (-1, -1), (-0.1, 1)]:
            with pytest.raises(pp.InvalidValue, match="between those of the corner"):
                scene_of((-1, -1), normal, outline=SQUARE)

    def test_the_outline_is_in_the_body_frame(self):
        scene = scene_of((1, 1), (0, -1), pp.Disc(0.5, (3.5, 2.5)), outline=HOOK)
        corners = scene.to_fence(HOOK, "point")
        turn = scene.slider.rod_angle
        center = scene.slider.rod_length * np.array([np.cos(turn), np.sin(turn)])
        own = (corners - center) @ np.array(
            [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
        )
        assert np.array(scene.slider.outline_in_body().corners) == pytest.approx(own)


REFUSED = [
    ({"point": (0.5, -1.2)}, "a point on the outline; the nearest one is (0.5, -1)"),
    ({"point": (0.5, np.nan)}, "point: nan given; allowed: a finite number"),
    ({"point": "here"}, "point: 'here' given; allowed: two finite numbers"),
    ({"point": (0.5, -1), "normal": (0, 0)}, "normal: (0, 0) given; allowed: a nonzero vector"),
    ({"point": (0.5, -1), "normal": (0, -1)}, "allowed: the inward normal of the side, (0, 1)"),
    ({"point": (0.5, -1), "normal": (1, 1)}, "leave the normal out"),
    ({"point": (1, 1)}, "normal: None given; allowed: the normal of the fence at a corner"),
    ({"point": (0.5, -1), "outline": None}, "normal: None given; allowed: (n_x, n_y) without an outline"),
    ({"point": (0.5, -1), "outline": [(0, 0), (1, 1)]}, "allowed: at least three"),
    ({"point": (0, -2000), "normal": (0, 1), "outline": None}, "in one unit"),
    ({"point": (0.5, -1), "effects": []}, "effects: [] given"),
    ({"point": (0.5, -1), "effects": [pp.RingFriction()]}, "for a ring give the radius"),
    ({"point": (0.5, -1), "effects": [pp.SupportFriction()]}, "or support=Polygon(outline) for the whole"),
    ({"point": (0.5, -1), "effects": [pp.SupportFriction()], "outline": pp.rounded(SQUARE, 0.1)},
     "or support=Polygon(outline.vertices(tolerance)) for the whole outline"),
    ({"point": (0.5, -1), "effects": [pp.Load(force=(1, 0))]}, "friction or inertia among them"),
    ({"point": (0.5, -1), "contact": 2}, "contact: 2 given"),
    ({"point": (0.5, -1), "normal": [(0, 1), (0, 1)]}, "normal: [(0, 1), (0, 1)] given; allowed: two"),
    ({"point": [(0.5, -1)], "normal": [(0, 1)] * 2}, "normal: (2, 2) given; allowed: shape (2,) or (1, 2)"),
    ({"point": np.ma.masked_array([0.5, -1.0], [True, False])}, "fill the masked entries"),
    ({}, "point: None given; allowed: (x, y) of the contact; give it, or the number of a side"),
    ({"side": 4}, "side: 4 given; allowed: a whole number from 0 to 3"),
    ({"side": -1}, "side: -1 given; allowed: a whole number from 0 to 3"),
    ({"side": True}, "side: True given; allowed: a whole number from 0 to 3"),
    ({"side": 1.0}, "side: 1.0 given; allowed: a whole number from 0 to 3"),
    ({"side": [0, 1]}, "side: [0, 1] given; allowed: a whole number from 0 to 3"),
    ({"side": 0, "point": (0, -1)}, "point: (0, -1) given; allowed: none together with a side"),
    ({"side": 0, "normal": (0, 1)}, "normal: (0, 1) given; allowed: none together with a side"),
    ({"side": 0, "outline": None}, "outline: None given; allowed: the corners of the object"),
    ({"side": 3, "outline": HOOK}, "side: 3 given; allowed: a side with the whole object on one side"),
]  # fmt: skip


@pytest.mark.parametrize(("given", "said"), REFUSED)
def test_bad_input_is_one_line(given, said):
    defaults = {
        "normal": None,
        "effects": [pp.SupportFriction(support=SQUARE)],
        "contact": pp.Coulomb(1.0),
        "outline": SQUARE,
    }
    with pytest.raises(pp.InvalidValue) as caught:
        pp.scene_at(**(defaults | given))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("value", "kind", "said"),
    [
        ((1, 2), "twist", "shape S + (3,)"),
        ((1, 2, 3), "point", "shape S + (2,)"),
        ((1, 2), "axis", "kind: "),
    ],
)
def test_values_that_do_not_fit_their_kind(value, kind, said):
    with pytest.raises(pp.InvalidValue) as caught:
        scene_of((0.5, -1), (0, 1)).to_object(value, kind)
    assert said in str(caught.value)


class TestSides:
    @pytest.mark.parametrize("turn", [0.0, 0.3, -2.0])
    @pytest.mark.parametrize("order", [1, -1])
    def test_a_side_goes_from_its_corner_to_the_next(self, order, turn):
        c, s = np.cos(turn), np.sin(turn)
        corners = (np.array([(0, 0), (3, 0), (3, 1), (0, 2)]) @ [[c, s], [-s, c]])[::order]
        inside = corners.mean(0)
        for k in (0, 1, 2, np.int64(3)):
            effects = [pp.SupportFriction(support=pp.Polygon(corners))]
            scene = pp.scene_at(side=k, effects=effects, contact=pp.Coulomb(1.0), outline=corners)
            start, end = corners[k], corners[(k + 1) % 4]
            half = np.hypot(*(end - start)) / 2
            assert scene.slider.flush
            assert scene.slider.side == pytest.approx((-half, half))
            assert scene.placement.point == pytest.approx((start + end) / 2)
            assert np.dot(scene.placement.normal, inside - start) > 0
            assert np.dot(scene.placement.normal, end - start) == pytest.approx(0, abs=1e-12)
            ends = scene.to_object([(-half, 0), (half, 0)], "point")
            assert ends == pytest.approx(np.array([start, end])[::order], abs=1e-12)
            outline = scene.to_object(
                scene.slider.rod_length * np.array([np.cos(scene.slider.rod_angle),
                                                    np.sin(scene.slider.rod_angle)]), "point",
            )  # fmt: skip
            assert outline == pytest.approx(pp.Polygon(corners).center_of_pressure)

    def test_a_part_of_a_straight_side_stands_for_all_of_it(self):
        corners = [(-1, -1), (0, -1), (0.5, -1), (1, -1), (1, 1), (-1, 1)]
        given = {"effects": [pp.SupportFriction(support=SQUARE)], "contact": pp.Coulomb(1.0)}
        whole = pp.scene_at(side=0, outline=SQUARE.vertices, **given)
        for k in range(3):
            assert pp.scene_at(side=k, outline=corners, **given) == whole

    def test_parts_of_an_outline_on_one_line_are_one_contact(self):
        """A bridge on two piers: the fence touches both, and the ends are those of both together."""
        bridge = [(0, 0), (1, 0), (1, 1), (3, 1), (3, 0), (4, 0), (4, 2), (0, 2)]
        effects = [pp.SupportFriction(support=pp.Polygon(bridge))]
        scene = pp.scene_at(side=0, effects=effects, contact=pp.Coulomb(0.2), outline=bridge)
        assert scene.placement.point == (0.5, 0.0)
        assert scene.slider.side == (-0.5, 3.5)
        (stick,) = pp.solve(scene, np.pi / 2)
        assert (stick.flush, stick.force_position) == (True, pytest.approx(1.5))

    def test_a_file_holds_the_side(self, tmp_path):
        """As an object, and as the scene that it makes."""
        file = tmp_path / "box.yaml"
        file.write_text(
            "object:\n  outline: [[-1, -1], [1, -1], [1, 1], [-1, 1]]\n  contact: {side: 1}\n"
            "contact: {law: coulomb, friction_coefficient: 0.5}\neffects: [{type: support_friction}]\n"
        )
        scene = pp.load_scene(file)
        effects = [pp.SupportFriction(support=pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)]))]
        given = {"effects": effects, "contact": pp.Coulomb(0.5)}
        assert scene == pp.scene_at(side=1, outline=SQUARE.vertices, **given)
        pp.save_scene(scene, tmp_path / "scene.yaml")
        assert "flush: true" in (tmp_path / "scene.yaml").read_text()
        assert pp.load_scene(tmp_path / "scene.yaml") == scene
        file.write_text(file.read_text().replace("side: 1", "side: 4"))
        with pytest.raises(
            pp.InvalidFile, match=r"object\.contact\.side: 4 given; allowed: a whole number"
        ):
            pp.load_scene(file)

    def test_a_file_without_a_side_is_as_before(self, tmp_path):
        pp.save_scene(scene_of((0.5, -1), (0, 1)), tmp_path / "scene.yaml")
        assert "flush" not in (tmp_path / "scene.yaml").read_text()


class TestWeight:
    def test_the_box_of_the_manual(self):
        """Sec. 8 of the contract: 1.2 kg on a table with a coefficient of 0.3."""
        assert pp.weight(1.2, 0.3) == pytest.approx(3.530394)

    @pytest.mark.parametrize(
        ("given", "name"),
        [
            ((0.0, 0.3), "mass"),
            ((1.2, -0.3), "support_friction"),
            ((1.2, 0.3, 0.0), "gravity"),
            ((np.float64(1e308), np.array([0.3, 1.0]), 10), "weight"),
            ((10**400, 1.0), "mass"),
        ],
    )
    def test_bad_input(self, given, name):
        with pytest.raises(pp.InvalidValue, match=f"^{name}: "):
            pp.weight(*given)

    @pytest.mark.parametrize("dtype", ["i1", "u8", "f2", "f8"])
    def test_products_of_small_types_are_doubles(self, dtype):
        m, mu, g = np.array([100, 120], dtype), np.array([2], dtype)[0], np.array(10, dtype)
        found = pp.weight(m, mu, g)
        assert found.dtype == np.float64
        assert found.tolist() == [2000.0, 2400.0]
        assert pp.weight(m[0], mu, g) == 2000.0
        labeled = pp.weight(xr.DataArray(m, dims="case"), mu, g)
        assert (labeled.dims, labeled.dtype) == (("case",), np.float64)
        assert labeled.values.tolist() == [2000.0, 2400.0]
        lazy = pp.weight(xr.DataArray(m, dims="case").chunk(case=1), mu, g)
        assert lazy.chunks == ((1, 1),)
        assert lazy.values.tolist() == [2000.0, 2400.0]

    def test_the_index_of_a_table_does_not_count(self):
        mass, friction = pd.Series([1.0, 2.0]), pd.Series([0.5, 0.25], index=[1, 0])
        assert pp.weight(mass, friction, 10.0).tolist() == [5.0, 5.0]

    def test_numbers_of_python_stay_so(self):
        assert type(pp.weight(2, 1, 10)) is float


class TestManyContacts:
    PLACES = np.array([(-0.8, -1), (0.0, -1), (0.5, -1), (1, 0.3)])

    def effects(self):
        return [
            pp.SupportFriction(support=LEGS, weight=2.0),
            pp.Inertia(center=(0.2, 0.1), gyration_radius=0.8),
            pp.Load(force=(0.1, 0.2)),
        ]

    def test_twists_go_back_each_by_its_own_contact(self):
        given = {"effects": self.effects()[:1], "contact": pp.PerfectlyRough(), "outline": SQUARE}
        many = pp.scene_at(self.PLACES, **given)
        twists = pp.solve(many, 1.3).twist[:, 0]
        for i, place in enumerate(self.PLACES):
            own = pp.scene_at(place, **given).to_object(twists[i], "twist")
            assert many.to_object(twists, "twist")[i] == pytest.approx(own)


class TestHooks:
    def test_a_load_without_a_point_acts_at_the_center_of_pressure(self):
        weight = pp.SupportFriction(support=pp.Disc(0.5, (3.5, 2.5)), weight=2.0)
        load = pp.Load(force=(0.3, 0.4))
        given = {"contact": pp.Coulomb(1.0), "outline": HOOK}
        one = pp.scene_at((1, 1), effects=[weight, load], **given)
        other = pp.scene_at(
            (1, 1), effects=[weight, pp.Load(force=(0.3, 0.4), center=(3.5, 2.5))], **given
        )
        assert one == other


class TestUnits:
    def scene(self, *more):
        effects = [pp.SupportFriction(support=SQUARE), *more]
        return pp.scene_at(
            (0.5, -1), effects=effects, contact=pp.Coulomb(1.0), outline=SQUARE,
            units=pp.Units(length="mm"),
        )  # fmt: skip

    def test_labeled_results_have_the_units_of_the_scene(self):
        xr = pytest.importorskip("xarray")
        angles = xr.DataArray([1.0, 1.5], dims="push")
        found = pp.solve(self.scene(), angles)
        assert found.force.units == "N"
        assert found.twist_unit.values.tolist() == ["mm s-1", "mm s-1", "radian s-1"]
        assert found.center.units == "mm"
        assert "quantity" not in found.force.attrs
        dynamic = pp.solve(self.scene(pp.Inertia()), angles)
        assert dynamic.contact_motion.units == "mm s-2"
        assert dynamic.twist_unit.values.tolist() == ["mm s-2", "mm s-2", "radian s-2"]
        motion = pp.motion_of_force(self.scene(), angles)
        assert motion.twist_unit.values.tolist() == ["mm s-1", "mm s-1", "radian s-1"]
        assert pp.limit_curve(self.scene(), angles).magnitude.units == "N"
        assert pp.motion_centers(self.scene(), angles).units == "mm"

    def test_logs_and_batches_have_them_too(self, tmp_path):
        pusher = pp.Pusher(velocity=(0.0, 1.0), shape="finger")
        log = pp.simulate(self.scene(), pusher=pusher, duration=0.1)
        streamed = pp.simulate(self.scene(), pusher=pusher, duration=0.1, path=tmp_path / "log.nc")
        batch = pp.simulate_batch(self.scene(), pusher, duration=np.array([0.1, 0.2]))
        for found in (log, streamed, batch):
            assert found.slip.attrs["units"] == "mm"
            assert found.time.attrs["units"] == "s"
        assert log.force.attrs["units"] == "N"
        assert log.work.attrs["units"] == "N mm"

    @pytest.mark.parametrize("given", [3, "", " "])
    def test_a_name_is_text(self, given):
        with pytest.raises(pp.InvalidValue, match="the name of a unit"):
            pp.Units(force=given)


FORMS = {
    "floats": ((0.1, -0.25), [(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)]),
    "lists": ([0.1, -0.25], [[-0.5, -0.25], [0.5, -0.25], [0.5, 0.25], [-0.5, 0.25]]),
    "array": (
        np.array([0.1, -0.25]),
        np.array([(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)]),
    ),
    "numbers of numpy": (
        (np.float64(0.1), np.float64(-0.25)),
        pp.Polygon([(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)]),
    ),
    "an array of one contact": (
        np.array([[0.1, -0.25]]), [(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)],
    ),
}  # fmt: skip


@pytest.mark.parametrize("normal", [None, (0.0, 2.0)])
def test_a_contact_given_in_any_form_has_the_same_scene(normal):
    """Floats take another route than arrays."""
    slab = pp.Polygon([(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)])
    effects = [pp.SupportFriction(support=slab), pp.Inertia(gyration_radius=0.3)]
    scenes = {
        name: pp.scene_at(point, normal, effects=effects, contact=pp.Coulomb(0.3), outline=outline)
        for name, (point, outline) in FORMS.items()
    }
    for scene in scenes.values():
        assert np.array_equal(np.ravel(_numbers(scene)), np.ravel(_numbers(scenes["floats"])))
        assert np.array_equal(np.ravel(scene.placement.normal), [0.0, 1.0])


def _numbers(scene):
    return scene.slider.rod_length, scene.slider.rod_angle, *scene.slider.side


def test_every_contact_of_a_doubtful_object_warns():
    """Its doubts are found once and told at each contact."""
    beside = [pp.SupportFriction(support=pp.Disc(0.1, (3.0, 0.0)))]
    for x in (0.1, 0.2):
        with pytest.warns(pp.SceneWarning, match="100 % of the pressure lies outside"):
            pp.scene_at(
                (x, -0.25), effects=beside, contact=pp.Coulomb(0.3), outline=FORMS["floats"][1]
            )


@pytest.mark.parametrize("wrong", [True, "0.5", None, float("nan"), 1j])
def test_an_outline_that_equals_a_known_one_is_checked(wrong):
    """True equals 1.0, and its hash does, too."""
    good = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    effects = [pp.SupportFriction(support=pp.Disc(0.3, (0.5, 0.5)))]
    pp.scene_at((0.5, 0.0), effects=effects, contact=pp.Coulomb(0.3), outline=good)
    with pytest.raises(pp.InvalidValue, match="outline"):
        pp.scene_at(
            (0.5, 0.0), effects=effects, contact=pp.Coulomb(0.3),
            outline=[good[0], (wrong, 0.0), *good[2:]],
        )  # fmt: skip


#: Outlines, and the squares of the radii of gyration of uniform plates about their centroids.
PLATES = {
    "disc": (pp.Disc(0.8, center=(0.1, 0.2)), 0.8**2 / 2.0),
    "box": ([(-1, -0.5), (2, -0.5), (2, 0.5), (-1, 0.5)], 10.0 / 12.0),
    "ring": (pp.Outline(pp.Disc(1.0), holes=[pp.Disc(0.5)]), 1.25 / 2.0),
}


@pytest.mark.parametrize("name", PLATES)
@pytest.mark.parametrize("center", [None, (0.3, -0.2)])
def test_a_mass_with_an_outline_is_a_uniform_plate(name, center):
    outline, square = PLATES[name]
    whole = pp.Outline(outline)
    effects, law = (pp.Inertia(mass=2.0, center=center),), pp.Coulomb(0.3)
    if center is not None:
        square += (center[0] - whole.centroid[0]) ** 2 + (center[1] - whole.centroid[1]) ** 2
    points = whole.vertices(0.3 * whole.size)
    points = 0.5 * (points[:2] + points[1:3]) if name == "box" else points[:2]
    scenes = [pp.scene_at(point, effects=effects, contact=law, outline=outline) for point in points]
    scenes.append(pp.scene_at(points, effects=effects, contact=law, outline=outline))
    # The same scene of a slider, whose center is in the body frame.
    one = scenes[0]
    bare = pp.Inertia(mass=2.0, center=one.effects[0].center)
    scenes.append(pp.Scene(slider=one.slider, contact=law, effects=(bare,)))
    for scene in scenes:
        assert scene.effects[0].gyration_radius == pytest.approx(np.sqrt(square), rel=1e-14)
    free = pp.scene_at((0, 0), (0, 1), effects=(pp.Inertia(center=(0, 1)),), contact=law)
    assert free.effects[0].gyration_radius == 1.0


def test_a_rounded_plate_has_the_gyration_of_a_fine_polygon():
    box = pp.rounded([(-1, -0.5), (2, -0.5), (2, 0.5), (-1, 0.5)], 0.2)
    # Sums over a grid of midpoints, and over the triangles of a polygon.
    x, y = np.meshgrid(np.arange(-1, 2, 1e-3) + 5e-4, np.arange(-0.5, 0.5, 1e-3) + 5e-4)
    away = np.hypot(np.maximum(np.abs(x - 0.5) - 1.3, 0.0), np.maximum(np.abs(y) - 0.3, 0.0))
    inside = away <= 0.2
    square = (((x - 0.5) ** 2 + y**2)[inside]).mean()
    scene = pp.scene_at((0, -0.5), effects=(pp.Inertia(),), contact=pp.Coulomb(0.3), outline=box)
    assert scene.effects[0].gyration_radius == pytest.approx(np.sqrt(square), rel=1e-5)
    fine = pp.scene_at(
        (0, -0.5), effects=(pp.Inertia(),), contact=pp.Coulomb(0.3), outline=box.vertices(1e-6)
    )
    assert fine.effects[0].gyration_radius == pytest.approx(
        scene.effects[0].gyration_radius, rel=1e-5
    )


@pytest.mark.parametrize(("outline", "radius"), [
    ("{disc: {radius: 0.8}}", 0.8 / np.sqrt(2.0)),
    ("[[-1, -0.8], [1, -0.8], [1, 0.8], [-1, 0.8]]", np.sqrt((4.0 + 2.56) / 12.0)),
])  # fmt: skip
def test_a_mass_of_a_file_is_a_uniform_plate(tmp_path, outline, radius):
    path = tmp_path / "plate.yaml"
    path.write_text(
        f"object:\n  outline: {outline}\n  contact: {{point: [0, -0.8]}}\n"
        "contact: {law: coulomb, friction_coefficient: 0.3}\neffects: [{type: inertia, mass: 2}]\n"
    )
    scene = pp.load_scene(path)
    assert scene.effects[0].gyration_radius == pytest.approx(radius, rel=1e-14)
    pp.save_scene(scene, path)
    assert pp.load_scene(path).effects[0].gyration_radius == pytest.approx(radius, rel=1e-14)
