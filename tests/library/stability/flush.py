"""Scenes with a flat side on the fence, and whether a push is stable by trial.

By trial: the support is many points, and a linear program asks whether forces along the edges of the
friction cone at both ends add up to the load. A foot at the center of rotation has many forces.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from mechanics.supports.quadrature import sampled
from scipy.optimize import nnls

import planar_pushing as pp

SQUARE = pp.Polygon([(-1, -1), (1, -1), (1, 1), (-1, 1)])
FEET = pp.Points([(-1, -1), (1, -1), (1, 1), (-1, 1)])
FREE, NONE = pp.InfiniteFriction(), pp.InfiniteFriction("none")


@dataclass(frozen=True, kw_only=True)
class Flush:
    """A side between two ends along the fence, measured from a point of the object."""

    effects: tuple
    law: object = pp.Coulomb(0.5)
    point: tuple = (0.0, -1.0)
    normal: tuple = (0.0, 1.0)
    ends: tuple = (-1.0, 1.0)

    @property
    def scene(self):
        scene = pp.scene_at(self.point, self.normal, effects=self.effects, contact=self.law)
        return replace(scene, slider=replace(scene.slider, side=self.ends, flush=True))

    @property
    def edges(self):
        """Wrenches about the object's origin of forces along the edges of the cone at both ends."""
        n = np.array(self.normal) / np.linalg.norm(self.normal)
        t = np.array([n[1], -n[0]])
        mu = getattr(self.law, "friction_coefficient", None)
        forces = [n - mu * t, n + mu * t] if mu is not None else [t, -t, n]
        places = [np.array(self.point) + end * t for end in self.ends]
        return np.array([[*f, x * f[1] - y * f[0]] for x, y in places for f in forces])

    def loads(self, twist):
        """Wrenches about the object's origin that sustain a twist: one, or some of those of a foot."""
        total, feet = np.zeros(3), []
        for each in self.effects:
            if isinstance(each, pp.Load):
                total -= torqued(np.array(each.center), np.array(each.force))
                continue
            places, shares = sampled(each.support)
            motion = twist[:2] + twist[2] * np.stack([-places[:, 1], places[:, 0]], axis=-1)
            speed = np.linalg.norm(motion, axis=-1)
            if isinstance(each, pp.Viscous):
                total += torqued(places, each.coefficient * shares[:, None] * motion)
                continue
            rests = speed < 1e-9
            feet += [(places[i], each.weight * shares[i]) for i in np.flatnonzero(rests)]
            force = each.weight * (shares / np.where(rests, np.inf, speed))[:, None] * motion
            total += torqued(places, force)
        sets = np.array([total])
        for place, share in feet:
            turns = np.linspace(0, 2 * np.pi, 48, endpoint=False)
            rim = share * np.stack([np.cos(turns), np.sin(turns)], axis=-1)
            sets = np.array([one + torqued(place, f) for one in sets for f in rim])
        return sets

    def is_stable(self, twist):
        """Whether the ends can exert all loads of a twist."""
        if isinstance(self.law, pp.PerfectlyRough):
            return True
        edges = self.edges
        for load in self.loads(np.asarray(twist, dtype=float)):
            size = np.abs(load).max()
            # Sum of the parts of the load that the edges do not make up.
            parts, _ = nnls(edges.T, load / size)
            if np.abs(edges.T @ parts - load / size).sum() > 1e-7:
                return False
        return True


def torqued(place, force):
    """Wrench about the origin of forces at places, summed."""
    place, force = np.broadcast_arrays(np.atleast_2d(place), np.atleast_2d(force))
    torque = place[:, 0] * force[:, 1] - place[:, 1] * force[:, 0]
    return np.array([*force.sum(axis=0), torque.sum()])


def rub(support, weight=1.0):
    return pp.SupportFriction(support=support, weight=weight)


def push(center, sense):
    """Twist about a center of the object's frame."""
    return np.array([sense * center[1], -sense * center[0], sense])


