"""Methods for the friction wrench of the ring, for the edges of motion cones, and for motion over time."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache, lru_cache
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk, elliprd, hyp2f1

from planar_pushing.mechanics.contact import InfiniteFriction
from planar_pushing.mechanics.effects import RingFriction
from planar_pushing.mechanics.force.cones import motion_angle
from planar_pushing.mechanics.force.wrench import ring_profile
from planar_pushing.mechanics.plane import Array, direction
from planar_pushing.mechanics.scene import Scene
from planar_pushing.mechanics.slider import Slider
from planar_pushing.scenes.files import load_scene_file
from planar_pushing.scenes.simulate import arguments
from planar_pushing.simulation.batch import simulate_batch
from planar_pushing.simulation.early_end import quietly
from planar_pushing.simulation.simulate import simulate
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.options import Method as Integrator

#: Spin ratios at which the wrench is computed.
SPIN_RATIOS = np.array([1e-8, 0.1, 0.9, 1 - 1e-3, 1 - 1e-9, 1, 1 + 1e-9, 3, 1e8])
#: Cones whose edges are computed: every rod length with every coefficient of friction. For the last four
#: lengths the edges' lines of force are almost tangent to the ring.
NEAR_TANGENT = np.sqrt(2) * (1 + np.array([-1e-3, -1e-6, 1e-6, 1e-3]))
ROD_LENGTHS = np.append(np.geomspace(0.2, 10, 14), NEAR_TANGENT)
FRICTION_COEFFICIENTS = np.array([0.5, 2.0, np.inf])
ROD_ANGLE = np.pi / 4
#: Scene files of the motions: slip with infinite friction in one mode, and a pull whose fence turns.
SCENES = {
    "slipping": "workflow/scenes/slipping.yaml",
    "pulling": "workflow/scenes/turning_fence.yaml",
}
#: Setting of a formula, numbers of points, and tolerances.
FORMULA = (0.0,)
RULE_POINTS, NODES = tuple(2.0 ** np.arange(2, 17)), tuple(2.0 ** np.arange(2, 10))
TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13)
#: Tolerances and numbers of steps of a motion.
STEP_TOLERANCES = tuple(10.0 ** -np.arange(4, 13, 2))
STEP_COUNTS = (10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0)
#: A duration as good as zero.
INSTANT = 1e-9
TINY, EPS = np.finfo(float).tiny, float(np.finfo(float).eps)

#: Force and torque at spin ratios.
Profile = Callable[[Array], tuple[Array, Array]]
#: Maps arguments, the last of which is the setting, to results and the evaluations of each.
Run = Callable[..., tuple[Any, ...]]


class Method(NamedTuple):
    """A way to compute a friction wrench, an edge of a motion cone, or a motion.

    Attributes
    ----------
    name : str
    counted : str
        The function evaluated: "nothing", "integrand", "wrench" (in closed form), or "motion".
    settings : tuple of float
        Numbers of points or of steps, or tolerances, from coarse to fine; a single 0 for a formula.
    run : callable
        For the wrench, force and torque at spin ratios k >= 0; for a cone, the motion angle in radians from
        rod length and force angle; for a motion, the final rod angle in degrees of a scene, which is
        repeated in a number of copies; in all cases followed by the evaluations of each. Arguments of
        wrench and cone, and their results, have shape (n,).
    batch : int
        Number of copies of the arguments in an array that is timed; for a rule, times its number of points.
        It is 0 for a method that takes one argument at a time.
    """

    name: str
    counted: str
    settings: tuple[float, ...]
    run: Run
    batch: int = 0


# --- Friction wrench, Eqs. (2)-(3) ----------------------------------------------------------------------


def _formula(profile: Profile) -> Run:
    """A wrench for any k >= 0 from a formula."""
    return lambda k, setting: (*profile(k), np.zeros(k.shape))


def _dual(inner: Profile) -> Run:
    """A wrench for any k >= 0 from a formula for k <= 1: beyond, force and torque are exchanged."""

    def profile(k: Array) -> tuple[Array, Array]:
        force, torque = inner(np.minimum(k, 1 / k))
        return np.where(k > 1, torque, force), np.where(k > 1, force, torque)

    return _formula(profile)


def _hypergeometric(k: Array) -> tuple[Array, Array]:
    m = k * k
    return hyp2f1(-0.5, 0.5, 1, m), k / 2 * hyp2f1(0.5, 0.5, 2, m)


def _carlson(k: Array) -> tuple[Array, Array]:
    """B = x R_D(0, 1, x) / 3 and E = B + x R_D(0, x, 1) / 3 (DLMF 19.25.1): all terms are positive."""
    x = np.maximum((1 - k) * (1 + k), TINY)
    torque = x / 3 * elliprd(0, 1, x)
    return 2 / np.pi * (torque + x / 3 * elliprd(0, x, 1)), 2 / np.pi * k * torque


def _textbook(k: Array) -> tuple[Array, Array]:
    """E and K as handbooks print them: the torque cancels for small k, and K(1) is infinite."""
    m = k * k
    with np.errstate(invalid="ignore"):
        return 2 / np.pi * ellipe(m), 2 / np.pi * (ellipe(m) - (1 - m) * ellipk(m)) / k


def _ellipsoid(k: Array) -> tuple[Array, Array]:
    """The ellipsoid through the ring's maximum force and torque."""
    return 1 / np.hypot(1.0, k), k / np.hypot(1.0, k)


