"""Motion over time of an object that several pushers and walls touch, without inertia."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.contact import in_numbers
from planar_pushing.mechanics.effects import Effect
from planar_pushing.mechanics.entries import to_json, versions
from planar_pushing.mechanics.force.held import require_held
from planar_pushing.mechanics.kernels.arrays import flag_attributes
from planar_pushing.mechanics.outline import Outline, require_outline
from planar_pushing.mechanics.plane import Frame, direction
from planar_pushing.objects.plausible import warn_of_doubts
from planar_pushing.objects.several.contact import Contact, PlacedContact, place_contacts
from planar_pushing.objects.several.solve_contacts import scene_about_center
from planar_pushing.simulation.early_end import REASONS, warn_of_early_end
from planar_pushing.simulation.log import FLAGS
from planar_pushing.simulation.motion import require_policies
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.several.events import EventRun
from planar_pushing.simulation.several.instants import Instants
from planar_pushing.simulation.several.movers import (
    POINT_RADIUS,
    Mover,
    Pose,
    Shape,
    rests,
)
from planar_pushing.simulation.several.paths import path_of
from planar_pushing.simulation.several.readings import force_of, gap_of, mode_of, normal_of
from planar_pushing.simulation.several.run import Row, SeveralRun
from planar_pushing.simulation.several.steps import StepRun
from planar_pushing.simulation.walls import Wall, require_walls
from planar_pushing.simulation.world import require_pose
from planar_pushing.terms import quantities
from planar_pushing.terms.domain import DURATION, SAMPLE_COUNT
from planar_pushing.terms.errors import InvalidValue, require_positive
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import MOST_STEPS, Policy, PolicyName, PusherFrame
from planar_pushing.terms.options import Shape as PusherShape
from planar_pushing.terms.units import Units, with_units

#: Default number of steps.
STEPS = 1000
#: Largest overlap at the start, in sizes of the outline.
DRAWN = 1e-6


@warn_of_early_end
def simulate_contacts(
    contacts: Sequence[Contact],
    pushers: Sequence[Pusher],
    *,
    effects: Sequence[Effect],
    outline: Any,
    duration: float,
    step: float | None = None,
    object_pose: Sequence[float] = (0.0, 0.0, 0.0),
    walls: Sequence[Wall] = (),
    on_ambiguity: PolicyName | Sequence[tuple[float, PolicyName]] = Policy.KEEP_CONTACT,
    samples: int = 101,
    rtol: float = 1e-9,
    units: Units | None = None,
) -> xr.Dataset:
    """Simulate an object that several pushers and walls touch, and log its motion.

    Parameters
    ----------
    contacts : sequence of Contact
        Where each pusher touches the object at time 0, and the law between them; without velocities. A side
        is the contact of a fence.
    pushers : sequence of Pusher
        One for each contact: fingers or fences. With ``frame="fence"``, the axes of a velocity are those of
        its contact at time 0: along the tangent, which is the normal rotated by -90 degrees, and along the
        normal.
    effects : sequence of effects
        Without inertia, in the object's frame, as of `scene_at`. The forces of loads do not turn with the
        object.
    outline : sequence of pairs, Polygon, Disc, Outline, or an object with `coords` or `exterior`
    duration : float
        Time to simulate, > 0.
    step : float, optional
        Length of steps of order 1; by default, the motion is integrated from event to event.
    object_pose : (x, y, angle)
        Pose of the object's frame in the world at time 0, the angle in radians.
    walls : sequence of Wall
        Walls at rest in the world.
    on_ambiguity : policy, or sequence of (start_time, policy)
        As of `simulate`; the modes of the contacts are compared in their order, walls last.
    samples : int
        Number of evenly spaced instants in the log, >= 2; every event is also logged, without steps.
    rtol : float
        Error of a step in sizes of the outline, and in radians, from event to event.
    units : Units, optional
        Names of the units, for the log.

    Returns
    -------
    xarray.Dataset
        Over `time`: pose and twist of the object in the world, its angle in degrees. Over `contact`, which
        are the pushers in their order and then the walls: `mode`, `force` on the object in the world,
        `slip` (accumulated), `gap`, `work` (accumulated), and `pusher_position`. A finger or a fence that
        touches at two places has the mode of the larger force. If the run ends early, the attribute
        `stopped` says why: the object is jammed or wedged, no mode is consistent, or it touches at more
        than four places.

    Warns
    -----
    EarlyEndWarning
        If the motion could not continue until the end of the duration.

    Raises
    ------
    InvalidValue
        If a value is not allowed, the numbers of contacts and pushers differ, an effect has inertia, or the
        object overlaps a pusher or a wall at the start.
    """
    whole = require_outline(outline)
    placed = place_pushers(contacts, pushers, whole, outline)
    scene, center = scene_about_center(effects, whole)
    if scene.stores_energy:
        raise InvalidValue(
            "effects", "inertia", "effects without inertia",
            "leave Inertia out: with several contacts, the motion is quasi-static",
        )  # fmt: skip
    warn_of_doubts(effects, [contact.law for contact in placed], whole)
    require_held(scene)
    end = float(DURATION.require("duration", duration))
    if not np.ndim(duration) == 0 or not math.isfinite(end):
        raise InvalidValue("duration", duration, "one number", "give one")
    if step is not None:
        require_positive("step", step, "give the length of a step in the unit of the duration")
        if end / MOST_STEPS > step:
            raise InvalidValue("step", step, f"at most {MOST_STEPS:g} steps", "take longer steps")
    require_positive("rtol", rtol, "give a small number, such as 1e-9")
    times = np.linspace(0.0, end, int(SAMPLE_COUNT.require("samples", samples))).tolist()
    policies, fixed = require_policies(on_ambiguity), require_walls(walls)
    x, y, angle = require_pose(object_pose)
    world = Frame((x, y), tuple(direction(angle).tolist()))
    shape = Shape(whole.in_frame(Frame(center, (1.0, 0.0))))
    movers, breaks = [], {start for start, _ in policies if start > 0.0}
    for contact, pusher in zip(placed, pushers, strict=True):
        mover, jumps = mover_of(contact, pusher, world, shape.size, end)
        movers.append(mover)
        breaks.update(jumps)
    movers += [
        Mover(in_numbers(wall.law), wall.position, 0.0, wall.unit_normal, rests) for wall in fixed
    ]
    c_x, c_y = world.point_out(center).tolist()
    start = Pose(c_x, c_y, angle)
    kind = EventRun if step is None else StepRun
    run: EventRun | StepRun = kind(
        shape, Instants(scene, movers, policies), movers, start, sorted(breaks)
    )
    _require_apart(run, len(placed))
    run.advance(times, rtol if step is None else step)
    attributes = {
        "title": "motion of an object with several contacts",
        "source": f"{quantities.PAPER}, Secs. 2-5, with several contacts over time",
        **quantities.GLOBAL,
        "duration": end,
        "method": "event-driven" if step is None else "time-stepping",
        "on_ambiguity": policies[0][1].value if len(policies) == 1 else to_json(policies),
        "unit_notes": to_json({} if units else quantities.LOG_NOTES),
        "versions": versions(),
        "finished": np.int8(1),
        "stopped": REASONS[run.stop].text if run.stopped else "",
        "stopped_time": run.log[-1].time,
    }
    return _log(run, center, units).assign_attrs(attributes)


def place_pushers(contacts: Any, pushers: Any, outline: Outline, given: Any) -> list[PlacedContact]:
    """The contact of each pusher: a point of the object, with the law."""
    several = list(pushers) if isinstance(pushers, (list, tuple)) else []
    if not several or not all(isinstance(pusher, Pusher) for pusher in several):
        raise InvalidValue(
            "pushers", pushers, "a list of Pusher, one for each contact", "construct them"
        )
    kinds = list(contacts) if isinstance(contacts, (list, tuple)) else []
    if len(kinds) != len(several):
        raise InvalidValue(
            "pushers", f"{len(several)} pushers", f"one for each of {len(kinds)} contacts",
            "give as many pushers as contacts; walls have their own argument",
        )  # fmt: skip
    place_contacts(contacts, outline, given)
    placed = []
    for contact, pusher in zip(kinds, several, strict=True):
        if contact.grip_force is not None:
            raise InvalidValue(
                "grip_force", contact.grip_force, "none over time",
                "leave it out: solve_contacts has the motions of one instant",
            )  # fmt: skip
        if contact.velocity is not None or contact.twist is not None:
            raise InvalidValue(
                "contacts", "a contact with a velocity", "contacts without velocities",
                "give the motion in the pushers",
            )  # fmt: skip
        if pusher.arrays or np.ndim(pusher.radius):
            raise InvalidValue("pushers", "arrays", "single pushers", "simulate them one by one")
        places = place_contacts([contact], outline, given)
        one = places[0]
        if len(places) == 2 and contact.side is None:
            normal = np.sum([place.normal for place in places], axis=0)
            # The bisector, as long as its finger's center is away from the corner in radii.
            normal *= 2.0 / float(normal @ normal)
            one = one._replace(normal=(float(normal[0]), float(normal[1])))
        elif len(places) == 2:
            if pusher.shape == PusherShape.FINGER:
                raise InvalidValue(
                    "pushers", "a finger on a side", "a fence", "give the contact as a point"
                )
            middle = [(p + q) / 2.0 for p, q in zip(places[0].point, places[1].point, strict=True)]
            one = one._replace(point=(middle[0], middle[1]))
        placed.append(one)
    return placed


def mover_of(
    contact: PlacedContact, pusher: Pusher, world: Frame, size: float, duration: float
) -> tuple[Mover, tuple[float, ...]]:
    """A pusher in the world, and the times at which its velocity jumps."""
    n_x, n_y = world.vector_out(contact.normal).tolist()
    if pusher.frame == PusherFrame.FENCE:
        # The frame whose axes are those of the world, seen along the tangent and the normal.
        pusher = pusher.in_fence_frame(Frame((0.0, 0.0), (n_y, n_x)))
    path, jumps = path_of(pusher, duration)
    x, y = world.point_out(contact.point).tolist()
    law = in_numbers(contact.law)
    if pusher.shape == PusherShape.FENCE:
        return Mover(law, (x, y), 0.0, (n_x, n_y), path), jumps
    radius = float(np.asarray(pusher.radius))
    drawn = max(radius, POINT_RADIUS * size)
    return Mover(law, (x - drawn * n_x, y - drawn * n_y), radius, None, path), jumps


def _require_apart(run: SeveralRun, pushers: int) -> None:
    """Refuse pushers and walls that the object overlaps at the start."""
    for number, mover in enumerate(run.movers):
        touches = run.shape.touches(number, mover, run.pose, 0.0, -DRAWN * run.shape.size)
        if touches:
            is_pusher = number < pushers
            deepest = -min(touch.gap for touch in touches)
            which = f"pusher {number}" if is_pusher else f"wall {number - pushers}"
            raise InvalidValue(
                "pushers" if is_pusher else "walls",
                f"an overlap of {deepest:.6g} of {which} with the object",
                "pushers and walls that the object does not overlap at the start",
                "move it, choose a smaller radius, or turn the normal of a wall toward the object",
            )  # fmt: skip


def _log(run: SeveralRun, center: tuple[float, float], units: Units | None) -> xr.Dataset:
    """The log of a run as a dataset."""
    rows, count = run.log, range(len(run.movers))
    poses = np.array([row.pose for row in rows])
    c, s = np.cos(poses[:, 2]), np.sin(poses[:, 2])
    origin = poses[:, :2] - np.stack(
        [c * center[0] - s * center[1], s * center[0] + c * center[1]], axis=-1
    )
    twists = np.array([row.twist for row in rows])
    # About the origin of the object's frame, along the axes of the world.
    v_x = c * twists[:, 0] - s * twists[:, 1] + twists[:, 2] * (poses[:, 1] - origin[:, 1])
    v_y = s * twists[:, 0] + c * twists[:, 1] - twists[:, 2] * (poses[:, 0] - origin[:, 0])
    over = ("time", "contact")
    values: dict[str, tuple[tuple[str, ...], Array]] = {
        "object_position": (("time", "xy"), origin),
        "object_angle": (("time",), np.rad2deg(poses[:, 2])),
        "object_twist": (("time", "twist_component"), np.stack([v_x, v_y, twists[:, 2]], axis=-1)),
        "pusher_position": ((*over, "xy"), _positions(run)),
        "mode": (over, np.array([[mode_of(row, i) for i in count] for row in rows], "i1")),
        "force": ((*over, "xy"), _for_each(rows, count, force_of)),
        "slip": (over, np.array([row.totals.slipped for row in rows])),
        "gap": (over, np.array([[gap_of(run, row, i) for i in count] for row in rows])),
        "work": (over, np.array([row.totals.work for row in rows])),
        "contact_normal": (
            over,
            np.array([[normal_of(run, row, i) for i in count] for row in rows]),
        ),
        "contact_dissipated": (("time",), np.array([row.totals.rubbed for row in rows])),
        "dissipated": (("time",), np.array([row.totals.dissipated.sum() for row in rows])),
        "load_work": (("time",), np.array([row.totals.load_work for row in rows])),
        "solutions": (("time",), np.array([row.solutions for row in rows], "i1")),
    }
    variables = {}
    for name, (dims, numbers) in values.items():
        attributes = with_units(quantities.attributes(quantities.SEVERAL, name), units)
        if name == "mode":
            attributes |= flag_attributes(FLAGS["mode"])
        variables[name] = xr.Variable(dims, numbers, attributes)
    pushers = sum(mover.path is not rests for mover in run.movers)
    names = [f"pusher_{i}" if i < pushers else f"wall_{i - pushers}" for i in count]
    labels = {
        "time": xr.Variable(
            "time", np.array([row.time for row in rows]),
            with_units(quantities.attributes(quantities.SEVERAL, "time"), units),
        ),
        "contact": ("contact", names),
        "xy": ("xy", ["x", "y"]),
        "twist_component": ("twist_component", list(quantities.TWIST)),
    }  # fmt: skip
    return xr.Dataset(variables, labels)


def _positions(run: SeveralRun) -> Array:
    """Positions of the pushers: of a finger's center, or of the point of a fence."""
    return np.array([[mover.at(row.time)[0] for mover in run.movers] for row in run.log])


