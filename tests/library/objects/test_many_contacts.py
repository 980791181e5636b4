"""One object at many contacts: an array of scenes equals the scenes of the contacts one by one."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest
import xarray as xr
from mechanics.supports.cases import SUPPORTS

import planar_pushing as pp

SQUARE = pp.Polygon.rectangle(2.0, 2.0)
#: Supports that have a place of their own, all but rings of the slider's radius, and the factors by which
#: their shape multiplies rounding.
PLACED = {
    name: case[:2] if isinstance(case, tuple) else (case, 1)
    for name, case in SUPPORTS.items()
    if getattr(case[0] if isinstance(case, tuple) else case, "radius", 0) is not None
}
PLACED["ring about the origin"] = pp.Ring(1.0), 1
#: Contacts along the axes, at corners, at the center, far away and askew, shape (2, 5, 2), and normals.
POINTS = np.array([
    [(0.5, -1.0), (1.0, 0.0), (-1.0, -1.0), (0.0, 0.0), (30.0, 20.0)],
    [(-0.3, 1.0), (0.2, -0.7), (-1.0, 0.4), (1e-9, -1.0), (0.3, 0.1)],
])  # fmt: skip
NORMALS = np.array([
    [(0.0, 1.0), (-2.0, 0.0), (1.0, 2.0), (0.6, 0.8), (-3.0, -2.0)],
    [(0.0, -1.0), (-0.3, 0.9), (1.0, 0.0), (0.0, 1.0), (1.0, 0.1)],
])  # fmt: skip
ANGLES = np.array([0.3, np.pi / 2, 2.5])[:, None, None]


def own_kind(support, hash_of=object.__hash__, in_frame_as=None):
    """The same support as a class of a user, with no more than the manual asks for.

    It can become another one in another frame.
    """

    class Own:
        __hash__ = hash_of
        center_of_pressure, extent = support.center_of_pressure, support.extent

        def pieces(self):
            return support.pieces()

        def in_frame(self, frame):
            return own_kind((in_frame_as or support).in_frame(frame), hash_of)

    return Own()


def effects_of(support):
    return [
        pp.SupportFriction(support=support, weight=2.0),
        pp.Inertia(mass=3.0, gyration_radius=0.15, center=(0.2, 0.1)),
        pp.Load(force=(0.1, 0.2)),
    ]


def one_by_one(points, normals, **given):
    normals = np.broadcast_to(normals, points.shape)
    return [
        pp.scene_at(point, normal, **given)
        for point, normal in zip(points.reshape(-1, 2), normals.reshape(-1, 2), strict=True)
    ]


def flat(pair):
    return np.stack([np.ravel(each) for each in pair], axis=-1).tolist()


@pytest.mark.parametrize("name", PLACED)
def test_every_number_of_a_scene_is_that_of_its_contact(name):
    given = {"effects": effects_of(PLACED[name][0]), "contact": pp.Coulomb(0.5)}
    many, ones = pp.scene_at(POINTS, NORMALS, **given), one_by_one(POINTS, NORMALS, **given)
    assert many.slider.rod_length.shape == POINTS.shape[:-1]
    assert many.slider.rod_length.ravel().tolist() == [one.slider.rod_length for one in ones]
    assert many.slider.rod_angle.ravel().tolist() == [one.slider.rod_angle for one in ones]
    assert flat(many.slider.side) == [[-np.inf, np.inf]] * len(ones)
    assert many.slider.radius == pytest.approx(ones[0].slider.radius, rel=1e-14)
    assert flat(many.placement.point) == [list(one.placement.point) for one in ones]
    assert flat(many.placement.normal) == [list(one.placement.normal) for one in ones]
    friction, inertia, load = many.effects
    assert friction.support.shape == POINTS.shape[:-1]
    assert np.ravel(friction.support).tolist() == [one.effects[0].support for one in ones]
    assert flat(inertia.center) == [list(one.effects[1].center) for one in ones]
    assert flat(load.force) == [list(one.effects[2].force) for one in ones]
    assert load.center is None


@pytest.mark.parametrize("name", PLACED)
def test_wrenches_are_those_of_the_supports_in_each_frame(name):
    """With centers of rotation on the support, beside it and far from it.

    Exactly, but for plates, and for rings, which have formulas of their own about the slider's center.
    """
    support, factor = PLACED[name]
    given = {"effects": effects_of(PLACED[name][0])[:1], "contact": pp.Coulomb(0.5)}
    effect = pp.scene_at(POINTS, NORMALS, **given).effects[0]
    twists = np.random.default_rng(4).normal(size=(30, *POINTS.shape[:-1], 3))
    twists[..., 2] *= np.geomspace(1e3, 1e-6, 30)[:, None, None]
    found = pp.wrench(effect, twists)
    for there in np.ndindex(*POINTS.shape[:-1]):
        own = pp.wrench(
            pp.SupportFriction(support=effect.support[there], weight=2.0), twists[:, *there]
        )
        if support.pieces().plates or isinstance(support, pp.Ring):
            assert found[:, *there] == pytest.approx(own, abs=2e-14 * factor)
        else:
            assert np.array_equal(found[:, *there], own)


@pytest.mark.parametrize("name", PLACED)
def test_motions_are_those_of_the_contacts(name):
    for effects in (effects_of(PLACED[name][0]), effects_of(PLACED[name][0])[:1]):
        given = {"effects": effects, "contact": pp.InfiniteFriction()}
        found = pp.solve(pp.scene_at(POINTS, NORMALS, **given), ANGLES)
        for i, one in enumerate(one_by_one(POINTS, NORMALS, **given)):
            there = np.unravel_index(i, POINTS.shape[:-1])
            own = pp.solve(one, ANGLES[:, 0, 0])
            for field in ("status", "mode", "pivot"):
                assert np.array_equal(getattr(found, field)[:, *there], getattr(own, field))
            # A far contact has a long rod, which multiplies the rounding of the twist.
            near = 1e-13 * PLACED[name][1] * max(1.0, one.slider.rod_length)
            assert found.twist[:, *there] == pytest.approx(own.twist, abs=near, nan_ok=True)


#: Shapes of numbers of an effect that broadcast against the shape (2, 5) of the contacts.
SHAPES = [(), (1,), (5,), (2, 1), (1, 5), (2, 5)]


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("outline", [None, SQUARE], ids=["free", "outline"])
def test_arrays_of_loads_and_masses_are_those_of_the_contacts(shape, outline):
    """Each component is turned with the frame of its own contact."""
    random = np.random.default_rng(len(shape) * 7 + 3)
    numbers = random.uniform(-0.4, 0.4, (5, *shape))
    numbers[4] += 1.0  # the mass

    def effects(fx, fy, x, y, mass):
        return [
            pp.SupportFriction(support=SQUARE, weight=2.0),
            pp.Inertia(mass=mass, gyration_radius=0.5, center=(x, y)),
            pp.Load(force=(fx, fy), center=(0.2, -0.1)),
        ]

    given = {"contact": pp.Coulomb(0.5), "outline": outline}
    points, normals = POINTS, NORMALS
    if outline is not None:
        x, side = random.uniform(-0.9, 0.9, (2, 5)), random.integers(0, 2, (2, 5)) * 2.0 - 1.0
        points, normals = np.stack([x, side], axis=-1), np.stack([0.0 * x, -side], axis=-1)
    found = pp.solve(pp.scene_at(points, normals, effects=effects(*numbers), **given), ANGLES)
    each = np.stack([np.broadcast_to(component, points.shape[:-1]) for component in numbers])
    for there in np.ndindex(*points.shape[:-1]):
        one = pp.scene_at(
            points[there], normals[there], effects=effects(*each[:, *there].tolist()), **given
        )
        own = pp.solve(one, ANGLES[:, 0, 0])
        assert np.array_equal(found.mode[:, *there], own.mode)
        for field in ("twist", "force"):
            own_field = getattr(own, field)
            near = 1e-12 * max(1.0, one.slider.rod_length)
            assert getattr(found, field)[:, *there] == pytest.approx(
                own_field, rel=1e-12, abs=near, nan_ok=True
            )


def test_a_support_of_a_user_is_expressed_at_each_contact():
    otherwise = own_kind(SQUARE, in_frame_as=pp.Disc(1.0))
    for own in (own_kind(SQUARE), otherwise, pp.Composite([(1.0, SQUARE), (2.0, otherwise)])):
        given = {"effects": effects_of(own), "contact": pp.Coulomb(0.5)}
        found = pp.solve(pp.scene_at(POINTS, NORMALS, **given), ANGLES)
        for i, one in enumerate(one_by_one(POINTS, NORMALS, **given)):
            there = np.unravel_index(i, POINTS.shape[:-1])
            own = pp.solve(one, ANGLES[:, 0, 0]).twist
            near = 1e-13 * max(1.0, one.slider.rod_length)
            assert found.twist[:, *there] == pytest.approx(own, abs=near, nan_ok=True)


def test_supports_without_another_frame_are_one_line():
    class Fixed:
        center_of_pressure, extent = (0.0, 0.0), 1.0

        def pieces(self):
            return pp.Disc(1.0).pieces()

    given = {"contact": pp.Coulomb(0.5)}
    for support, said in (
        (Fixed(), "a method in_frame"),
        (pp.Composite([(1.0, Fixed())]), "a method in_frame"),
        (pp.Ring(), "a ring with its radius"),
    ):
        with pytest.raises(pp.InvalidValue, match=said):
            pp.scene_at(POINTS, NORMALS, effects=[pp.SupportFriction(support=support)], **given)
    point = pp.SupportFriction(support=pp.Points([(1.0, 2.0)]))
    scenes = pp.scene_at(
        POINTS, NORMALS, effects=[pp.SupportFriction(support=SQUARE), point], **given
    )
    with pytest.raises(pp.InvalidValue, match="a support with more than one point"):
        pp.solve(scenes, 1.2)


def test_viscous_friction_is_refused():
    with pytest.raises(pp.InvalidValue, match="effects without viscous friction for an array"):
        pp.scene_at(POINTS, NORMALS, effects=[pp.Viscous(support=SQUARE)], contact=pp.Coulomb(0.5))


def test_the_object_is_checked_once(monkeypatch):
    made = []
    check = pp.Polygon.__post_init__
    monkeypatch.setattr(pp.Polygon, "__post_init__", lambda self: (made.append(1), check(self)))
    counts = []
    for count in (1, 1, 500):  # the first one checks what later ones know
        made.clear()
        points = np.column_stack([np.linspace(-0.9, 0.9, count), np.full(count, -1.0)])
        given = {"effects": effects_of(SQUARE), "contact": pp.Coulomb(0.5), "outline": SQUARE}
        pp.solve(pp.scene_at(points, **given), 1.2)
        counts.append(len(made))
    assert counts[1] == counts[2]


def test_rings_about_their_centers_are_the_papers():
    given = {"contact": pp.Coulomb(0.5), "effects": [pp.SupportFriction(support=pp.Ring(1.0))]}
    points = np.array([(1.0, 0.0), (0.0, -2.0), (-3.0, 0.0), (0.1, 0.7)])
    normals = np.array([(-1.0, 0.0), (0.0, 1.0), (1.0, 0.0), (0.3, -0.7)])
    ones = [one.isotropic for one in one_by_one(points, normals, **given)]
    assert ones == [True, True, True, False]
    assert pp.scene_at(points[:3], normals[:3], **given).isotropic
    assert not pp.scene_at(points, normals, **given).isotropic


class TestOutline:
    HOOK = ((0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (0, 1))
    #: On sides, a little beside them, and at outer corners, with normals between and of their sides.
    POINTS = np.array(
        [(2, 0), (0, 0.3), (1, 1 + 1e-7), (3, 2), (3.5, 3), (0, 0), (4, 3), (4, 3 - 1e-6)]
    )
    NORMALS = np.array(
        [(0, 1), (1, 1e-4), (0, -1), (1, 0), (0, -2), (1, 2), (-1, -1), (-1, 0)], dtype=float
    )

    def given(self):
        return {
            "effects": effects_of(pp.Disc(0.5, (3.5, 2.0))),
            "contact": pp.Coulomb(0.5),
            "outline": self.HOOK,
        }

    def test_normals_and_sides(self):
        many = pp.scene_at(self.POINTS, self.NORMALS, **self.given())
        ones = one_by_one(self.POINTS, self.NORMALS, **self.given())
        assert flat(many.placement.point) == [list(one.placement.point) for one in ones]
        assert flat(many.placement.normal) == [list(one.placement.normal) for one in ones]
        assert flat(many.slider.side) == [list(one.slider.side) for one in ones]
        assert many.slider.rod_angle.tolist() == [one.slider.rod_angle for one in ones]
        assert many.slider.outline == ones[0].slider.outline
        assert np.shape(many.slider.outline_frame.origin[0]) == (len(self.POINTS),)
        sides = [(-2, 2), (-0.7, 0.3), (-2, 1), (-1, 1), (-0.5, 0.5), (0, 0), (0, 0), (-3, 0)]
        assert np.column_stack(many.slider.side) == pytest.approx(np.array(sides))
        assert flat(many.placement.point)[:4] == [[2.0, 0.0], [0.0, 0.3], [1.0, 1.0], [3.0, 2.0]]
        assert flat(many.placement.normal)[:4] == [[0.0, 1.0], [1.0, 0.0], [0.0, -1.0], [1.0, 0.0]]

    def test_one_normal_for_all(self):
        points = np.array([(1.0, 0.0), (2.0, 0.0)])
        many = pp.scene_at(points, (0, 3), **self.given())
        assert flat(many.placement.normal) == [[0.0, 1.0]] * 2

    @pytest.mark.parametrize(
        ("number", "point", "normal", "said"),
        [
            (
                3,
                (1, 0.5),
                (0, 1),
                r"point: array\(\[1. , 0.5\]\) given; .* nearest one is \(1, 0\)",
            ),
            (0, (np.nan, 0), (0, 1), r"point: nan given; allowed: a finite number"),
            (2, (2, 0), (0, 0), r"normal: \(0.0, 0.0\) given; allowed: a nonzero vector"),
            (5, (2, 0), (1, 1), r"normal: array\(\[1., 1.\]\) given; .* side, \(0, 1\); with"),
            (7, (0, 0), (-1, 0), r"normal: \(-1.0, 0.0\) given; .* those of the corner's sides"),
            (
                6,
                (3, 1),
                (1, 0),
                r"normal: array\(\[1., 0.\]\) given; .* bisector .*; leave the normal out",
            ),
        ],
    )
    def test_the_contact_that_is_refused_is_named(self, number, point, normal, said):
        points, normals = self.POINTS.copy(), self.NORMALS.copy()
        points[number], normals[number] = point, normal
        with pytest.raises(pp.InvalidValue, match=said):
            pp.scene_at(points, normals, **self.given())

    def test_corners_need_normals(self):
        with pytest.raises(pp.InvalidValue, match="the normal of the fence at a corner"):
            pp.scene_at(self.POINTS, **self.given())

    def test_a_contact_in_another_unit(self):
        points = np.array([(0.0, -1.0), (0.0, -2000.0)])
        given = {"effects": effects_of(SQUARE), "contact": pp.Coulomb(0.5)}
        with pytest.raises(pp.InvalidValue, match=r"a contact 2000 from the center .* in one unit"):
            pp.scene_at(points, (0, 1), **given)


class TestLabels:
    def scenes(self, points):
        return pp.scene_at(points, NORMALS, effects=effects_of(SQUARE), contact=pp.Coulomb(0.5))

    def points(self):
        return xr.DataArray(
            POINTS, dims=("row", "place", "xy"),
            coords={"place": list("abcde"), "xy": ["x", "y"], "depth": ("row", [1.0, 2.0])},
        )  # fmt: skip

    def test_all_numbers_have_the_dimensions_of_the_points(self):
        scenes, plain = self.scenes(self.points()), self.scenes(POINTS)
        friction, inertia, load = scenes.effects
        numbers = [
            scenes.slider.rod_length, scenes.slider.rod_angle, *scenes.slider.side,
            *scenes.placement.point, *scenes.placement.normal, *inertia.center, *load.force,
            friction.support.array,
        ]  # fmt: skip
        for each in numbers:
            assert each.dims == ("row", "place")
            assert set(each.coords) == {"place", "depth"}
        assert np.array_equal(scenes.slider.rod_angle.values, plain.slider.rod_angle)
        found, own = pp.solve(scenes, 1.2), pp.solve(plain, 1.2)
        assert found.twist.dims == ("row", "place", "solution", "twist_component")
        assert np.array_equal(found.twist.values, own.twist, equal_nan=True)

    def test_lazy_points(self):
        lazy = self.scenes(self.points().chunk(place=2))
        assert np.array_equal(lazy.slider.rod_length.values, self.scenes(POINTS).slider.rod_length)

    def test_the_array_of_supports_has_them_too(self):
        support = self.scenes(self.points()).effects[0].support
        assert support.sel(place="c").values[0] == support[0, 2].item()


class TestSupports:
    def support(self):
        effects = [pp.SupportFriction(support=SQUARE)]
        scenes = pp.scene_at(POINTS, NORMALS, effects=effects, contact=pp.Coulomb(0.5))
        return scenes.effects[0].support

    def test_they_read_as_an_array(self):
        support = self.support()
        assert (len(support), support.ndim, support.size) == (2, 2, 10)
        assert repr(support) == repr(np.asarray(support))
        assert support[1, 2] == support.ravel()[7] == list(support)[1][2]
        assert isinstance(support[0, 0], pp.Polygon)

    @pytest.mark.parametrize(
        "copied", [copy.copy, copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))]
    )
    def test_they_can_be_copied(self, copied):
        support = self.support()
        assert np.array_equal(np.asarray(copied(support)), np.asarray(support))


def test_the_cones_of_two_supports():
    effects = [effects_of(SQUARE)[0], pp.SupportFriction(support=pp.Disc(0.5, (0.2, 0.0)))]
    given = {"effects": effects, "contact": pp.Coulomb(0.5)}
    found = pp.motion_cone(pp.scene_at(POINTS, NORMALS, **given))
    for i, one in enumerate(one_by_one(POINTS, NORMALS, **given)):
        there = np.unravel_index(i, POINTS.shape[:-1])
        own = pp.motion_cone(one)
        assert found.right[there] == pytest.approx(own.right, abs=1e-12)
        assert found.left[there] == pytest.approx(own.left, abs=1e-12)


def test_arrays_of_scenes_are_compared():
    given = {"effects": effects_of(SQUARE), "contact": pp.Coulomb(0.5)}
    one, other = (pp.scene_at(POINTS, NORMALS, **given) for _ in range(2))
    assert (one == other) is True
    assert (one == pp.scene_at(POINTS, NORMALS[..., ::-1], **given)) is False
    assert (one == pp.scene_at(POINTS, NORMALS, **given | {"contact": pp.Coulomb(1.0)})) is False
    disc = given | {"effects": effects_of(pp.Disc(2.0**0.5))}
    assert (one == pp.scene_at(POINTS, NORMALS, **disc)) is False


def test_supports_that_cannot_be_hashed():
    own = own_kind(SQUARE, None)
    given = {"effects": [pp.SupportFriction(support=own)], "contact": pp.Coulomb(0.5)}
    with pytest.raises(TypeError, match="unhashable"):
        hash(own)
    scene = pp.scene_at((0.5, -1.0), (0.0, 1.0), **given)
    other = pp.scene_at(
        (0.5, -1.0), (0.0, 1.0), **given | {"effects": [pp.SupportFriction(support=SQUARE)]}
    )
    assert pp.solve(scene, 1.2)[0].force.tolist() == pp.solve(other, 1.2)[0].force.tolist()
    assert scene._repr_svg_().count("<svg") == 1
    assert len(pp.pushes_for(given["effects"], (0.0, 1.0, 0.1), SQUARE)) == len(
        pp.pushes_for([pp.SupportFriction(support=SQUARE)], (0.0, 1.0, 0.1), SQUARE)
    )


#: Supports without plates, whose numbers in a frame are the same for one contact and for many.
EXACT = {
    "feet": pp.Points([(0.5, 0.1), (-0.4, 0.3), (0.03, -0.41)], weights=[1.0, 2.0, 0.7]),
    "disc": pp.Disc(0.5, (0.1, 0.05)),
    "ring": pp.Ring(0.4, (0.1, -0.02)),
    "segment": pp.Segment((-0.3, 0.1), (0.45, 0.21)),
    "feet and a disc": pp.Composite([
        (2.0, pp.Disc(0.2, (0.1, 0.3))), (1.0, pp.Points([(0, 0), (0.3, -0.2)])),
    ]),
}  # fmt: skip


@pytest.mark.parametrize("massive", [False, True])
@pytest.mark.parametrize("name", [*EXACT, "square"])
def test_runs_of_many_contacts_are_those_of_each(name, massive):
    """To the last bit, but for rounding of polygons; the slider has one radius under every support."""
    support = (EXACT | {"square": SQUARE})[name]
    effects = [pp.SupportFriction(support=support)]
    effects += [pp.Inertia(gyration_radius=0.5, center=(0.1, 0.0))] * massive
    outline, law = pp.rounded(SQUARE.vertices, 0.2), pp.Coulomb(0.3)
    along = np.random.default_rng(5).uniform(-0.75, 0.75, 12)
    points = np.stack([along, np.full(12, -1.0)], axis=-1)
    finger = pp.Pusher(velocity=(0.2, 1.0), shape="finger", radius=0.1)
    given = {"effects": effects, "contact": law, "outline": outline}
    many = pp.scene_at(points, **given)
    batch = pp.simulate_batch(many, finger, duration=0.6)
    for i, point in enumerate(points):
        one = pp.scene_at(tuple(point), **given)
        assert one.slider.radius == many.slider.radius
        log = pp.simulate(one, finger, duration=0.6, samples=2).isel(time=-1)
        for variable in ("position", "rod_angle", "slip", "force", "contact_position"):
            found = batch[variable][i].values
            if name in EXACT:
                assert np.array_equal(found, log[variable].values), variable
            else:
                assert found == pytest.approx(log[variable].values, rel=1e-9, abs=1e-8)