THREE = pp.Points([(0.0, 1.0), (-0.9, -0.5), (0.9, -0.5)], (1.0, 2.0, 1.0))
#: Scenes of every kind, the symmetric and degenerate ones first.
SCENES = {
    "square": Flush(effects=(rub(SQUARE),)),
    "square, mu = 1": Flush(effects=(rub(SQUARE),), law=pp.Coulomb(1)),
    "square, no friction at the fence": Flush(effects=(rub(SQUARE),), law=pp.Coulomb(0)),
    "square, infinite friction": Flush(effects=(rub(SQUARE),), law=FREE),
    "square, infinite friction, definition 2": Flush(effects=(rub(SQUARE),), law=NONE),
    "square, rough": Flush(effects=(rub(SQUARE),), law=pp.PerfectlyRough()),
    "square beside the side": Flush(effects=(rub(SQUARE),), point=(-0.6, -1.0), ends=(-0.3, 0.3)),
    "four feet": Flush(effects=(rub(FEET),)),
    "four feet, mu = 1.5": Flush(effects=(rub(FEET),), law=pp.Coulomb(1.5), ends=(-0.5, 0.5)),
    "four feet, infinite friction": Flush(effects=(rub(FEET),), law=FREE),
    "four feet, no friction at the fence": Flush(effects=(rub(FEET),), law=pp.Coulomb(0)),
    "three feet": Flush(effects=(rub(THREE),), law=pp.Coulomb(0.8)),
    "three feet, turned": Flush(
        effects=(rub(THREE, 3.0),), point=(1.5, 0.5), normal=(-2.0, -1.0), ends=(-0.4, 1.7)
    ),
    "two feet along the fence": Flush(effects=(rub(pp.Points([(-0.5, 0), (0.5, 0)])),)),
    "two feet across": Flush(effects=(rub(pp.Points([(0, 0.5), (0, -0.5)])),), law=pp.Coulomb(1)),
    "feet on a slanted line": Flush(effects=(rub(pp.Points([(-1, -0.5), (0, 0), (1, 0.5)])),), law=FREE),
    "segment along the fence": Flush(effects=(rub(pp.Segment((-1, 0), (1, 0))),)),
    "segment across": Flush(effects=(rub(pp.Segment((0, -1), (0, 1))),)),
    "segment on the fence": Flush(effects=(rub(pp.Segment((-1, -1), (1, -1))),), law=FREE),
    "ring": Flush(effects=(rub(pp.Ring(1.0)),)),
    "disc, pressure near an end": Flush(effects=(rub(pp.Disc(1.0, (0.9, 0.1))),), ends=(-1.0, 1.5)),
    "disc, pressure off the side": Flush(effects=(rub(pp.Disc(1.0, (1.5, 0.0))),)),
    "two supports": Flush(effects=(rub(SQUARE, 2.0), rub(THREE, 1.0)), law=pp.Coulomb(0.3)),
    "load ahead": Flush(effects=(rub(SQUARE), pp.Load(force=(0.1, -0.6), center=(0.2, 0.3)))),
    "load behind": Flush(effects=(rub(FEET), pp.Load(force=(0.3, 0.4), center=(0.0, 0.5))), law=FREE),
    "viscous": Flush(effects=(pp.Viscous(support=SQUARE, coefficient=2.0),)),
    "viscous ring, turned": Flush(
        effects=(pp.Viscous(support=pp.Ring(1.2)), pp.Viscous(support=THREE)), normal=(0.5, 1.0)
    ),
}  # fmt: skip


def random_scene(rng):
    """A scene at random, of any support and law."""
    corners = rng.uniform(-1, 1, (rng.integers(1, 6), 2))
    support = [
        lambda: pp.Points(corners, rng.uniform(0.2, 2, len(corners))) if len(corners) > 1 else FEET,
        lambda: pp.Segment(*rng.uniform(-1, 1, (2, 2))),
        lambda: pp.Disc(rng.uniform(0.3, 2), rng.uniform(-1, 1, 2)),
        lambda: pp.Polygon([(-1, -1), (rng.uniform(0, 2), -1), (0.5, rng.uniform(0, 2))]),
        lambda: pp.Ring(rng.uniform(0.3, 2), rng.uniform(-1, 1, 2)),
    ][rng.integers(5)]()
    law = [pp.Coulomb(rng.uniform(0, 2)), pp.Coulomb(rng.uniform(0, 0.3)), FREE, NONE][
        rng.integers(4)
    ]
    turn, far = rng.uniform(0, 2 * np.pi), rng.uniform(0.2, 1.5)
    normal = np.array([np.cos(turn), np.sin(turn)])
    point = tuple(np.array(support.center_of_pressure) - far * normal)
    ends = -rng.uniform(0.05, 1.5), rng.uniform(0.05, 1.5)
    effects = (rub(support, rng.uniform(0.5, 3)),)
    if rng.uniform() < 0.3:
        load = rng.uniform(-0.15, 0.15, 2), support.center_of_pressure
        effects += (pp.Load(force=tuple(load[0]), center=load[1]),)
    if rng.uniform() < 0.2:
        effects += (pp.Viscous(support=support, coefficient=rng.uniform(0.1, 2)),)
    return Flush(effects=effects, law=law, point=point, normal=tuple(normal), ends=ends)
