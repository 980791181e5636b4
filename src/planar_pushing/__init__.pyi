"""Planar pushing: pulling by pushing, slip with infinite friction, and the mechanics behind them."""

from .assessment.assess_push import assess_push
from .assessment.result import PushAssessment
from .datasets import open_dataset
from .drawing.animate import animate
from .drawing.comparison import plot_comparison
from .drawing.draw import draw, draw_contacts, plot_log
from .drawing.stable_centers import plot_stable_centers
from .mechanics.angles import AngleInterval
from .mechanics.contact import (
    ContactMode,
    Coulomb,
    InfiniteFriction,
    Outcome,
    PerfectlyRough,
    Status,
)
from .mechanics.effects import (
    Inertia,
    Load,
    RingFriction,
    SupportFriction,
    Viscous,
    weight,
)
from .mechanics.force.centers import (
    conservative_motion_cone,
    motion_centers,
)
from .mechanics.force.cones import (
    can_pull,
    friction_cone,
    motion_angle,
    motion_cone,
    slips_while_pushing,
    spin_ratio,
)
from .mechanics.force.derivatives import Derivatives, ForceDerivatives, Smoothness
from .mechanics.force.force_motion import ForceMotion, motion_of_force
from .mechanics.force.limit_curve import LimitCurve, limit_curve
from .mechanics.force.wrench import potential, wrench
from .mechanics.outline.outline import Outline, rounded
from .mechanics.plane import Placement
from .mechanics.scene import Scene
from .mechanics.slider import Slider
from .mechanics.solution_arrays import SolutionArrays
from .mechanics.solutions import Solution, Solutions
from .mechanics.solve import solve
from .mechanics.supports import (
    Annulus,
    Composite,
    Disc,
    EllipsoidFit,
    Points,
    Polygon,
    PressureMap,
    Ring,
    Segment,
    fit_ellipsoid,
)
from .objects.first_touch import Touch, first_touch
from .objects.inverse import Push, pushes_for
from .objects.mjcf import to_mjcf
from .objects.scene_at import scene_at
from .objects.several.contact import Contact
from .objects.several.simulate_contacts import simulate_contacts
from .objects.several.solutions import (
    ContactsSolution,
    ContactsSolutionArrays,
    ContactsSolutions,
)
from .objects.several.solve_contacts import solve_contacts
from .objects.wrench_set import WrenchSet, wrench_set
from .pushes.compare import compare
from .pushes.files import load_pushes, save_pushes
from .pushes.formats.mit import read_mit
from .pushes.formats.three_feet import read_three_feet
from .pushes.identified import Identified
from .pushes.identify import identify
from .pushes.logs.combine import concat_pushes
from .pushes.logs.poses import pushes_from_poses
from .pushes.simulated import simulate_pushes
from .scenes.files import load_scene, save_scene
from .simulation.batch import simulate_batch
from .simulation.log import to_pandas
from .simulation.pusher import Pusher
from .simulation.simulate import simulate
from .simulation.until import Until
from .simulation.walls import Wall
from .stability.any_pressure import AnyPressure, any_pressure
from .stability.stable import stable
from .stability.stable_centers import StableCenters, StableCurve, stable_centers
from .stability.stable_for_any_pressure import stable_for_any_pressure
from .terms.errors import (
    EarlyEndWarning,
    InvalidCall,
    InvalidFile,
    InvalidValue,
    PlainCoreWarning,
    PlanarPushingError,
    SceneWarning,
)
from .terms.options import Event, Reason, Sense, StableBound
from .terms.units import Units

__version__: str

__all__ = [
    "AngleInterval",
    "Annulus",
    "AnyPressure",
    "Composite",
    "Contact",
    "ContactMode",
    "ContactsSolution",
    "ContactsSolutionArrays",
    "ContactsSolutions",
    "Coulomb",
    "Derivatives",
    "Disc",
    "EarlyEndWarning",
    "EllipsoidFit",
    "Event",
    "ForceDerivatives",
    "ForceMotion",
    "Identified",
    "Inertia",
    "InfiniteFriction",
    "InvalidCall",
    "InvalidFile",
    "InvalidValue",
    "LimitCurve",
    "Load",
    "Outcome",
    "Outline",
    "PerfectlyRough",
    "Placement",
    "PlainCoreWarning",
    "PlanarPushingError",
    "Points",
    "Polygon",
    "PressureMap",
    "Push",
    "PushAssessment",
    "Pusher",
    "Reason",
    "Ring",
    "RingFriction",
    "Scene",
    "SceneWarning",
    "Segment",
    "Sense",
    "Slider",
    "Smoothness",
    "Solution",
    "SolutionArrays",
    "Solutions",
    "StableBound",
    "StableCenters",
    "StableCurve",
    "Status",
    "SupportFriction",
    "Touch",
    "Units",
    "Until",
    "Viscous",
    "Wall",
    "WrenchSet",
    "animate",
    "any_pressure",
    "assess_push",
    "can_pull",
    "compare",
    "concat_pushes",
    "conservative_motion_cone",
    "draw",
    "draw_contacts",
    "first_touch",
    "fit_ellipsoid",
    "friction_cone",
    "identify",
    "limit_curve",
    "load_pushes",
    "load_scene",
    "motion_angle",
    "motion_centers",
    "motion_cone",
    "motion_of_force",
    "open_dataset",
    "plot_comparison",
    "plot_log",
    "plot_stable_centers",
    "potential",
    "pushes_for",
    "pushes_from_poses",
    "read_mit",
    "read_three_feet",
    "rounded",
    "save_pushes",
    "save_scene",
    "scene_at",
    "simulate",
    "simulate_batch",
    "simulate_contacts",
    "simulate_pushes",
    "slips_while_pushing",
    "solve",
    "solve_contacts",
    "spin_ratio",
    "stable",
    "stable_centers",
    "stable_for_any_pressure",
    "to_mjcf",
    "to_pandas",
    "weight",
    "wrench",
    "wrench_set",
]