def _for_each(rows: Sequence[Row], count: range, of: Any) -> Array:
    """A quantity of each contact at each instant."""
    return np.array([[of(row, i) for i in count] for row in rows])


def contacts_at_start(
    contacts: Sequence[Contact],
    pushers: Sequence[Pusher],
    *,
    outline: Any,
    object_pose: tuple[float, float, float],
    walls: Sequence[Wall] = (),
) -> list[Contact]:
    """The contacts at time 0, with the velocities of their pushers, and those with walls.

    Parameters and errors are those of `simulate_contacts`, and the contacts those of `solve_contacts`.
    """
    whole = require_outline(outline)
    x, y, angle = object_pose
    world = Frame((x, y), tuple(direction(angle).tolist()))
    moving = []
    places = place_pushers(contacts, pushers, whole, outline)
    for contact, place, pusher in zip(contacts, places, pushers, strict=True):
        mover, _ = mover_of(place, pusher, world, whole.size, 1.0)
        v_x, v_y = (world.vector_in(mover.path(0.0)[1]) + 0.0).tolist()
        moving.append(replace(contact, velocity=(v_x, v_y)))
    shape = Shape(whole)
    for wall in walls:
        fixed = Mover(in_numbers(wall.law), wall.position, 0.0, wall.unit_normal, rests)
        touches = shape.touches(0, fixed, Pose(x, y, angle), 0.0, DRAWN * whole.size)
        moving += [Contact(touch.point, touch.normal, law=wall.law) for touch in touches]
    return moving
