"""Rows of inputs of the core: the numbers of one or many scenes, their times, and the pusher's motion."""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.core.motion.kinematics.run import INPUTS, Inputs
from planar_pushing.core.supports.chain import CHAIN_PIECE
from planar_pushing.core.supports.rows import LOAD, MASS
from planar_pushing.mechanics.kernels.columns import Columns, row_of
from planar_pushing.mechanics.outline import Outline
from planar_pushing.mechanics.outline.chains import RHO, TURN
from planar_pushing.mechanics.outline.places import (
    chain_rows,
    depth_tolerance,
    places_with_normals,
)
from planar_pushing.mechanics.plane import Frame
from planar_pushing.mechanics.pressure.table import Table, joined_data
from planar_pushing.mechanics.rows import FORMS, EffectColumns, unit_vector
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.simulation.motion import (
    POINTS,
    constant_pieces,
    smooth_pieces,
    starts_of,
    write_policies,
)
from planar_pushing.simulation.problem import Problem
from planar_pushing.simulation.pusher import Pusher
from planar_pushing.simulation.world import WORLD, World
from planar_pushing.terms.domain import Number
from planar_pushing.terms.numbers import Array
from planar_pushing.terms.options import Method, PusherFrame, Shape

#: Inputs of the piece at the contact.
WALL = ("wall", "place", "turn")


class Scenes(NamedTuple):
    """The scenes of a problem as numbers for the core.

    Lengths are in radii of the slider. Forces are in units of a power of two near those of the scene, so
    that products of very small or large ones are numbers, with the same digits.

    Attributes
    ----------
    problem : Problem
    data : ndarray
        Numbers that all scenes share: effects and outline.
    inputs : ndarray, shape (scenes, numbers)
        Beginning of the rows of inputs: numbers of the effects, and of the scene.
    radius, force, ends : ndarray, shape (scenes,)
        Radii of the sliders, units of force, and durations.
    velocities : ndarray, shape (scenes, pieces, 2)
        Piecewise constant velocities of the pushers, without pieces for a function of time.
    world : World or None
        The world, with arrays of shape (scenes,).
    """

    problem: Problem
    data: Array
    inputs: Array
    radius: Array
    force: Array
    ends: Array
    velocities: Array
    world: World | None

    @classmethod
    def of(cls, problem: Problem, data: Array, columns: Array) -> Scenes:
        """Scenes from the arrays of `numbers_of`, shape (scenes, columns)."""
        world = None
        if problem.world is not None:
            columns, numbers = columns[:, :-WORLD], columns[:, -WORLD:]
            world = World.of_numbers(numbers.T)
        pieces = len(problem.pusher.velocities)
        first = columns.shape[1] - 2 * pieces
        radius, ends = columns[:, first - 2], columns[:, first - 1]
        velocities = columns[:, first:].reshape(len(columns), pieces, 2) / radius[:, None, None]
        inputs = columns[:, : first - 2].copy()
        force = _scale_forces(problem.entries, inputs)
        return cls(problem, data, inputs, radius, force, ends, velocities, world)

    def pusher_of(self, scene: int) -> Pusher:
        """The pusher of one of the scenes, in its fence frame."""
        pusher = self.problem.pusher
        if pusher.frame == PusherFrame.FENCE or self.world is None:
            return pusher
        x, y = self.world.fence.axis
        return pusher.in_fence_frame(Frame((0.0, 0.0), (float(x[scene]), float(y[scene]))))

    def pieces(self, part: slice) -> tuple[Array, npt.NDArray[Any]]:
        """Pieces of the pusher's motion, shape (scenes, pieces, numbers), and how many of each are valid.

        Those of a function of time are of the first scene of the part only.

        Raises
        ------
        InvalidValue
            If a function does not return a velocity.
        """
        pusher, policies = self.pusher_of(part.start), self.problem.on_ambiguity
        ends, radius, cuts = self.ends[part], self.radius[part], starts_of(policies)
        if self.problem.follows_function:
            end = float(ends[0])
            inner = {time for time in (*pusher.breakpoints, *cuts) if 0 < time < end}
            times = [0.0, *sorted(inner), end]
            pieces = smooth_pieces(pusher.velocity_at, times, float(radius[0]))[None]
            counts = np.array([pieces.shape[1]])
        else:
            starts = [time for time, _ in pusher.velocities]
            pieces, counts = constant_pieces(starts, self.velocities[part], ends, cuts)
        write_policies(pieces, policies)
        return pieces, counts

    def rows(
        self, part: slice, pieces: Array, counts: npt.NDArray[Any], times: Array, events: bool
    ) -> Array:
        """Rows of inputs of a part of the scenes.

        Parameters
        ----------
        part : slice
        pieces, counts : ndarray
            As returned by `pieces`.
        times : ndarray, shape (scenes, kinds, times)
            Times to log, or intervals of steps in the form of the core.
        events : bool
            Whether each event is logged as well.
        """
        inputs = self.inputs[part].copy()
        scene = Columns(Inputs, inputs[:, inputs.shape[1] - INPUTS :])
        scene.pieces, scene.times = counts, times.shape[-1]
        scene.coefficients = POINTS if self.problem.follows_function else 1
        scene.logs_events = events
        shape = len(inputs), -1
        return np.concatenate([inputs, times.reshape(shape), pieces.reshape(shape)], axis=1)


