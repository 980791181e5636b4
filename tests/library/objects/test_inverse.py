"""The pushes that give a twist: each is solved forward again, and none is missing."""

import numpy as np
import pytest
from objects.brute import contacts, loads
from objects.pushed import SQUARE, error, star, support

import planar_pushing as pp

BOX = (pp.SupportFriction(support=pp.Polygon(SQUARE)),)
TABLE = (pp.SupportFriction(support=pp.Points(SQUARE, [1, 1, 1, 1])),)
KINDS = ("points", "polygon", "disc", "composite")
#: Effects beside friction.
MORE = ("friction", "viscous", "inertia", "load")
#: Friction coefficients above this need a pusher that is exact to more than a solver's scale.
STEEP = 300.0


def about(place, omega=1.0):
    """The twist of a rotation about a place."""
    return omega * np.array([place[1], -place[0], 1.0])


def seen(pushes):
    """Contact, normal and coefficient of pushes, in order of the contact."""
    rows = [[*push.point, *push.normal, push.friction_coefficient] for push in pushes]
    return np.array(sorted(np.round(rows, 9).tolist())) + 0.0


def test_the_published_square():
    (push,) = pp.pushes_for(BOX, (1.5, -0.5, 1.0), SQUARE)
    assert push.point == pytest.approx((-1.0, 0.06381924), abs=1e-8)
    assert push.normal.tolist() == [1.0, 0.0]
    assert push.force == pytest.approx((0.88059012, -0.28398883), abs=1e-8)
    assert push.velocity == pytest.approx((1.43618076, -1.5), abs=1e-8)
    assert push.friction_coefficient == pytest.approx(0.322498319, abs=1e-9)
    assert push.ends == ()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("more", MORE)
def test_solve_gives_the_twist_back(kind, more):
    rng = np.random.default_rng(KINDS.index(kind))
    solved = 0
    for _ in range(12):
        at = rng.normal(size=2)
        effects = (pp.SupportFriction(support=support(rng, kind, at), weight=2.3), *other(more, at))
        twist = rng.normal(size=3)
        pushes = pp.pushes_for(effects, twist, star(rng, 7, 1.5, at))
        for push in pushes:
            if push.friction_coefficient < STEEP:
                assert error(push, effects, twist) < 1e-11
                solved += 1
    assert solved > 5


def other(name, at):
    """Effects beside friction."""
    return {
        "friction": (),
        "viscous": (pp.Viscous(support=pp.Disc(0.5, tuple(at)), coefficient=0.4),),
        "inertia": (pp.Inertia(mass=0.7, gyration_radius=0.5, center=(at[0] + 0.2, at[1])),),
        "load": (pp.Load(force=(0.1, -0.2), center=(at[0] + 0.1, at[1])),),
    }[name]


@pytest.mark.parametrize("kind", ["points", "composite"])
@pytest.mark.parametrize("more", MORE)
def test_solve_gives_a_rotation_about_a_foot_back(kind, more):
    """From the contact of least friction, and from both ends of its interval."""
    rng = np.random.default_rng(10 + KINDS.index(kind))
    solved = 0
    for _ in range(8):
        at = rng.normal(size=2)
        pressed = support(rng, kind, at)
        effects = (pp.SupportFriction(support=pressed, weight=2.3), *other(more, at))
        twist = about(pressed.pieces().atoms[1], rng.choice([-1, 1]) * rng.uniform(0.3, 3))
        for push in pp.pushes_for(effects, twist, star(rng, 7, 1.5, at)):
            for each in (push, *push.ends):
                if each.friction_coefficient < STEEP:
                    assert error(each, effects, twist) < 1e-11
                    solved += bool(push.ends)
    assert solved > 20


def test_inertia_alone():
    rng = np.random.default_rng(20)
    for _ in range(10):
        effects = (
            pp.Inertia(mass=3.0, gyration_radius=0.4, center=tuple(0.3 * rng.normal(size=2))),
        )
        twist, outline = rng.normal(size=3), star(rng, 6)
        pushes = pp.pushes_for(effects, twist, outline)
        for push in pushes:
            assert error(push, effects, twist) < 1e-11 or push.friction_coefficient > STEEP