def _speed(theta: Any, k: Any, cos: Any, sqrt: Any) -> Any:
    """Speed of a point of the ring; its square cannot become negative near k = 1."""
    half = cos(theta / 2)
    return sqrt((1 - k) ** 2 + 4 * k * half * half)


def _force(theta: Any, k: Any, cos: Any = np.cos, sqrt: Any = np.sqrt) -> Any:
    return (1 + k * cos(theta)) / _speed(theta, k, cos, sqrt)


def _torque(theta: Any, k: Any, cos: Any = np.cos, sqrt: Any = np.sqrt) -> Any:
    return (k + cos(theta)) / _speed(theta, k, cos, sqrt)


def _rule(nodes: Callable[[int], tuple[Array, Array]]) -> Run:
    """A wrench by a quadrature rule with the given angles and weights."""

    def run(k: Array, points: float) -> tuple[Array, ...]:
        theta, weights = nodes(int(points))
        # Not a matrix product: its threads would wait for one another, and its order of summation varies.
        sums = (
            (integrand(theta, k[:, None]) * weights).sum(axis=1) for integrand in (_force, _torque)
        )
        return (*sums, np.full(k.shape, 2.0 * theta.size))

    return run


def _trapezoid(count: int) -> tuple[Array, Array]:
    """Trapezoid rule, shifted by half a step: the ring as point supports."""
    return 2 * np.pi * (np.arange(count) + 0.5) / count, np.full(count, 1 / count)


@lru_cache
def _gauss_legendre(count: int) -> tuple[Array, Array]:
    """Gauss-Legendre rule on half the ring."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return np.pi * (nodes + 1) / 2, weights / 2


def _adaptive(k: Array, tolerance: float) -> tuple[Array, ...]:
    """`scipy.integrate.quad` on half the ring, one spin ratio at a time."""
    return tuple(np.array([_quad(float(ratio), tolerance) for ratio in k]).T)


def _quad(k: float, tolerance: float) -> tuple[float, float, float]:
    limits = {"epsabs": tolerance, "epsrel": tolerance, "limit": 200, "full_output": 1}
    force, torque = (
        quad(integrand, 0, math.pi, args=(k, math.cos, math.sqrt), **limits)
        for integrand in (_force, _torque)
    )
    return force[0] / math.pi, torque[0] / math.pi, force[2]["neval"] + torque[2]["neval"]


# --- Edges of motion cones, Eqs. (7) and (10)-(12) ------------------------------------------------------


def edges() -> tuple[Array, Array]:
    """Rod length and force angle of both edges of every cone, radians, shape (2 cones,)."""
    half = np.arctan(FRICTION_COEFFICIENTS)
    angles = np.concatenate([np.pi / 2 - half, np.pi / 2 + half])
    length, angle = np.meshgrid(ROD_LENGTHS, angles, indexing="ij")
    return length.ravel(), angle.ravel()


def cones() -> list[tuple[Array, Array]]:
    """Rod length and force angle of the right and the left edge of each cone."""
    shape = (ROD_LENGTHS.size, 2, FRICTION_COEFFICIENTS.size)
    length, angle = (np.moveaxis(part.reshape(shape), 1, 2).reshape(-1, 2) for part in edges())
    return list(zip(length, angle, strict=True))


def _closed_edges(length: Array, angle: Array, setting: float) -> tuple[Array, Array]:
    """Motion angles from the mechanics, whose inverse evaluates the ring's wrench once."""
    slider = Slider(rod_length=length, rod_angle=ROD_ANGLE)
    scene = Scene(slider=slider, contact=InfiniteFriction(), effects=(RingFriction(),))
    return motion_angle(scene, angle), np.ones(angle.shape)


def _through(inverse: Callable[[Array, float], tuple[Array, Array]]) -> Run:
    """Motion angles from the spin ratios of positive moment arms, by Eqs. (10)-(12) as in the paper."""

    def run(length: Array, angle: Array, setting: float) -> tuple[Array, Array]:
        from_force, arm = ROD_ANGLE - angle, _arms(length, angle)
        ratio, evaluations = inverse(np.abs(arm), setting)
        spin_length = np.copysign(ratio, arm) * length
        return angle - np.arctan2(
            spin_length * np.cos(from_force), 1 + spin_length * np.sin(from_force)
        ), evaluations

    return run


