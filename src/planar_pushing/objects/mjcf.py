"""`to_mjcf`: a scene as a MuJoCo model in XML."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, degrees, sin, sqrt
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from planar_pushing.mechanics.contact import Coulomb
from planar_pushing.mechanics.plane import Array
from planar_pushing.mechanics.scene import Scene, require_one_point, require_scene, require_single
from planar_pushing.objects.feet import Feet, feet_of, force_errors
from planar_pushing.terms.domain import Number
from planar_pushing.terms.errors import (
    InvalidValue,
    require_number,
    require_option,
    require_positive,
)
from planar_pushing.terms.options import Shape

#: Lengths in radii: edge rounding of outline and finger, feet, height of the outline, thickness of the
#: fence. A turning slider rolls on its rounded edge, which moves the contact by this much per radian.
ROUNDING, FOOT, HEIGHT, THICKNESS = 0.002, 0.02, 0.1, 0.05
#: Largest distance of the sides from the arcs of an outline, in its sizes: MuJoCo has no arcs.
FLAT = 1e-3
#: Half the length of the fence, in extents of the outline.
FENCE = 10.0
#: Range of the number of feet for a support: at least three are needed to resist like an area.
COUNTS = 3, 1000
#: Maximum fraction of the slider's mass in its feet. Only the feet move vertically.
LIGHT = 0.05
#: Coefficient of friction of the feet. MuJoCo lifts a sliding contact in proportion to its coefficient, so
#: that feet with a large one hop; friction itself depends only on coefficient times load.
COEFFICIENT = 0.03
#: Compression of the springs that load the feet, in radii: the loads are constant to within 1e-5.
COMPRESSED = 100.0
#: Time step in units of sqrt(m R / W), the time scale on which friction changes the slider's speed; and
#: time constant of the contacts in steps, for which MuJoCo requires at least two.
STEP, STEPS = 0.002, 2.5
#: Impedances of the feet and of the pusher's contact. Among impedances of 0.5 to 0.9 and time constants of
#: 2.5 to 50 steps, these came closest to `simulate` in five slow pushes of a box.
FEET, PUSHER = 0.9, 0.5
#: Ratio of the impedances of friction and normal force: the larger, the less a sticking contact creeps.
IMPRATIO = 1e4
#: Mass of the pusher relative to the slider's, and gain of its velocity control relative to the slider's
#: mass per step. A pusher as light as the slider yields in the impacts of soft contact.
HEAVY, GAIN = 1e3, 1e5


def to_mjcf(
    scene: Scene,
    *,
    pusher: str = Shape.FENCE,
    feet: int = 16,
    timestep: float | None = None,
    gravity: float = 9.80665,
) -> str:
    """Model of a scene in MJCF, the XML of MuJoCo.

    Parameters
    ----------
    scene : Scene
        A single scene with Coulomb's law, support friction and inertia, whose slider has an outline.
    pusher : {"fence", "finger"}
        Shape of the pusher, as in `Pusher`: a fence touches a corner of the outline, a finger touches a
        side. Two velocity actuators, `pusher_x` and `pusher_y`, drive it in the plane.
    feet : int
        Number of feet, 3 to 1000, that replace the pressure of each support that is not on points.
    timestep : float, optional
        In the scene's unit of time, by default ``sqrt(m R / W) / 500``. The stiffness of the contacts
        depends on it.
    gravity : float
        Acceleration for bodies added to the model, by default in m/s^2. It acts on nothing in the model.

    Returns
    -------
    str
        MJCF. The world is the fence frame: x along the fence, y its outward normal, z up; lengths, forces
        and times are in the scene's units. The joints `slider_x`, `slider_y` and `slider_turn` give the
        displacement of the slider's center and its rotation; their velocities are the twist as in
        `Solution`. The numeric fields `mean_force_error` and `worst_force_error` are the angles in radians
        between the wrenches of the feet and of the supports for the same motion (torques over R): 0 for
        point supports.

    Raises
    ------
    InvalidValue
        If the scene has no outline, friction or inertia, or has another law or effect, or an option is out
        of range.

    Notes
    -----
    Each foot is a light body on a vertical joint that a spring presses to the floor. Its load is therefore
    that of the scene, for any number of feet and any height of the pusher's contact. MuJoCo's elliptic cone
    then limits the friction at each foot to its share of W. Only the feet and the floor, and the pusher and
    the outline, collide. A fence that lies along a side touches both of its ends. Arcs of the outline are
    chains of sides with ends on the arc, within a thousandth of its size; holes are left out.
    """
    law, outline = _require_representable(scene)
    shape = require_option("pusher", pusher, Shape, "name one of these shapes")
    if shape == Shape.FINGER:
        require_one_point(scene, "pusher", "give a fence, or make the scene by scene_at(point=...)")
    remedy = "give an acceleration"
    gravity = require_number("gravity", gravity, np.isfinite, "a finite number", remedy)
    step = _required_step(timestep, scene)
    standing = feet_of(scene, _required_count(feet))
    root = Element("mujoco", model="planar_pushing")
    _errors(root, standing, force_errors(scene, standing))
    _settings(root, step, gravity)
    world = SubElement(root, "worldbody")
    size = FENCE * float(np.ptp(outline, axis=0).max())
    _add(world, "geom", name="floor", type="plane", size=(size, size, 1.0))
    _slider(world, scene, outline, standing)
    _pusher(world, scene, shape, size)
    _contacts(SubElement(root, "contact"), law, step, len(outline), len(standing.places))
    drives = SubElement(root, "actuator")
    for name in ("pusher_x", "pusher_y"):
        _add(drives, "velocity", name=name, joint=name, kv=GAIN * scene.inertia[0] / step)
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode") + "\n"


def _require_representable(scene: Scene) -> tuple[Coulomb, Array]:
    """The law and the outline of a scene that MuJoCo can represent, or `InvalidValue`."""
    require_single(require_scene(scene))
    if not isinstance(scene.contact, Coulomb):
        remedy = "give a finite coefficient: MuJoCo has no other law"
        raise InvalidValue("contact", scene.contact, "Coulomb", remedy)
    if not scene.friction or not scene.masses or scene.viscous or scene.loads:
        raise InvalidValue(
            "effects", scene.effects, "friction on supports and Inertia",
            "list both and no other effect: MuJoCo needs a mass, and the feet have only friction",
        )  # fmt: skip
    if scene.slider.outline is None:
        raise InvalidValue(
            "outline", None, "the corners of the slider in order",
            "give Slider(outline=...): MuJoCo needs a shape to push",
        )  # fmt: skip
    outline: Any = scene.slider.outline_in_body()
    return scene.contact, outline.vertices(FLAT * outline.size)


def _required_count(value: Any) -> int:
    smallest, largest = COUNTS
    return int(require_number(
        "feet", value, lambda n: smallest <= n <= largest and n == int(n),
        f"an integer from {smallest} to {largest}", "take more feet for a smaller error",
    ))  # fmt: skip


def _required_step(value: Any, scene: Scene) -> float:
    default = STEP * sqrt(scene.inertia[0] * scene.slider.radius / scene.weight)
    step = default if value is None else value
    return require_positive("timestep", step, "leave it out for the default")


def _errors(root: Element, feet: Feet, errors: tuple[float, float]) -> None:
    """Add the errors as a comment and as numeric fields that MuJoCo reads."""
    mean, worst = map(degrees, errors)
    root.append(ElementTree.Comment(
        f" Units are those of the scene. {len(feet.places)} feet carry its friction: for the same motion "
        f"their wrenches differ from the scene's by {mean:.2g} degrees on average and by at most "
        f"{worst:.2g}, torques over the radius. Contact is soft: push slowly, and halve the timestep to "
        "see how much it matters. "
    ))  # fmt: skip
    fields = SubElement(root, "custom")
    for name, error in zip(("mean_force_error", "worst_force_error"), errors, strict=True):
        _add(fields, "numeric", name=name, data=error)


def _settings(root: Element, step: float, gravity: float) -> None:
    _add(root, "compiler", angle="radian")
    _add(
        root, "option", timestep=step, gravity=(0.0, 0.0, -gravity), cone="elliptic", impratio=IMPRATIO,
        integrator="implicitfast", solver="Newton", tolerance=1e-12,
    )  # fmt: skip
    # Only the listed pairs collide.
    _add(SubElement(root, "default"), "geom", contype=0, conaffinity=0)


def _slider(world: Element, scene: Scene, outline: Array, feet: Feet) -> None:
    """The slider in its body frame; its joints are along the world's axes."""
    slider, height = scene.slider, HEIGHT * scene.slider.radius
    c, s = cos(slider.rod_angle), sin(slider.rod_angle)
    position = slider.rod_length * c, slider.rod_length * s, 0
    body = _add(world, "body", name="slider", pos=position, euler=(0, 0, slider.rod_angle))
    axes = ("x", "slide", (c, -s, 0)), ("y", "slide", (s, c, 0)), ("turn", "hinge", (0, 0, 1))
    for name, kind, axis in axes:
        _add(body, "joint", name=f"slider_{name}", type=kind, axis=axis)
    masses = _masses(scene, feet)
    _inertial(body, scene, feet, masses)
    for i, (start, end) in enumerate(zip(outline, np.roll(outline, -1, axis=0), strict=True)):
        line, size = (*start, height, *end, height), ROUNDING * slider.radius
        _add(body, "geom", name=f"side_{i}", type="capsule", size=size, fromto=line)
    for i, foot in enumerate(zip(*feet, masses, strict=True)):
        _foot(body, f"foot_{i}", foot, slider.radius)


