"""Fields of a log: their places in the rows of the core, and their units; codes that two places name."""

import numpy as np
import pytest
from mechanics.builders import make_scene

import planar_pushing as pp
from planar_pushing.core import system
from planar_pushing.core.run import (
    LOG_DISSIPATED,
    LOG_FORCE,
    LOG_MODE,
    LOG_PUSHER,
    LOG_TIME,
    LOG_TWIST,
)
from planar_pushing.simulation.fields import COMPUTED, FIELDS, arrays, logged_fields, scales_of
from planar_pushing.simulation.problem import Problem
from planar_pushing.terms.options import Event

FILM = pp.Viscous(support=pp.Disc(1.0), coefficient=0.1)


def test_a_row_is_scaled_by_the_radius_and_the_unit_of_force():
    width = LOG_DISSIPATED + 2
    (scales,) = scales_of(np.array([3.0]), np.array([0.5]), width)
    assert set(scales) == {1.0, 3.0, 0.5, 1.5}
    assert scales[LOG_DISSIPATED:].tolist() == [1.5, 1.5]
    assert scales[LOG_TWIST : LOG_TWIST + 3].tolist() == [3.0, 3.0, 1.0]
    assert scales[LOG_PUSHER : LOG_PUSHER + 2].tolist() == [3.0, 3.0]
    assert scales[[LOG_FORCE, LOG_FORCE + 1]].tolist() == [0.5, 0.5]
    assert scales[[LOG_TIME, LOG_MODE]].tolist() == [1.0, 1.0]


def test_every_number_of_a_row_is_read_by_one_field():
    """Twice only where a field is computed from the numbers of another."""
    sizes = {(): 1, ("xy",): 2, ("twist_component",): 3}
    places = []
    for name, place, dims, *_ in FIELDS:
        if name not in COMPUTED or name in ("rod_angle", "dissipated", "evaluations"):
            places += range(place, place + sizes.get(dims, 1))
    assert sorted(places) == list(range(LOG_DISSIPATED + 1))


@pytest.mark.parametrize("effects", [
    (pp.Inertia(mass=1.0), pp.RingFriction(weight=2.0), pp.RingFriction(weight=3.0)),
    (pp.RingFriction(weight=2.0), pp.Inertia(mass=1.0), FILM),
], ids=["friction", "viscous"])  # fmt: skip
def test_energies_are_those_of_the_effects_in_their_order(effects):
    scene = make_scene(2.0, 0.5, effects)
    problem = Problem(scene=scene, pusher=pp.Pusher(velocity=(0.0, 1.0)), duration=1.0)
    rows = np.zeros((1, LOG_DISSIPATED + 2))
    rows[0, LOG_DISSIPATED:] = 5.0, 7.0
    found = arrays(rows, problem, logged_fields(problem, "event-driven"))["dissipated"][0]
    resists = [not isinstance(effect, pp.Inertia) for effect in effects]
    assert found[resists].tolist() == [5.0, 7.0]
    assert not found[np.logical_not(resists)].any()


def test_events_have_the_codes_of_the_core():
    """The layers that name them do not import one another."""
    names = {
        "SLIDER_CENTER_REACHES_FENCE": "CENTER_DOWN", "MOTION_CENTER_AT_POINT": "CENTER_AT_POINT",
        "NORMAL_VELOCITY_REVERSES": "NORMAL_REVERSES",
        "TANGENTIAL_VELOCITY_REVERSES": "TANGENTIAL_REVERSES",
    }  # fmt: skip
    causes = [event for event in Event if event is not Event.NONE]
    assert [getattr(system, names.get(e.name, e.name)) for e in causes] == causes
    assert len(causes) == system.CAUSES
