"""Each declared parameter is refused in Python and in a file, in the words of its declaration."""

from __future__ import annotations

import math

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from mechanics.builders import PSI
from pydantic import TypeAdapter, ValidationError
from terms.test_domain import NOT_NUMBERS

import planar_pushing as pp
from planar_pushing.mechanics.contact import LAWS
from planar_pushing.mechanics.effects import EFFECTS
from planar_pushing.mechanics.supports import SHAPES
from planar_pushing.scenes.entries import entry_of
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.declared import declarations_of, positive

MAKERS = [
    pp.Slider, pp.Placement, pp.Units, pp.Until, pp.Pusher, Problem, pp.Polygon.rectangle,
    pp.Polygon.regular, *LAWS.values(), *EFFECTS.values(), *SHAPES.values(),
]  # fmt: skip
ROD = {"rod_length": 1.0, "rod_angle": PSI}
DISC, TRIANGLE = pp.Disc(1.0), [(0, 0), (1, 0), (0, 1)]
MAP = {"x": [0, 1], "y": [0, 1], "pressure": [[1]]}
AT = {"point": (0.0, 0.0), "normal": (0.0, 1.0)}
RUN = {"pusher": pp.Pusher(velocity=(0, 1)), "duration": 1.0, "scene": pp.Scene(
    slider=pp.Slider(**ROD), contact=pp.Coulomb(1.0), effects=(pp.RingFriction(),)
)}  # fmt: skip
NO_FRICTION = (
    "a finite number > 0; leave the effect out of the scene if the support is frictionless"
)
NO_INERTIA = "a finite number > 0; leave the effect out of the scene if the slider has no inertia"
PAIR = "two finite numbers; give x and y in the body frame"
ONE = "use Points for a support on one point"
#: Of each parameter of a class: the others, a wrong value, and what the message says is allowed.
WRONG = {
    (pp.Slider, "rod_length"): (
        ROD, -1.0, "a finite number >= 0; give the distance from the contact to the slider's center",
    ),
    (pp.Slider, "rod_angle"): (
        ROD, 0.0, "radians in the open interval (0, pi); keep the slider above the fence; convert degrees",
    ),
    (pp.Slider, "radius"): (ROD, 0.0, "a finite number > 0; give it in the unit of the rod length"),
    (pp.Slider, "side"): (ROD, (1, 2), "(start, end) with start <= 0 <= end, infinite for a side without"),
    (pp.Slider, "flush"): (ROD | {"side": (-1, 1)}, "yes", "True or False; give one of them"),
    (pp.Slider, "outline"): (ROD, [(0, 0), (1, 1)], "at least three vertices; give x and y of each"),
    (pp.Placement, "point"): (AT, "here", "two finite numbers; give x and y in the object's frame"),
    (pp.Placement, "normal"): (AT, (1.0, "up"), "; give x and y in the object's frame"),
    (pp.Units, "length"): ({}, " ", "the name of a unit; give it as text, such as m"),
    (pp.Units, "force"): ({}, 3, "the name of a unit; give it as text, such as m"),
    (pp.Units, "time"): ({}, "s\n", "the name of a unit; give it as text, such as m"),
    (pp.Until, "rotation"): ({}, 13.0, "radians in (0, 4 pi]; convert degrees with np.deg2rad"),
    (pp.Until, "distance"): ({}, 0.0, "a finite number > 0; give a positive number, or leave it out"),
    (pp.Until, "pusher_distance"): ({}, math.inf, "a finite number > 0; give a positive number"),
    (pp.Pusher, "radius"): (
        {"velocity": (0, 1), "shape": "finger"}, -1.0, "a finite number >= 0; give the radius of the",
    ),
    (Problem, "duration"): (RUN, 0.0, "a finite number > 0; give the time to simulate"),
    (Problem, "gap"): (RUN, -1.0, "a finite number >= 0; start on the fence or above it"),
    (Problem, "rtol"): (RUN, 1.0, "a number in [1e-13, 1e-2]; choose a tolerance that double precision"),
    (pp.Coulomb, "friction_coefficient"): (
        {}, 1.001e9, "a number in [0, 1e+09]; use the law of infinite friction where no coefficient is",
    ),
    (pp.InfiniteFriction, "at_zero_normal"): (
        {}, "both", '"free" or "none"; choose "free" for definition 1 and "none" for definition 2',
    ),
    (pp.RingFriction, "weight"): ({}, 0.0, NO_FRICTION),
    (pp.SupportFriction, "weight"): ({"support": DISC}, math.nan, NO_FRICTION),
    (pp.SupportFriction, "support"): ({}, "disc", "a support, such as Disc or Polygon; construct one"),
    (pp.Inertia, "mass"): ({}, 0.0, NO_INERTIA),
    (pp.Inertia, "gyration_radius"): ({}, -1.0, NO_INERTIA),
    (pp.Inertia, "center"): ({}, (1.0,), "two finite numbers; give x and y of the center of mass in the"),
    (pp.Viscous, "coefficient"): (
        {"support": DISC}, 0.0, "a finite number > 0; leave the effect out of the scene if nothing",
    ),
    (pp.Viscous, "support"): ({}, None, "a support, such as Disc or Polygon; construct one"),
    (pp.Load, "force"): ({}, 3.0, "two finite numbers; give its components along x and y"),
    (pp.Load, "center"): ({"force": (0, 1)}, (math.inf, 0.0), "; give x and y in the body frame"),
    (pp.Ring, "radius"): ({}, 0.0, f"a finite number > 0; {ONE}"),
    (pp.Ring, "center"): ({"radius": 1}, 3.0, PAIR),
    (pp.Disc, "radius"): ({}, -1.0, f"a finite number > 0; {ONE}"),
    (pp.Disc, "center"): ({"radius": 1}, (1.0,), PAIR),
    (pp.Annulus, "inner"): ({"outer": 1}, 0.0, "a finite number > 0; use Disc for a support without"),
    (pp.Annulus, "outer"): ({"inner": 1}, math.inf, "a finite number > 0; give the outer radius"),
    (pp.Annulus, "center"): ({"inner": 1, "outer": 2}, (0, math.nan), "finite numbers; give each number"),
    (pp.Segment, "start"): ({"end": (1, 0)}, "0", PAIR),
    (pp.Segment, "end"): ({"start": (1, 0)}, (0, 1e200), "at most 1e+140; choose another unit of length"),
    (pp.Points, "positions"): ({}, [], "at least one point; give x and y of each in the body frame"),
    (pp.Points, "weights"): ({"positions": TRIANGLE}, [1, 0, 1], "a number > 0; leave out what carries no"),
    (pp.Points, "names"): ({"positions": TRIANGLE}, ["a", "a", "b"], "distinct names; give each point its"),
    (pp.Polygon, "vertices"): ({}, [(0, 0), (1, True)], "two finite numbers; give x and y of each vertex"),
    (pp.Polygon, "holes"): ({"vertices": TRIANGLE}, 5, "a sequence of rings; give the vertices"),
    (pp.PressureMap, "x"): (MAP, [0, 0], "at least two increasing numbers; give the edges of the cells in"),
    (pp.PressureMap, "y"): (MAP, [0, math.nan], "finite numbers; give each number"),
    (pp.PressureMap, "pressure"): (MAP, [[-1]], "a number >= 0; a support cannot pull; clip noise"),
    (pp.PressureMap, "origin"): (MAP, 0, PAIR),
    (pp.PressureMap, "axis"): (MAP, (2.0, 0.0), "a unit vector; divide it by its length"),
    (pp.Composite, "members"): ({}, [], "at least one pair of a share and a support; give for instance"),
    (pp.Polygon.rectangle, "width"): ({"height": 1}, 0.0, "a finite number > 0; give the length"),
    (pp.Polygon.rectangle, "height"): ({"width": 1}, -1.0, "a finite number > 0; give the length"),
    (pp.Polygon.rectangle, "center"): ({"width": 1, "height": 1}, 1, PAIR),
    (pp.Polygon.rectangle, "angle"): ({"width": 1, "height": 1}, 90.0, "radians in [-4 pi, 4 pi]; convert"),
    (pp.Polygon.regular, "count"): ({"radius": 1}, 2, "a whole number >= 3; give more of them"),
    (pp.Polygon.regular, "radius"): ({"count": 3}, 0.0, "a finite number > 0; give the radius"),
    (pp.Polygon.regular, "center"): ({"count": 3, "radius": 1}, 1, PAIR),
    (pp.Polygon.regular, "angle"): ({"count": 3, "radius": 1}, math.inf, "radians in [-4 pi, 4 pi];"),
}  # fmt: skip
IDS = [f"{maker.__qualname__}.{name}" for maker, name in WRONG]


