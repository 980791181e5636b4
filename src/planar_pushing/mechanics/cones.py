"""From the friction cone to the motion cone (Secs. 3.1, 3.2 and 4)."""

from __future__ import annotations

from math import nan
from typing import Any, NamedTuple

import numpy as np

from planar_pushing.mechanics.angles import RESOLUTION, AngleInterval, interval
from planar_pushing.mechanics.compiled import compiled, kernel, owning
from planar_pushing.mechanics.contact import Status
from planar_pushing.mechanics.effects.base import count_fields, made
from planar_pushing.mechanics.held import require_held
from planar_pushing.mechanics.numerics.arrays import Output, evaluated, named
from planar_pushing.mechanics.plane import rod, seen
from planar_pushing.mechanics.reduced.magnitude import angles_under, direction_at, direction_under
from planar_pushing.mechanics.reduced.psi import contact_at
from planar_pushing.mechanics.scene import Scene, required_scene
from planar_pushing.mechanics.typed import of_force
from planar_pushing.terms.domain import Number, required
from planar_pushing.terms.errors import InvalidValue

CONE = (
    Output("motion_cone_right"), Output("motion_cone_left"), Output("closed", (), "?"),
    Output("status", (), "i1"),
)  # fmt: skip
CONSISTENT, PIVOTS, CONTINUUM = int(Status.CONSISTENT), int(Status.PIVOTS), int(Status.CONTINUUM)
UNSOLVED = int(Status.UNSOLVED)


class Sight(NamedTuple):
    """The rod and two directions, in the columns of a row after those of the effects."""

    length: float
    angle: float
    first: float
    second: float


def friction_cone(scene: Scene) -> AngleInterval:
    """Force angles that the scene's contact can transmit, radians.

    Returns
    -------
    AngleInterval
        For a labeled scene, which has a DataArray as a parameter, an xarray.Dataset with the variables
        `right`, `left` and `closed`.
    """
    law = required_scene(scene).law
    cone: AngleInterval = interval(law.right, law.left, law.closed)
    return cone


def unit_columns(scene: Scene, inertia_share: Number = 0.5) -> tuple[list[Number], list[Number]]:
    """Columns of the effects in units of their forces in a translation, and of the rod.

    If there are effects of degrees 1 and 2, those of degree 2 have the share `inertia_share` of the force.
    """
    require_held(scene)
    found: list[Any] = []
    entries = scene.from_rest
    degrees = {entry.degree for entry in entries}
    if not any(entry.degree == 1 and len(entry.forces) == 1 for entry in entries) and scene.loads:
        raise InvalidValue(
            "effects", scene.effects, "friction together with a load", "use solve: under a load without "
            "friction the motion depends on the magnitude of the force",
        )  # fmt: skip
    for degree in sorted(degrees, reverse=True):
        share = 1.0 if len(degrees) == 1 else inertia_share if degree == 2 else 1.0 - inertia_share
        unit = sum(
            entry.forces[0]
            for entry in entries
            if entry.degree == degree and len(entry.forces) == 1
        )
        for i, entry in enumerate(entries):
            if entry.degree == degree:
                forces = [share * each / unit for each in entry.forces]
                found.append((i, [*forces, *entry.others]))
    columns = [each for _, numbers in sorted(found, key=lambda pair: pair[0]) for each in numbers]
    slider = scene.slider
    return columns, [slider.length_ratio, slider.rod_angle]


def force_columns(
    scene: Scene, force_angle: Number, inertia_share: Number | None, force_ratio: Number | None
) -> list[Number]:
    """The columns of a scene under a force; its |f| / W is 0 if an inertia share is given."""
    share, ratio = _required_magnitude(scene, inertia_share, force_ratio)
    columns, rod_columns = unit_columns(scene, share)
    return [*columns, *rod_columns, required("force_angle", force_angle), ratio]


