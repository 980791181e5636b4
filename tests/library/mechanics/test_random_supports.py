"""Statements about every slider on random supports with random contacts, the same in every run."""

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.mechanics.force.centers import motion_centers
from planar_pushing.mechanics.force.cones import can_pull, motion_cone, slips_while_pushing
from planar_pushing.mechanics.plane import direction
from planar_pushing.mechanics.pressure.table import extents_of
from planar_pushing.mechanics.solve import solve

SEED, SUPPORTS, CONTACTS = 1995, 1000, 10
#: Rounding of an angle, radians, and of a length, relative.
ROUNDING = 1e-9


def points(random):
    count = int(random.integers(2, 7))
    return pp.Points(random.uniform(-1, 1, (count, 2)), random.uniform(0.05, 1, count))


def segment(random):
    return pp.Segment(random.uniform(-1, 1, 2), random.uniform(-1, 1, 2))


def polygon(random):
    """Vertices around a point at random distances: simple, and rarely convex."""
    count = int(random.integers(3, 8))
    corners = direction(2 * np.pi * np.arange(count) / count)
    return pp.Polygon(random.uniform(-1, 1, 2) + corners * random.uniform(0.2, 1, (count, 1)))


def disc(random):
    return pp.Disc(random.uniform(0.1, 1), random.uniform(-1, 1, 2))


def mixture(random):
    return pp.Composite(
        [(random.uniform(0.1, 1), make(random)) for make in (points, segment, disc)]
    )


KINDS = [points] * 5 + [segment] * 2 + [polygon] + [mixture] * 2


class Sliders:
    """Random supports, each with random contacts, under infinite friction; shape (supports, contacts)."""

    def __init__(self, count=SUPPORTS, contacts=CONTACTS):
        random, shape = np.random.default_rng(SEED), (count, contacts)
        self.supports = np.empty((count, 1), dtype=object)
        self.supports[:, 0] = [KINDS[i % len(KINDS)](random) for i in range(count)]
        self.extent = extents_of(self.supports[:, 0])[:, None]
        lengths = self.extent * 10 ** random.uniform(-1, 1, shape)
        angles = random.uniform(0.05, np.pi - 0.05, shape)
        self.scenes = pp.Scene(
            slider=pp.Slider(rod_length=lengths, rod_angle=angles),
            contact=pp.InfiniteFriction(),
            effects=(pp.SupportFriction(support=self.supports),),
        )
        self.pusher = random.uniform(0.01, np.pi - 0.01, shape)
        self.force = random.uniform(-np.pi, np.pi, shape)


def has_one_solution(scenes, pusher, modes):
    found = solve(scenes, pusher)
    return (found.solutions == 1) & (found.mode[..., 0] == modes)


def normal_push_sticks(sliders):
    return has_one_solution(sliders.scenes, np.pi / 2, pp.ContactMode.STICK)


def push_sticks_inside_the_cone_and_slips_outside(sliders):
    cone = motion_cone(sliders.scenes)
    right = sliders.pusher < cone.right
    slip = np.where(right, pp.ContactMode.SLIP_LEFT, pp.ContactMode.SLIP_RIGHT)
    modes = np.where(cone.contains(sliders.pusher), pp.ContactMode.STICK, slip)
    return has_one_solution(sliders.scenes, sliders.pusher, modes)


def cone_spans_180_degrees(sliders):
    cone = motion_cone(sliders.scenes)
    return (np.abs(cone.span - np.pi) < ROUNDING) & cone.contains(np.pi / 2)


def pulls_where_it_slips(sliders):
    return can_pull(sliders.scenes) == slips_while_pushing(sliders.scenes)


def pull_has_three_solutions(sliders):
    """A retreat midway between the edge of the cone and the fence; a cone along the fence has none."""
    cone = motion_cone(sliders.scenes)
    below, beyond = cone.right < -ROUNDING, cone.left > np.pi + ROUNDING
    found = solve(sliders.scenes, np.where(below, cone.right, cone.left + np.pi) / 2)
    slip = np.where(below, pp.ContactMode.SLIP_LEFT, pp.ContactMode.SLIP_RIGHT)[..., None]
    modes = (pp.ContactMode.SEPARATE, pp.ContactMode.STICK, slip)
    has = np.all([(found.mode == mode).any(axis=-1) for mode in modes], axis=0)
    return ~(below | beyond) | (has & (found.solutions == 3))


def center_lies_within_the_bound(sliders):
    """Within a^2 / d of the center of pressure if the line of force is at d <= a from it, else within a."""
    slider, size = sliders.scenes.slider, sliders.extent
    places = np.array([[each.center_of_pressure] for each in sliders.supports[:, 0]])
    x, y = direction(slider.rod_angle), direction(slider.rod_angle + np.pi / 2)
    middle = places[..., :1] * x + places[..., 1:] * y
    arm, along = middle + slider.rod_length[..., None] * x, direction(sliders.force)
    offset = np.abs(arm[..., 0] * along[..., 1] - arm[..., 1] * along[..., 0])
    found = motion_centers(sliders.scenes, sliders.force, origin="slider-center")
    apart = np.linalg.norm(found - middle, axis=-1)
    return apart <= np.maximum(size**2 / offset, size) * (1 + ROUNDING)


INVARIANTS = (
    normal_push_sticks, push_sticks_inside_the_cone_and_slips_outside, cone_spans_180_degrees,
    pulls_where_it_slips, pull_has_three_solutions, center_lies_within_the_bound,
)  # fmt: skip
SLIDERS = Sliders()


@pytest.mark.parametrize("invariant", INVARIANTS)
def test_it_holds(invariant):
    holds = invariant(SLIDERS)
    assert holds.shape == (SUPPORTS, CONTACTS)
    assert holds.all(), np.argwhere(~holds)


@pytest.mark.slow
def test_a_hundred_thousand_normal_pushes_stick():
    assert normal_push_sticks(Sliders(50_000, 2)).all()


def test_every_kind_is_drawn_and_other_pushes_slip():
    assert {type(each) for each in SLIDERS.supports.ravel()} == {
        pp.Points, pp.Segment, pp.Polygon, pp.Composite,
    }  # fmt: skip
    slips = pp.solve(SLIDERS.scenes, np.deg2rad(179.0)).mode[..., 0] != pp.ContactMode.STICK
    assert 0.1 < slips.mean() < 0.9