@pytest.mark.parametrize("seed", range(8))
def test_trials_find_no_other_contact_and_no_smaller_friction(seed):
    rng = np.random.default_rng(seed)
    places = pp.Points(rng.normal(size=(4, 2)), rng.uniform(0.2, 1, 4))
    foot = np.array(places.positions[0])
    outline = star(rng, 6, 1.5, 0.3 * rng.normal(size=2))
    if seed in (1, 2):  # the foot on a corner, and on a side
        outline = outline - (outline[2] + outline[2 + (seed == 2)]) / 2 + foot
    effects = (pp.SupportFriction(support=places),)
    require_all_found(rng, effects, about(foot, rng.choice([-1.0, 1.0])), outline)


@pytest.mark.parametrize("outline", [SQUARE, 1.5 * np.array(SQUARE), [(-1, -2), (3, -2), (1, 1)]])
@pytest.mark.parametrize("foot", range(4))
@pytest.mark.parametrize("omega", [-1.0, 1.0])
def test_trials_agree_about_the_feet_of_a_table(outline, foot, omega):
    rng = np.random.default_rng(9)
    require_all_found(rng, TABLE, about(SQUARE[foot], omega), outline)


def test_trials_agree_where_a_load_leaves_no_torque_about_the_foot():
    """All lines of force then pass through the origin of forces: each contact has one coefficient."""
    rng, twist = np.random.default_rng(11), about((1, 1))
    rest = pp.wrench_set(TABLE, twist).offset
    moment = rest[2] - (rest[1] - rest[0])
    pull = pp.Load(force=(4 * moment, 0.0), center=(1.0, 0.75))
    effects = (*TABLE, pp.Inertia(mass=1e-9), pull)
    require_all_found(rng, effects, twist, 1.5 * np.array(SQUARE))


def require_all_found(rng, effects, twist, outline):
    pushes = pp.pushes_for(effects, twist, outline)
    tried = loads(rng, pp.wrench_set(effects, twist))
    hit = dict.fromkeys(range(len(pushes)), False)
    for normal, points, friction in contacts(outline, tried):
        along, found = np.array([normal[1], -normal[0]]), np.zeros(len(points), dtype=bool)
        for i, push in enumerate(pushes):
            low, high = sorted(each.point @ along for each in push.ends or (push, push))
            place = points @ along
            inside = (place >= low - 1e-7) & (place <= high + 1e-7)
            inside &= np.abs((points - push.point) @ normal) < 1e-9
            inside &= bool(push.normal @ normal > 1 - 1e-9)
            assert (friction[inside] >= push.friction_coefficient * (1 - 1e-9) - 1e-9).all()
            if inside.sum() > 100:
                least = friction[inside].min()
                assert least <= 1.1 * push.friction_coefficient + 0.05
                span = 0.15 * (high - low)
                assert place[inside].min() <= low + span
                assert place[inside].max() >= high - span
            hit[i] |= inside.any() or push.friction_coefficient > 20
            found |= inside
        assert found.all()
    assert all(hit.values())


def test_a_translation_pushes_towards_the_center_of_pressure():
    (push,) = pp.pushes_for(BOX, (0.0, 2.0, 0.0), SQUARE)
    assert push.point.tolist() == [0.0, -1.0]
    assert (push.friction_coefficient, push.velocity.tolist()) == (0.0, [0.0, 2.0])


def test_a_corner_is_a_contact_of_both_sides():
    found = pp.pushes_for(BOX, (1.0, 1.0, 0.0), SQUARE)
    right = [[-1, -1, 0, 1, 1], [-1, -1, 1, 0, 1]]
    assert seen(found) == pytest.approx(np.array(right))
    found = pp.pushes_for(BOX, (2.0, 1.0, 0.0), [(-1, -0.5), (1, -1), (1, 1), (-1, 1)])
    assert [push.point == pytest.approx((-1, -0.5)) for push in found] == [True, True]
    assert sorted(push.friction_coefficient for push in found)[0] == pytest.approx(0.5)


@pytest.mark.parametrize("seed", range(5))
def test_a_corner_of_any_polygon_is_neither_lost_nor_doubled(seed):
    """The outline is moved until a corner is on the line of action."""
    rng = np.random.default_rng(seed)
    twist, outline = rng.normal(size=3), star(rng, 7, 1.5)
    for push in pp.pushes_for(BOX, twist, outline):
        corner = outline[np.argmin(np.linalg.norm(outline - push.point, axis=1))]
        shifted = outline + (push.point - corner)
        there = [
            each for each in pp.pushes_for(BOX, twist, shifted)
            if np.linalg.norm(each.point - push.point) < 1e-6
        ]  # fmt: skip
        after = np.roll(outline, -1, axis=0) - outline
        turns = np.sign(
            np.cross(np.pad(outline, ((0, 0), (0, 1))), np.pad(after, ((0, 0), (0, 1))))[:, 2].sum()
        )
        i = np.flatnonzero((outline == corner).all(axis=1))[0]
        normals = [turns * np.array([-y, x]) / np.hypot(x, y) for x, y in after[[i - 1, i]]]
        pushed = [normal for normal in normals if normal @ push.force > 0]
        assert len(there) == len(pushed)
        assert {tuple(np.round(each.normal, 9)) for each in there} == {
            tuple(np.round(each, 9)) for each in pushed
        }


