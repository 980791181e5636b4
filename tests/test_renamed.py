"""Each former name works, warns once for the caller's line, and gives the result of the present name."""

import warnings

import numpy as np
import pytest

import planar_pushing as pp
from planar_pushing.study.files.simulate_model import SimulateEntry
from planar_pushing.terms.options import FORMER_EVENTS as EVENTS
from planar_pushing.terms.renamed import renamed_keywords
from pushes.written import TRIANGLE, feet

SLIDER = pp.Slider(rod_length=2.0, rod_angle=np.deg2rad(40))
SCENE = pp.Scene(slider=SLIDER, contact=pp.Coulomb(0.5), effects=(pp.RingFriction(), pp.Inertia()))
QUASI_STATIC = pp.Scene(slider=SLIDER, contact=pp.Coulomb(0.5), effects=(pp.RingFriction(),))
SQUARE = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
FRICTION = (pp.SupportFriction(support=pp.Points(SQUARE)),)
PUSHER = pp.Pusher(velocity=(0.0, 1.0))


def drawn(**options):
    """Corners of every shape in the picture of a push."""
    ax = pp.draw(SCENE, 1.2, **options)
    return [each.get_path().vertices.tolist() for each in ax.patches]


def moved(until=None, duration=0.3):
    return pp.simulate(QUASI_STATIC, pusher=PUSHER, duration=duration, until=until)


def pushes():
    return pp.simulate_pushes(feet(), TRIANGLE, 16, seed=4)


def compared(models):
    return pp.compare(pushes(), models, resamples=2)["error"].to_series().to_dict()


def loads(**options):
    return pp.wrench_set(FRICTION, (1.0, -1.004, 1.0), **options)


def touched():
    return pp.first_touch(SQUARE, (0, -5), (0, 8))


def until_in_file(event):
    return SimulateEntry(pusher_angle=0, duration=1, until={"event": event}).until


RENAMED = {
    "magnitude": (lambda: drawn(magnitude=2.0), lambda: drawn(pusher_magnitude=2.0)),
    "rate": (
        lambda: pp.animate(moved(), frames=2, rate=10).gif,
        lambda: pp.animate(moved(), frames=2, frames_per_second=10).gif,
    ),
    "way": (lambda: touched().way, lambda: touched().fraction),
    "rest": (lambda: loads().rest.tolist(), lambda: loads().offset.tolist()),
    "within": (lambda: loads(within=0.005), lambda: loads(tolerance=0.005)),
    "exact": (lambda: compared(["exact"]), lambda: compared(["known_feet"])),
    "exact_ellipsoid": (
        lambda: compared(["exact_ellipsoid"]),
        lambda: compared(["known_feet_ellipsoid"]),
    ),
    "even_and_corners": (
        lambda: repr(pp.identify(pushes(), family="even_and_corners", resamples=2)),
        lambda: repr(pp.identify(pushes(), family="uniform_and_corners", resamples=2)),
    ),
    "ring-center": (
        lambda: pp.motion_centers(QUASI_STATIC, 1.0, origin="ring-center").tolist(),
        lambda: pp.motion_centers(QUASI_STATIC, 1.0, origin="slider-center").tolist(),
    ),
    "LIES": (
        lambda: moved("LIES", 9.0).attrs["stopped"],
        lambda: moved("SLIDER_CENTER_REACHES_FENCE", 9.0).attrs["stopped"],
    ),
    "STOPS": (lambda: until_in_file("STOPS"), lambda: until_in_file("SLIDER_STOPS")),
    **{
        each: (lambda each=each: getattr(pp.Event, each), lambda each=each: pp.Event[EVENTS[each]])
        for each in EVENTS
        if each not in ("LIES", "STOPS")
    },
}


@pytest.mark.parametrize("former", RENAMED)
def test_a_former_name_works_and_warns(former):
    before, now = RENAMED[former]
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        found = before()
    (warning,) = seen
    assert warning.category is DeprecationWarning
    assert str(warning.message).startswith(f"{former} is now ")
    assert str(warning.message).endswith("; it will be removed in 2.0")
    assert warning.filename == __file__
    assert found == now()


def test_the_names_of_events_are_read_by_index():
    with pytest.warns(DeprecationWarning, match="^STARTS is now PUSH_STARTS"):
        assert pp.Event["STARTS"] is pp.Event.PUSH_STARTS
    assert not EVENTS.keys() & pp.Event.__members__.keys()
    assert set(EVENTS.values()) <= pp.Event.__members__.keys()
    with pytest.raises(AttributeError, match="NEVER"):
        _ = pp.Event.NEVER
    with pytest.raises(KeyError, match="NEVER"):
        _ = pp.Event["NEVER"]


def test_a_dataclass_takes_former_keywords():
    with pytest.warns(DeprecationWarning, match="^rest is now offset"):
        found = pp.WrenchSet(rest=np.zeros(3), foot=None, radius=0.0, length=1.0)
    assert found == pp.WrenchSet(offset=np.zeros(3), foot=None, radius=0.0, length=1.0)


def test_both_names_are_refused():
    with pytest.raises(TypeError, match="got tolerance and its former name within"):
        loads(within=0.1, tolerance=0.1)


def test_a_decorated_function_keeps_its_name_and_text():
    def function(new: int) -> int:
        """Text."""
        return new

    found = renamed_keywords(old="new")(function)
    assert (found.__name__, found.__doc__, found(3), found(new=4)) == ("function", "Text.", 3, 4)