def _foot(body: Element, name: str, foot: tuple[Array, float, float], radius: float) -> None:
    position, weight, mass = foot
    foot_body = _add(body, "body", name=name, pos=(*position, FOOT * radius), gravcomp=1)
    load, length = weight / COEFFICIENT, COMPRESSED * radius
    spring = {"stiffness": load / length, "springref": -length}
    _add(foot_body, "joint", name=name, type="slide", axis=(0, 0, 1), **spring)
    _add(foot_body, "geom", name=name, size=FOOT * radius, mass=mass)


def _masses(scene: Scene, feet: Feet) -> Array:
    """Masses of the feet; their total mass and moment of inertia are a small share of the slider's."""
    mass, square = scene.inertia
    shares = feet.weights / feet.weights.sum()
    away = feet.places / scene.slider.radius - scene.mass_center
    spread = float(shares @ (away**2).sum(axis=1))
    return np.asarray(LIGHT * square / max(spread, square) * mass * shares)


def _inertial(body: Element, scene: Scene, feet: Feet, masses: Array) -> None:
    """Inertia of the slider without its feet, so that both together have the scene's inertia."""
    (mass, square), radius = scene.inertia, scene.slider.radius
    center = radius * np.array(scene.mass_center)
    rest = mass - masses.sum()
    rest_center = (mass * center - masses @ feet.places) / rest
    moment = mass * (square * radius**2 + center @ center) - rest * rest_center @ rest_center
    moment -= masses @ (feet.places**2).sum(axis=1)
    _add(body, "inertial", pos=(*rest_center, 0.0), mass=rest, diaginertia=(moment, moment, moment))