def test_a_flush_line_of_action_is_no_contact():
    outline = [(-1, 0), (1, 0), (1, 1), (-1, 1)]
    effects = (pp.SupportFriction(support=pp.Disc(1.0)),)
    (push,) = pp.pushes_for(effects, (1.0, 0.0, 0.0), outline)
    assert push.point.tolist() == [-1.0, 0.0]
    assert push.normal.tolist() == [1.0, 0.0]
    (push,) = pp.pushes_for(effects, (1.0, 1e-15, 0.0), outline)
    assert push.normal.tolist() == [1.0, 0.0]


def test_a_spin_about_the_center_has_no_line_of_action():
    assert pp.pushes_for(BOX, (0.0, 0.0, 1.0), SQUARE) == ()
    assert pp.pushes_for((pp.Inertia(),), (0.0, 0.0, 1.0), SQUARE) == ()


def test_an_outline_may_turn_either_way_and_hold_corners_on_straight_sides():
    twist = (1.0, 0.3, 0.4)
    right = pp.pushes_for(BOX, twist, SQUARE)
    assert pp.pushes_for(BOX, twist, pp.Polygon(SQUARE)) == right
    assert np.allclose(seen(pp.pushes_for(BOX, twist, SQUARE[::-1])), seen(right))
    (push,) = pp.pushes_for(BOX, (0, 1, 0), [(-1, -1), (0, -1), (1, -1), (1, 1), (-1, 1)])
    assert push.point.tolist() == [0.0, -1.0]
    wide = 1.5 * np.array(SQUARE)
    split = np.insert(wide, [1, 2, 3, 4], (wide + np.roll(wide, -1, axis=0)) / 2, axis=0)
    for foot in SQUARE:
        assert np.allclose(
            seen(pp.pushes_for(TABLE, about(foot), split)),
            seen(pp.pushes_for(TABLE, about(foot), wide)),
        )


def test_a_hook_is_pushed_from_inside():
    """Its center of pressure is on the pusher's side of the contact."""
    hook = [(-2, -1), (2, -1), (2, 1), (1.5, 1), (1.5, -0.5), (-2, -0.5)]
    effects = (pp.SupportFriction(support=pp.Polygon(hook)),)
    (push,) = pp.pushes_for(effects, (1.0, 0.0, 0.0), hook)
    assert push.point == pytest.approx((1.5, -1.3125 / 2.75))
    assert push.normal.tolist() == [1.0, 0.0]
    assert error(push, effects, np.array([1.0, 0.0, 0.0])) < 1e-11


@pytest.mark.parametrize("twist", [(0.9, -1.0, 0.3), about((1, -1), -2.0)])
def test_it_turns_and_grows_with_the_object(twist):
    """In another frame, in other units, at another speed, with another weight."""
    c, s = np.cos(0.7), np.sin(0.7)
    turn, shift, size = np.array([[c, -s], [s, c]]), np.array([3.0, -2.0]), 0.01
    outline = 1.2 * np.array(SQUARE)
    one = pp.pushes_for(TABLE, twist, outline)
    places = size * np.array(SQUARE) @ turn.T + shift
    effects = (pp.SupportFriction(support=pp.Points(places, [1, 1, 1, 1]), weight=7.0),)
    velocity = size * turn @ np.array(twist[:2])
    moved = 5 * np.array([*(velocity + twist[2] * np.array([shift[1], -shift[0]])), twist[2]])
    other = pp.pushes_for(effects, moved, size * outline @ turn.T + shift)
    assert len(one) == len(other) > 0
    for push, image in zip(one, other, strict=True):
        pairs = zip((push, *push.ends), (image, *image.ends), strict=True)
        for each, there in pairs:
            assert there.friction_coefficient == pytest.approx(each.friction_coefficient, rel=1e-9)
            assert there.point == pytest.approx(size * turn @ each.point + shift, abs=1e-11)
            assert there.normal == pytest.approx(turn @ each.normal)
            assert there.force == pytest.approx(7 * turn @ each.force)
            assert there.velocity == pytest.approx(5 * size * turn @ each.velocity)