def _required_magnitude(
    scene: Scene, share: Number | None, ratio: Number | None
) -> tuple[Number, Number]:
    """Inertia share and |f| / W, if the motion depends on the magnitude of the force."""
    open_, given = is_magnitude_open(required_scene(scene)), (share, ratio)
    name = "inertia_share" if ratio is None else "force_ratio"
    if not open_ and given != (None, None):
        raise InvalidValue(
            name, share if ratio is None else ratio, "None for a scene whose effects are of one kind",
            "leave the argument out",
        )  # fmt: skip
    if not open_:
        return 0.5, 0.0
    if share is not None and not scene.isotropic:
        raise InvalidValue(
            "inertia_share", share, "None if the effects are not isotropic about the slider's center",
            "give force_ratio = |f| / W: several motions can share one m a / W",
        )  # fmt: skip
    if (share is None) == (ratio is None):
        raise InvalidValue(
            "inertia_share", share, "numbers in [0, 1] for a scene with friction and inertia",
            "give s / (1 + s) with s = m a / W, or force_ratio = |f| / W; motion_cone and solve need none",
        )  # fmt: skip
    return (
        (required("inertia_share", share), 0.0)
        if ratio is None
        else (0.5, required("force_ratio", ratio))
    )


def is_magnitude_open(scene: Scene) -> bool:
    """Whether the direction of a motion depends on its magnitude."""
    return len({entry.degree for entry in scene.from_rest}) > 1


@compiled
def direction_in(effects, own, at, force, ratio):
    """Direction of the motion under a force; a nonzero ratio is its |f| / W."""
    # With shares of one half, the unit of force is half the weight.
    return (
        direction_under(effects, own, at, force)
        if ratio == 0.0
        else direction_at(effects, at, force, ratio / 2)
    )


@compiled
def sight_in(row, i):
    """The rod and the directions in the columns of a row, starting at i."""
    return Sight(row[i], row[i + 1], row[i + 2], row[i + 3])


@owning
def under_force(kinds, row):
    """Effects, rod, contact, force along the first direction of a row, and the row's last number."""
    sight = sight_in(row, count_fields(kinds))
    own = rod(sight.length, sight.angle)
    at = contact_at(-sight.length, 0.0)
    return made(kinds, row, 0), own, at, seen(own, sight.first), sight.second


@kernel
@owning
def _spin_ratios(kinds, rows, ratios):
    for i in range(len(rows)):
        effects, own, at, force, ratio = under_force(kinds, rows[i])
        found = direction_in(effects, own, at, force, ratio)
        ratios[i] = found.ratio if found.found else nan


@kernel
@owning
def _motion_angles(kinds, rows, angles):
    for i in range(len(rows)):
        effects, own, at, force, ratio = under_force(kinds, rows[i])
        found = direction_in(effects, own, at, force, ratio)
        angles[i] = found.angle if found.found else nan


@of_force
def spin_ratio(
    scene: Scene,
    force_angle: Number,
    inertia_share: Number | None = None,
    force_ratio: Number | None = None,
) -> Number:
    """Spin ratio k = R omega / v for each force angle.

    Parameters
    ----------
    scene : Scene
    force_angle : float or array
        phi, radians.
    inertia_share : float or array, optional
        s / (1 + s) in [0, 1], with s = m a / W and a the acceleration of the slider's center. Only for a
        scene with friction and inertia that is isotropic about that center: in others it does not determine
        the motion.
    force_ratio : float or array, optional
        |f| / W > 0, for any scene with effects of both degrees; the result is NaN if friction holds the
        slider under this force.

    Returns
    -------
    float, ndarray or DataArray
        Of the type of the arguments; an array for an array of scenes, a DataArray for a labeled scene.

    Raises
    ------
    InvalidValue
        If `inertia_share` is missing, superfluous or out of range, or an angle is beyond 4 pi.

    Notes
    -----
    Solves Eq. (7) for friction, Eq. (10) for inertia, and with both
    ``h / R = (t(k) + s (rho/R)^2 k) / (f(k) + s)``.
    """
    columns = force_columns(scene, force_angle, inertia_share, force_ratio)
    return evaluated(_spin_ratios, scene.kinds, columns, [Output("spin_ratio")])[0]