def _pusher(world: Element, scene: Scene, shape: Shape, size: float) -> None:
    """The pusher, touching the slider's contact point."""
    mass, radius = HEAVY * scene.inertia[0], scene.slider.radius
    body = _add(world, "body", name="pusher", pos=(0.0, -ROUNDING * radius, HEIGHT * radius))
    for axis, along in (("x", (1, 0, 0)), ("y", (0, 1, 0))):
        _add(body, "joint", name=f"pusher_{axis}", type="slide", axis=along)
    fence = shape == Shape.FENCE
    half = (THICKNESS if fence else ROUNDING) * radius
    sizes = (size, half, half) if fence else half
    kind = "box" if fence else "sphere"
    _add(body, "geom", name="pusher", type=kind, pos=(0, -half, 0), size=sizes, mass=mass)


def _contacts(parent: Element, law: Coulomb, step: float, sides: int, feet: int) -> None:
    mu: Any = law.friction_coefficient
    pairs = [("floor", f"foot_{i}", COEFFICIENT, FEET) for i in range(feet)]
    pairs += [("pusher", f"side_{i}", mu, PUSHER) for i in range(sides)]
    for one, other, friction, impedance in pairs:
        _add(
            parent, "pair", geom1=one, geom2=other, condim=3,
            friction=(friction, friction, 0, 0, 0), solref=(STEPS * step, 1),
            solimp=(impedance, impedance, 1, 0.5, 2),
        )  # fmt: skip


def _add(parent: Element, tag: str, **attributes: Any) -> Element:
    """A child element with attributes: strings, numbers, or sequences of numbers."""
    return SubElement(parent, tag, {name: _text(value) for name, value in attributes.items()})


def _text(value: str | Number | Sequence[Number]) -> str:
    if isinstance(value, str):
        return value
    return " ".join(f"{number:.12g}" for number in np.ravel(value))