def test_every_parameter_has_a_row():
    assert set(WRONG) == {(maker, name) for maker in MAKERS for name in declarations_of(maker)}


@pytest.mark.parametrize("row", WRONG, ids=IDS)
def test_a_wrong_value_is_refused_in_python(row):
    (maker, name), (others, wrong, words) = row, WRONG[row]
    with pytest.raises(pp.InvalidValue) as caught:
        maker(**others | {name: wrong})
    said = str(caught.value)
    assert said.startswith(name)
    assert f" given; allowed: {words}" in said.replace("allowed: a finite number;", "allowed: ;")
    assert "\n" not in said


@pytest.mark.parametrize("row", WRONG, ids=IDS)
def test_and_in_a_file(row):
    (maker, name), (others, wrong, _) = row, WRONG[row]
    if maker in (Problem, pp.Pusher):  # their section of a file is `simulate`
        return
    declaration, degrees = (
        declarations_of(maker)[name][0],
        {"rod_angle": 180, "rotation": 721, "angle": "up"},
    )
    forms = {"rod_angle": 45.0, "support": {"shape": "disc", "radius": 1}}
    content = {key: forms.get(key, each) for key, each in others.items()}
    with pytest.raises(ValidationError) as caught:
        TypeAdapter(entry_of(maker)).validate_python(content | {name: degrees.get(name, wrong)})
    (error,) = caught.value.errors()
    assert error["loc"][0] == name
    if error["type"] == "refused" and name in degrees:
        assert error["ctx"]["allowed"] == declaration.degrees.allowed