def numbers_of(
    problem: Problem, method: Method = Method.EVENT_DRIVEN
) -> tuple[Array, list[Number]]:
    """The numbers of a problem: those that all scenes share, and one column for each of the others.

    The columns are the inputs of the core, except for times and pieces; then radius, duration,
    components of a piecewise constant velocity, and the world if there is one. The core has lengths in
    units of the radius. Its masses and viscous friction coefficients are therefore those of the scene
    multiplied by the radius. The weight is zero without friction, and the mass is zero without inertia.
    """
    scene, slider, entries = problem.scene, problem.scene.slider, problem.entries
    radius, (mass, gyration), (v_x, v_y, omega) = slider.radius, scene.inertia, problem.twist
    is_finger, finger_radius = problem.shape == Shape.FINGER, problem.pusher.radius
    effects, columns = _effects_of(entries, scene, method)
    data, outline = joined_data(effects, len(columns)), slider.outline
    chain = np.empty((0, CHAIN_PIECE)) if outline is None else chain_rows(outline)
    load, cross, dot = _load_of(scene)
    right, left, slips, closed, rough = scene.law
    side_start, side_end = slider.side
    columns += row_of(
        Inputs,
        weight=scene.weight if scene.friction else 0.0,
        mass=mass * radius if scene.stores_energy else 0.0,
        gyration=gyration, center=scene.mass_center, load=load, cross=cross, dot=dot,
        length=slider.length_ratio, angle=slider.rod_angle,
        right=right, left=left, slips=slips, closed=closed, rough=rough,
        twist=(v_x / radius, v_y / radius, omega), gap=problem.gap / radius, finger=is_finger,
        radius=finger_radius / radius, side_start=side_start / radius, side_end=side_end / radius,
        fine=_fineness(slider), chain=len(chain), chain_place=len(data), **_wall_of(slider),
        frictions=sum(entry.degree == 1 for entry in entries), resisting=len(entries),
        tolerance=problem.rtol, pieces=0.0, coefficients=0.0, times=0.0, logs_events=0.0,
        flush=slider.flush,
    )  # fmt: skip
    columns += [radius, problem.duration]
    columns += [part for _, velocity in problem.pusher.velocities for part in velocity]
    columns += problem.world.numbers if problem.world is not None else []
    return np.concatenate([data, chain.ravel()]), columns


def _scale_forces(entries: list[EffectColumns], inputs: Array) -> Array:
    """Divide the forces of rows of inputs by their units, which are returned."""
    places: dict[int, list[int]] = {1: [], 2: []}
    position, scene = 0, inputs.shape[1] - INPUTS
    for entry in entries:
        places[entry.degree] += range(position, position + len(entry.forces))
        position += len(entry.forces) + len(entry.others)
    numbers = Columns(Inputs, np.arange(scene, inputs.shape[1]))
    weight, mass = int(numbers.weight), int(numbers.mass)
    loads = [*numbers.load.astype(int), int(numbers.cross), int(numbers.dot)]
    size = np.zeros(len(inputs))
    # Without friction and loads the unit is that of viscous friction, and without it that of the mass.
    for columns in ([*places[1], *loads], places[2], [mass]):
        largest = np.abs(inputs[:, columns]).max(axis=1, initial=0.0)
        size = np.where(size > 0.0, size, largest)
    unit: Array = np.ldexp(1.0, np.frexp(np.where(size > 0.0, size, 1.0))[1] - 1)
    scaled = [*places[1], *places[2], *loads, weight, mass]
    inputs[:, scaled] /= unit[:, None]
    return unit


