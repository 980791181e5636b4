"""Sliders for the tests of the oracle."""

from flint import fmpq
from oracle.cases import SUPPORTS

from pulling_by_pushing.oracle.balls import rational
from pulling_by_pushing.oracle.body import Body
from pulling_by_pushing.oracle.prove import Slider
from pulling_by_pushing.oracle.shapes import support

PIECES = {name: support(entry) for name, entry in SUPPORTS.items()}
FRICTION, INERTIA, BOTH = EFFECTS = ("friction", "inertia", "both")


def slider(length, rod_angle=45, effects=FRICTION, name="ring", gyration_radius=1.0, **more):
    """A slider of unit weight and mass."""
    parts = {"gyration": rational(gyration_radius) ** 2}
    if effects != INERTIA:
        parts |= {"support": PIECES[name], "weight": fmpq(1)}
    if effects != FRICTION:
        parts |= {"mass": fmpq(1)}
    return Slider(Body(length=rational(length), **(parts | more)), rational(rod_angle))
