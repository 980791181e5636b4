"""Colors: one a meaning, legible on white, in gray, and to a deuteranope."""

from itertools import combinations

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from planar_pushing.drawing.canvas import colors
from planar_pushing.drawing.canvas.colors import (
    CENTER,
    DARK,
    FORCE,
    GRAY,
    IMPACT,
    LEFT,
    MODE_SETS,
    MODES,
    MOTION,
    PUSHER,
    RIGHT,
    SEPARATE,
    SLIP,
    STICK,
    look_of,
    rod_color,
    support_colors,
    tint,
)
from planar_pushing.mechanics.contact import ContactMode

#: How a deuteranope sees linear red, green and blue (Machado, Oliveira and Fernandes 2009).
DEUTERANOPE = np.array(
    [
        (0.367322, 0.860646, -0.227968),
        (0.280085, 0.672501, 0.047413),
        (-0.011820, 0.042940, 0.968881),
    ]
)
#: To XYZ, and the white point.
XYZ = np.array([(0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505)])
LENGTHS = (0.0, 0.5, 1.0, 2.0, 3.0, 5.0, np.inf)
STUDIED = list(colors._SUPPORTS)
#: Colors of letters and marks.
INKS = (DARK, GRAY, FORCE, MOTION, PUSHER, SLIP, CENTER, IMPACT)


def linear(color):
    levels = np.array(to_rgb(color))
    return np.where(levels <= 0.04045, levels / 12.92, ((levels + 0.055) / 1.055) ** 2.4)


def luminance(color):
    return float(XYZ[1] @ linear(color))


def contrast(one, other="white"):
    """Of WCAG 2."""
    low, high = sorted([luminance(one) + 0.05, luminance(other) + 0.05])
    return high / low


def lightness(color):
    return lab(linear(color))[0]


def lab(rgb):
    """Place in CIELAB."""
    x, y, z = XYZ @ np.clip(rgb, 0, 1) / XYZ.sum(axis=1)
    x, y, z = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (x, y, z))
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def distance(one, other, seen=DEUTERANOPE):
    """Distance of two colors in CIELAB as a deuteranope sees them."""
    return float(np.hypot.reduce(lab(seen @ linear(one)) - lab(seen @ linear(other))))


@pytest.mark.parametrize("color", INKS)
def test_letters_and_marks_have_contrast_on_white(color):
    assert contrast(color) >= 4.5


@pytest.mark.parametrize(
    "color",
    [
        *(look.ink for look in MODE_SETS.values()), *colors.ENERGIES.values(),
        *support_colors(STUDIED).values(),
    ],
)  # fmt: skip
def test_lines_have_contrast_on_white(color):
    assert contrast(color) >= 3


@pytest.mark.parametrize("mode", MODES)
def test_names_of_modes_are_legible_on_their_fill(mode):
    assert contrast("white" if mode < 0 else DARK, MODES[mode].fill) >= 4.5


@pytest.mark.parametrize(("one", "other"), [*combinations(MODE_SETS, 2)])
def test_fills_of_modes_differ_in_gray_or_by_their_hatch(one, other):
    first, second = MODE_SETS[one], MODE_SETS[other]
    if first.hatch == second.hatch:
        assert abs(lightness(first.fill) - lightness(second.fill)) >= 5
    assert (first.fill, first.name) != (second.fill, second.name)


#: Pairs of one hue to a deuteranope, which are told apart by their shapes: an arrow, and a burst.
TOLD_APART = {(FORCE, IMPACT)}


@pytest.mark.parametrize(
    ("one", "other"), [*combinations([FORCE, MOTION, PUSHER, SLIP, CENTER, IMPACT], 2)]
)
def test_meanings_differ_for_a_deuteranope(one, other):
    assert distance(one, other) >= (10 if (one, other) in TOLD_APART else 20)


@pytest.mark.parametrize(("one", "other"), [*combinations((SEPARATE, STICK, LEFT, RIGHT), 2)])
def test_fills_of_single_modes_differ_for_a_deuteranope(one, other):
    assert distance(MODES[one].fill, MODES[other].fill) >= 10


@pytest.mark.parametrize(
    "names", [STUDIED, ["ring", "plate"], ["a", "disc", "b", "c"], [f"s{i}" for i in range(11)]]
)
def test_every_support_has_a_color_of_its_own(names):
    found = support_colors(names)
    assert list(found) == names
    assert len(set(found.values())) == len(names)
    assert {name: found[name] for name in names if name in STUDIED} == {
        name: color for name, color in support_colors(STUDIED).items() if name in names
    }


def test_longer_rods_are_lighter_and_none_is_pale():
    found = [lightness(rod_color(length)) for length in LENGTHS]
    assert (np.diff(found) > 0).all()
    assert min(contrast(rod_color(length)) for length in LENGTHS) >= 2.8


@pytest.mark.parametrize("code", range(16))
def test_any_set_of_modes_is_named(code):
    look = look_of(code)
    members = [MODES[mode].name for mode in ContactMode if code >> mode & 1] or ["no solution"]
    for name in members:
        assert name.removeprefix("slip ") in look.name
    assert look.name.count(" or ") == (len(members) > 1)
    assert contrast(look.ink) >= 3


def test_tints_are_opaque_mixtures_with_white():
    assert (tint("#336699", 1.0), tint("#336699", 0.0)) == ("#336699", "#ffffff")
    assert tint(GRAY, 0.5) == "#b6b6b6"