def test_it_prints_itself_in_a_line():
    (push,) = pp.pushes_for(BOX, (0.0, 2.0, 0.0), SQUARE)
    assert repr(push) == (
        "Push(point=(0, -1), normal=(0, 1), force=(0, 1), velocity=(0, 2), friction_coefficient=0)"
    )
    found = pp.pushes_for(TABLE, about((1, 1)), 1.5 * np.array(SQUARE))
    assert all(", ends at (" in repr(each) for each in found if each.ends)
    assert found == pp.pushes_for(TABLE, about((1, 1)), 1.5 * np.array(SQUARE))
    assert found != pp.pushes_for(TABLE, about((1, 1), 2.0), 1.5 * np.array(SQUARE))


@pytest.mark.parametrize(
    ("outline", "said"),
    [
        ([(0, 0), (1, 1), (1, 0), (0, 1)], "a simple polygon"),
        ("abc", "pairs of finite numbers"),
    ],
)
def test_an_outline_is_a_simple_polygon(outline, said):
    with pytest.raises(pp.InvalidValue, match=said) as caught:
        pp.pushes_for(BOX, (0, 1, 0), outline)
    assert caught.value.name.startswith("outline")


@pytest.mark.parametrize("twist", [(0, 0, 0), (1, 2)])
def test_a_twist_is_three_finite_numbers(twist):
    with pytest.raises(pp.InvalidValue, match="three finite numbers, not all zero"):
        pp.pushes_for(BOX, twist, SQUARE)


def test_rings_of_a_slider_have_no_place():
    with pytest.raises(pp.InvalidValue, match="give SupportFriction"):
        pp.pushes_for((pp.RingFriction(),), (0, 1, 0), SQUARE)
    (push,) = pp.pushes_for((pp.SupportFriction(support=pp.Ring(0.5)),), (0, 1, 0), SQUARE)
    assert push.point.tolist() == [0.0, -1.0]


@pytest.mark.parametrize("center", [None, (0.0, 0.0)])
def test_a_load_that_friction_cannot_hold_is_refused(center):
    load = pp.Load(force=(0.6, -0.8), center=center)
    weak = pp.SupportFriction(support=pp.Ring(1.0), weight=0.5)
    with pytest.raises(pp.InvalidValue, match="2 times what friction can hold"):
        pp.pushes_for((weak, load), (0, 1, 0), SQUARE)
    assert pp.pushes_for((weak, load, pp.Inertia()), (0, 1, 0), SQUARE)


#: Outlines with an arc of the unit circle about the origin, and whether it is hollow.
ROUND = {
    "disc": (pp.Outline(pp.Disc(1.0)), False),
    "half disc": (pp.Outline.from_bulges([(0, -1, 1), (0, 1, 0)]), False),
    "hole": (pp.Outline(2.0 * np.array(SQUARE), holes=[pp.Disc(1.0)]), True),
    "notch": (pp.Outline.from_bulges([(1, 0, 0), (2, 0, 0), (2, 3, 0), (-2, 3, 0), (-2, 0, 0),
                                      (-1, 0, -1)]), True),
}  # fmt: skip
FEET = np.array([[0.3, 0.5], [-0.6, 0.1], [0.2, -0.8], [0.9, 0.7], [0.0, 1.0], [0.0, 0.0]])


def on_circle(name, points):
    """Which points of the unit circle are on the arc."""
    x, y = np.moveaxis(points, -1, 0)
    return {"half disc": x >= 0, "notch": y >= 0}.get(name, np.ones(len(x), dtype=bool))


@pytest.mark.parametrize("name", ROUND)
@pytest.mark.parametrize("twist", [(0, 2, 0), (1, 0.5, -0.3), (-1, 0.2, 0.8), (0.3, -1, 2)])
def test_a_line_of_action_meets_an_arc_at_one_contact(name, twist):
    outline, hollow = ROUND[name]
    effects = (pp.SupportFriction(support=pp.Disc(0.7, (0.1, -0.05))),)
    *force, torque = pp.wrench_set(effects, twist).offset
    size = np.hypot(*force)
    way, across = np.array(force) / size, np.array([force[1], -force[0]]) / size
    # The line enters the disc at one place; it leaves the hole at the other.
    root = np.sqrt(1.0 - (torque / size) ** 2)
    place = torque / size * across + (root if hollow else -root) * way
    pushes = [
        push for push in pp.pushes_for(effects, twist, outline)
        if abs(push.normal @ push.point) == pytest.approx(1.0, abs=1e-9)
        and np.hypot(*push.point) == pytest.approx(1.0, abs=1e-12)
    ]  # fmt: skip
    assert len(pushes) == int(on_circle(name, place[None])[0])
    for push in pushes:
        assert push.point == pytest.approx(place, abs=1e-12)
        assert push.normal == pytest.approx(place if hollow else -place, abs=1e-12)
        assert push.friction_coefficient == pytest.approx(abs(torque / size) / root, abs=1e-12)


