"""The answers of the library to the checks of the ledger: floats, with a tolerance, as balls."""

from __future__ import annotations

import numpy as np
from flint import arb
from scipy.optimize import brentq

import planar_pushing as pp
from planar_pushing.mechanics.plane import direction
from pulling_by_pushing.evidence.proofs.mechanics import FRICTION, INERTIA

#: Error of a number of the library, relative to numbers above one or 45 degrees: 32 roundings of a double.
TOLERANCE = 2.0**-48
#: Range of |f| / W for a motion with friction and inertia: the power grows with the force.
RATIOS = (1e-3, 1e3)
SHAPES = {
    "points": pp.Points,
    "polygon": pp.Polygon,
    "segment": pp.Segment,
    "disc": pp.Disc,
    "ring": pp.Ring,
}
LAWS = {
    "definition-1": pp.InfiniteFriction(),
    "definition-2": pp.InfiniteFriction(at_zero_normal="none"),
    "perfectly-rough": pp.PerfectlyRough(),
}


def ball(number, unit=1.0):
    return arb(float(number), TOLERANCE * max(unit, abs(float(number))))


def degrees(*angles):
    """Angles; an error in radians does not vanish with the angle."""
    return tuple(ball(np.rad2deg(angle), 45.0) for angle in angles)


def friction(entry):
    """Friction of a support; that of a ring without a radius is the effect of the ring."""
    given = {key: value for key, value in entry.items() if key != "shape"}
    if entry == {"shape": "ring"}:
        return pp.RingFriction()
    return pp.SupportFriction(support=SHAPES[entry["shape"]](**given))


def effects_of(scene):
    mass = pp.Inertia(
        gyration_radius=scene.gyration_radius, center=(scene.mass_along, scene.mass_across)
    )
    named = {FRICTION: friction(scene.support), INERTIA: mass}
    return tuple(named[name] for name in scene.effects.split("+"))


def scene_of(scene):
    """The scene of the library; a ring of radius 1 gives the unit of length."""
    law = LAWS[scene.law] if isinstance(scene.law, str) else pp.Coulomb(scene.law)
    slider = pp.Slider(
        rod_length=float(scene.rod_length), rod_angle=np.deg2rad(scene.rod_angle), radius=1.0
    )
    return pp.Scene(slider=slider, contact=law, effects=effects_of(scene))


class Library:
    """`pulling_by_pushing.evidence.proofs.mechanics.Mechanics` by the library."""

    def wrench(self, scene, motion, without=-1):
        u_x, u_y, omega = map(float, motion)
        length, effects = float(scene.rod_length), effects_of(scene)
        if without >= 0:
            feet, shares = (list(scene.support[key]) for key in ("positions", "weights"))
            del feet[without]
            rest = 1 - shares.pop(without) / sum(scene.support["weights"])
            effects = (pp.SupportFriction(support=pp.Points(feet, shares), weight=rest),)
        twist = [u_x, u_y + omega * length, omega]
        f_x, f_y, torque = sum(pp.wrench(effect, twist) for effect in effects)
        return ball(f_x), ball(f_y), ball(torque + length * f_y)

    def motion(self, scene, force_angle, power):
        angle, pushed = np.deg2rad(float(force_angle)), scene_of(scene)
        e, rod = direction(angle), pushed.slider.rod_angle

        def moved(ratio=None):
            return pp.motion_of_force(pushed, angle, ratio)

        def excess(ratio):
            reached = moved(ratio).contact_motion @ e
            return (0.0 if np.isnan(reached) else reached) - float(power)

        ratio = brentq(excess, *RATIOS, xtol=1e-15) if len(scene.pure) == 2 else None
        motion = moved(ratio)
        u = motion.contact_motion
        parts = np.array([u @ direction(rod), u @ direction(rod + np.pi / 2), motion.twist[2]])
        return tuple(map(ball, parts * float(power) / (u @ e)))

    def dip(self, scene):
        raise NotImplementedError("a minimum over all magnitudes")

    def friction_cone(self, scene):
        cone = pp.friction_cone(scene_of(scene))
        return degrees(cone.right, cone.left)

    def motion_cone(self, scene):
        cone = pp.motion_cone(scene_of(scene))
        return degrees(cone.right, cone.left)

    def bound_of_the_cases(self, scene):
        cone = pp.conservative_motion_cone(scene_of(scene))
        return degrees(cone.right, cone.left)

    def modes(self, scene, pusher_angle, magnitude):
        return [
            (
                each.mode.name.lower().replace("_", "-"),
                degrees(np.arctan2(each.force[1], each.force[0]))[0]
                if np.any(each.force)
                else None,
            )
            for each in pp.solve(scene_of(scene), np.deg2rad(pusher_angle), magnitude)
        ]