def _arms(length: Array, angle: Array) -> Array:
    """Moment arms, Eq. (10); near a tangent to the ring the rounding error of the subtraction matters."""
    from_force = ROD_ANGLE - angle
    back = from_force - ROD_ANGLE
    rounding = (ROD_ANGLE - (from_force - back)) - (angle + back)
    force = direction(angle)
    across = np.sin(ROD_ANGLE) * force[:, 0]
    return length * np.where(
        force[:, 1] == 0, across, np.sin(from_force) + rounding * np.cos(from_force)
    )


def _bracket_roots(arms: Array, tolerance: float) -> tuple[Array, Array]:
    """`brentq` on adaptive quadrature, one arm at a time; evaluations of the integrand."""
    limits = {"xtol": 1e-300, "rtol": max(tolerance, 4 * EPS)}
    evaluations = np.zeros(arms.shape)

    def excess(k: float, index: int) -> float:
        force, torque, count = _quad(k, tolerance)
        evaluations[index] += count
        return torque - float(arms[index]) * force

    # H(k) lies between k / 2 and 2 k; a coarse quadrature can shift these bounds.
    ratios = [brentq(excess, h / 2.2, h * 2.2, args=(i,), **limits) for i, h in enumerate(arms)]
    return np.array(ratios), evaluations


def _ellipsoid_ratios(arms: Array, setting: float) -> tuple[Array, Array]:
    """The spin ratios of the ellipsoid, which are its moment arms."""
    return arms, np.zeros(arms.shape)


# --- Motion over time -----------------------------------------------------------------------------------


@cache
def _problem(scene: str) -> tuple[Scene, dict[str, Any]]:
    """Scene and arguments of `simulate` for a log of the first and the last instant."""
    file = load_scene_file(SCENES[scene])
    if file.simulate is None:
        raise InvalidFile(f"{SCENES[scene]}: has no section simulate; add it")
    return file.build(), {**arguments(file.simulate), "samples": 2}


def _event_driven(scene: str, copies: int, tolerance: float) -> tuple[float, float]:
    """Last rod angle by `simulate`, or of equal runs by `simulate_batch`."""
    if copies == 1:
        return _simulate(scene, method=Integrator.EVENT_DRIVEN, rtol=tolerance)
    slider_scene, settings = _problem(scene)
    names = ("pusher", "duration", "twist", "on_ambiguity")
    options = {name: settings[name] for name in names} | {"gap": np.full(copies, settings["gap"])}
    runs = quietly(simulate_batch)(slider_scene, rtol=tolerance, **options)
    return float(runs.rod_angle[0]), float(runs.evaluations[0])


def run_of_no_duration(scene: str) -> object:
    """A run that ends as it begins: what is left of a call of `simulate` is its log."""
    return _simulate(scene, duration=INSTANT)


def _time_stepping(scene: str, copies: int, steps: float) -> tuple[float, float]:
    step = _problem(scene)[1]["duration"] / steps
    return _simulate(scene, method=Integrator.TIME_STEPPING, step=step)


def _simulate(scene: str, **options: Any) -> tuple[float, float]:
    slider_scene, settings = _problem(scene)
    log = quietly(simulate)(slider_scene, **{**settings, **options})
    return float(log.rod_angle[-1]), float(log.evaluations[-1].sum())


#: Methods by the quantity that they compute; ours comes first. A batch of formulas takes a measurable time,
#: and the integrands of a rule fit into a cache.
METHODS: dict[str, tuple[Method, ...]] = {
    "wrench": (
        Method("closed form", "nothing", FORMULA, _formula(ring_profile), 2**12),
        Method("hyp2f1", "nothing", FORMULA, _dual(_hypergeometric), 2**12),
        Method("Carlson", "nothing", FORMULA, _dual(_carlson), 2**12),
        Method("textbook E and K", "nothing", FORMULA, _dual(_textbook), 2**12),
        Method("trapezoid", "integrand", RULE_POINTS, _rule(_trapezoid), 2**15),
        Method("Gauss-Legendre", "integrand", NODES, _rule(_gauss_legendre), 2**15),
        Method("quad", "integrand", TOLERANCES, _adaptive),
        Method("ellipsoid", "nothing", FORMULA, _formula(_ellipsoid), 2**12),
    ),
    "cone": (
        Method("closed form", "wrench", FORMULA, _closed_edges, 2**5),
        Method("brentq on quad", "integrand", TOLERANCES, _through(_bracket_roots)),
        Method("ellipsoid", "nothing", FORMULA, _through(_ellipsoid_ratios), 2**5),
    ),
    "motion": (
        Method("event-driven", "motion", STEP_TOLERANCES, _event_driven, 100),
        Method("time-stepping", "motion", STEP_COUNTS, _time_stepping),
    ),
}