def _effects_of(
    entries: list[EffectColumns], scene: Scene, method: Method
) -> tuple[list[tuple[int, int, Table | None]], list[Number]]:
    """Kinds, first columns and tables of effects, and their columns.

    The core fills the columns of inertia and loads. In a step of time-stepping, momentum is a load.
    """
    effects: list[tuple[int, int, Table | None]] = []
    columns: list[Number] = []
    for entry in entries:
        effects.append((entry.kind, len(columns), entry.table))
        factor = scene.slider.radius if entry.degree == 2 else 1.0
        columns += [*(force * factor for force in entry.forces), *entry.others]
    massive = scene.stores_energy
    loaded = bool(scene.loads) or (massive and method == Method.TIME_STEPPING)
    for kind, listed in ((MASS, massive), (LOAD, loaded)):
        if listed:
            effects.append((kind, len(columns), None))
            columns += [0.0] * FORMS[kind][0].size
    return effects, columns


def _wall_of(slider: Slider) -> dict[str, Any]:
    """Inputs of the body frame in that of the outline, and of the piece at the contact at time 0."""
    outline, ((x, y), (c, s)) = slider.outline, slider.outline_frame
    wall: Any = (-1.0, 0.0, 0.0)
    if outline is None:
        return {"frame": (0.0, 0.0), "axis": (c, s)} | dict(zip(WALL, wall, strict=True))
    rod = slider.rod_length, slider.rod_angle
    with suppress(ValueError):  # of mismatched shapes, which the batch rejects itself
        wall = xr.apply_ufunc(
            partial(_walls_at, outline), *rod, x, y, c, s, output_core_dims=[[]] * 3, dask="allowed"
        )
    unit = depth_tolerance(outline)
    return {"frame": (x / unit, y / unit), "axis": (c, s)} | dict(zip(WALL, wall, strict=True))


def _walls_at(
    outline: Outline, length: Number, angle: Number, x: Number, y: Number, c: Number, s: Number
) -> tuple[Array, Array, Array]:
    """Pieces at the ends of rods, their places there, and angles of the body frames.

    The arguments after the outline are length and angle of the rods, and origin and axis of the body frames
    in the frame of the outline. A piece has the normal of the fence; it is -1 off the outline.
    """
    arrays = np.broadcast_arrays(*(np.asarray(part, float) for part in (length, angle, x, y, c, s)))
    length, angle, x, y, c, s = (array.ravel() for array in arrays)
    body = Frame((x, y), (c, s))
    contacts = body.point_out(np.stack([-length, 0.0 * length], axis=-1))
    normals = body.vector_out(np.stack([np.sin(angle), np.cos(angle)], axis=-1))
    spots = places_with_normals(outline, contacts, normals)
    is_side = np.isinf(outline.pieces[spots.piece, RHO])
    piece = np.where(spots.gap <= 2.0 * outline.tolerance, spots.piece, -1.0)
    place = np.where(is_side, spots.position / depth_tolerance(outline), spots.beta)
    turn = np.arctan2(s, c)
    # The rod's angle is that of the body frame less that of the piece, not a full turn more or less.
    turn = turn + TURN * np.round((angle + spots.beta - turn) / TURN)
    piece, place, turn = (part.reshape(arrays[0].shape) for part in (piece, place, turn))
    return piece, place, turn


def _fineness(slider: Slider) -> Number:
    """Radius in units of the outline's tolerance; 0 without an outline."""
    if slider.outline is None:
        return 0.0
    return slider.radius / depth_tolerance(slider.outline)


def _load_of(scene: Scene) -> tuple[list[Number], Number, Number]:
    """Force of the loads in the initial body frame, and its cross and dot products with their points."""
    total: list[Number] = [0.0, 0.0, 0.0, 0.0]
    c, s = unit_vector(scene.slider.rod_angle)
    for load in scene.loads:
        (x, y), (p_x, p_y) = load.force, scene.mass_center
        if load.center is not None:
            p_x, p_y = (coordinate / scene.slider.radius for coordinate in load.center)
        g_x, g_y = x * c + y * s, y * c - x * s
        terms = g_x, g_y, p_x * g_y - p_y * g_x, p_x * g_x + p_y * g_y
        total = [sum(pair) for pair in zip(total, terms, strict=True)]
    return total[:2], *total[2:]