@pytest.mark.parametrize("name", ROUND)
@pytest.mark.parametrize("foot", range(len(FEET)))
@pytest.mark.parametrize("omega", [-1.0, 1.0])
def test_trials_agree_about_feet_and_arcs(name, foot, omega):
    outline, hollow = ROUND[name]
    effects = (pp.SupportFriction(support=pp.Points(FEET, np.arange(1.0, 7.0))),)
    twist = about(FEET[foot], omega)
    rows = loads(np.random.default_rng(foot), pp.wrench_set(effects, twist))
    size = np.hypot(rows[:, 0], rows[:, 1])
    rows, size = rows[size > 1e-9], size[size > 1e-9]
    way, distance = rows[:, :2] / size[:, None], rows[:, 2] / size
    across = np.stack([way[:, 1], -way[:, 0]], axis=-1)
    meets = np.abs(distance) < 0.9999
    root = np.sqrt(1.0 - distance[meets] ** 2)
    places = distance[meets, None] * across[meets]
    places += (root if hollow else -root)[:, None] * way[meets]
    friction = np.abs(distance[meets]) / root
    keep = on_circle(name, places)
    angles, friction = np.arctan2(places[keep, 1], places[keep, 0]), friction[keep]
    hit = np.zeros(len(angles), dtype=bool)
    for push in pp.pushes_for(effects, twist, outline):
        if (
            abs(abs(push.normal @ push.point) - 1.0) > 1e-9
            or abs(np.hypot(*push.point) - 1.0) > 1e-9
        ):
            continue
        first, last = (np.arctan2(*end.point[::-1]) for end in (push.ends or (push, push)))
        low, span = (last, first - last) if hollow else (first, last - first)
        span %= 2.0 * np.pi
        inside = (angles - low + 1e-7) % (2.0 * np.pi) <= span + 2e-7
        inside |= np.full(len(angles), len(push.ends) > 0 and span < 1e-12)
        assert (friction[inside] >= push.friction_coefficient * (1 - 1e-9) - 1e-9).all()
        if inside.sum() > 100 and span > 1e-9:
            assert friction[inside].min() <= 1.1 * push.friction_coefficient + 0.05
            turn = (angles[inside] - low) % (2.0 * np.pi)
            assert turn.min() <= 0.15 * span
            assert turn.max() >= 0.85 * span
        assert inside.any() or push.friction_coefficient > 20
        hit |= inside
    assert hit.all()


@pytest.mark.parametrize("kind", KINDS)
def test_solve_gives_the_twist_back_from_arcs(kind):
    rng = np.random.default_rng(KINDS.index(kind))
    solved = 0
    for outline in (*(outline for outline, _ in ROUND.values()), pp.Outline.ellipse(1.2, 0.7, 16)):
        effects = (pp.SupportFriction(support=support(rng, kind), weight=2.3),)
        center = rng.normal(size=2)
        if kind == "points":
            center = effects[0].support.positions[0]
        for twist in (about(center), rng.normal(size=3)):
            for push in pp.pushes_for(effects, twist, outline):
                if push.friction_coefficient < STEEP:
                    assert error(push, effects, twist) < 1e-9
                    solved += 1
    assert solved > 5


def test_a_contact_where_a_side_joins_an_arc_is_one():
    box = pp.rounded(SQUARE, 0.3)
    for place in (0.7, -0.7, 0.7 + 1e-12, -0.7 - 1e-12):
        effects = (pp.SupportFriction(support=pp.Points([(place, 0.5), (place, -0.5)])),)
        (push,) = pp.pushes_for(effects, (0, 1, 0), box)
        assert push.point == pytest.approx((place, -1.0), abs=1e-11)
        assert push.friction_coefficient == pytest.approx(0.0, abs=1e-11)