@pytest.mark.parametrize("given", [*NOT_NUMBERS, -1.0, np.inf, -np.inf], ids=repr)
def test_what_is_not_in_a_range(given):
    with pytest.raises(pp.InvalidValue) as caught:
        positive("choose another").require("size", given)
    error = caught.value
    assert (error.name, error.allowed, error.remedy) == (
        "size",
        "a finite number > 0",
        "choose another",
    )
    assert error.given is given or error.given == given
    assert str(error) == f"size: {given!r} given; allowed: a finite number > 0; choose another"


@pytest.mark.parametrize(
    "given",
    [2, 2.0, np.int8(2), np.float32(2), [1, 2], (1, 2.0), np.array([1, 2], "u1"), pd.Series([1, 2]),
     xr.DataArray([1, 2], dims="case")], ids=repr,
)  # fmt: skip
def test_what_is_in_a_range_becomes_double(given):
    found = positive("").require("size", given)
    assert np.asarray(found).dtype == np.float64
    assert np.array_equal(found, given)
    assert hasattr(found, "dims") is hasattr(given, "dims")


def test_a_number_in_a_file_is_single_and_plain():
    assert positive("").read(2) == 2.0
    for given in ("inf", True, "2", [1], 10**400, None, {}):
        with pytest.raises(pp.InvalidValue) as caught:
            positive("").read(given)
        assert caught.value.given == given


@pytest.mark.parametrize("degrees", [30.0, 12.5, 0.1, 179.0, 45.000000000000014])
def test_degrees_of_a_file_come_back(degrees):
    angle = declarations_of(pp.Slider)["rod_angle"][0]
    assert angle.to_file(angle.from_file(degrees)) == degrees
    assert angle.from_file(degrees) == np.deg2rad(degrees)