@of_force
def motion_angle(
    scene: Scene,
    force_angle: Number,
    inertia_share: Number | None = None,
    force_ratio: Number | None = None,
) -> Number:
    """Angle of the contact's motion for each force angle, radians, unwrapped and increasing.

    Parameters
    ----------
    scene : Scene
    force_angle : float or array
        phi, radians.
    inertia_share, force_ratio : float or array, optional
        As in `spin_ratio`, which has the same errors and equations.

    Returns
    -------
    float, ndarray or DataArray
        Of the type of the arguments; an array for an array of scenes, a DataArray for a labeled scene.
    """
    columns = force_columns(scene, force_angle, inertia_share, force_ratio)
    return evaluated(_motion_angles, scene.kinds, columns, [Output("motion_angle")])[0]


@kernel
@owning
def _motion_cones(kinds, rows, right, left, closed, status):
    for i in range(len(rows)):
        effects, own, at, first, left_edge = under_force(kinds, rows[i])
        second = seen(own, left_edge)
        low, high = angles_under(effects, own, at, first), angles_under(effects, own, at, second)
        # Rounding can swap the edges of a long rod's cone, which can be narrower than an ulp.
        right[i], left[i] = min(low.least, high.greatest), high.greatest
        spread = max(low.greatest - low.least, high.greatest - high.least)
        closed[i] = low.continuum or high.continuum or spread <= RESOLUTION
        status[i] = CONSISTENT
        if low.pivots or high.pivots:
            status[i] = PIVOTS
        if low.continuum or high.continuum:
            status[i] = CONTINUUM
        if not (low.found and high.found):
            right[i], left[i], closed[i], status[i] = nan, nan, False, UNSOLVED


def motion_cone(scene: Scene) -> AngleInterval:
    """Motion cone: directions in which the contact can move without slip, radians.

    It is the velocity cone of a scene with friction, the acceleration cone of a scene with inertia, and
    with both effects the exact union over all magnitudes of the motion. The motion angle increases with the
    force angle, so the edges correspond to those of the friction cone. With both effects, an edge at which
    they differ is approached but never reached: the cone is open. The type of the result is that of
    `friction_cone`.
    """
    law = required_scene(scene).law
    columns, rod_columns = unit_columns(scene)
    given = [*columns, *rod_columns, law.right, law.left]
    right, left, reached, status = evaluated(_motion_cones, scene.kinds, given, CONE)
    cone: AngleInterval = interval(right, left, law.closed & reached, status)
    return cone


def leaves_the_fence(cone: AngleInterval) -> Any:
    """Whether a motion cone contains motions away from the slider (Sec. 3.1)."""
    return (cone.right < -RESOLUTION) | (cone.left > np.pi + RESOLUTION)


def can_pull(scene: Scene) -> bool:
    """Whether the contact can stick while the pusher moves away from the slider (Sec. 3.1).

    Returns
    -------
    bool
        An array for an array of scenes, a DataArray for a labeled scene.
    """
    pulls: bool = named("pulls", leaves_the_fence(motion_cone(scene)))
    return pulls


def omits_pushes(cone: AngleInterval) -> Any:
    """Whether a motion cone excludes some motions into the slider (Sec. 3.2)."""
    return (cone.right > RESOLUTION) | (cone.left < np.pi - RESOLUTION)


def slips_while_pushing(scene: Scene) -> bool:
    """Whether some pusher motion into the slider makes the contact slip (Sec. 3.2).

    Returns
    -------
    bool
        An array for an array of scenes, a DataArray for a labeled scene.
    """
    omits = omits_pushes(motion_cone(scene))
    slips: bool = named("slips_while_pushing", scene.law.slips & omits)
    return slips
