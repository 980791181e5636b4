"""Declarations of the datasets and names of the result files; this module does not import xarray."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from planar_pushing.terms.errors import InvalidValue, suggestion
from planar_pushing.terms.options import EffectSet

#: Solutions of pushes, as `solve` returns them.
SOLUTIONS = (
    "solutions", "status", "outcome", "mode", "consistent", "force", "force_end", "twist",
    "contact_motion", "spin_ratio", "center", "pivot", "continuum",
)  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Dataset:
    """Declaration of a dataset that a study computes.

    Attributes
    ----------
    about : str
        Title, also used in the data dictionary.
    source : str
        Location of the topic in the paper.
    dims : tuple of str
        Axes of the study's grid that are dimensions of the dataset, in order; those of `inner` follow.
    inner : tuple of str
        Dimensions that are not on the grid.
    labels : tuple of str
        Further coordinates along these dimensions, by which a query can select, too.
    reads : tuple of str
        Further axes of the grid that the dataset depends on.
    variables : tuple of str
        Variables; their units and names are in `terms.quantities`.
    module : str
        Module of `study.datasets` that builds the dataset.
    effects : str, optional
        Effects that the grid must list.
    pushes : bool
        Whether the dataset holds only the force angles from 0 to 180 degrees.
    fine : bool
        Whether the study must list the dataset under `fine_grids`, which can give axes of its own.
    rod : bool
        Whether a dataset over supports also depends on the rod of the study's slider, and on its ring.
    section : bool
        Whether the dataset is computed from the study's section with its name, and not from the grid.
    certified : bool
        Whether golden data enclose its numbers; otherwise they are compared with stored ones.
    """

    about: str
    source: str
    dims: tuple[str, ...] = ()
    inner: tuple[str, ...] = ()
    labels: tuple[str, ...] = ()
    reads: tuple[str, ...] = ()
    variables: tuple[str, ...] = ()
    module: str
    effects: str | None = None
    pushes: bool = False
    fine: bool = False
    rod: bool = False
    section: bool = False
    certified: bool = True

    @property
    def axes(self) -> tuple[str, ...]:
        """Axes of the grid that the dataset depends on."""
        return (*self.dims, *self.reads)

    @property
    def selectors(self) -> tuple[str, ...]:
        """Axes and labels along them by which a query selects values."""
        dims = (dim for dim in (*self.dims, *self.inner) if dim not in NUMBERED)
        return (*dims, *self.labels)

    @property
    def needs(self) -> str:
        """Keys of the study from which the dataset is computed, in words; not for a section."""
        effects = f", and the effects {self.effects}" if self.effects else ""
        fine = ", and lists it under fine_grids" if self.fine else ""
        return f"{', '.join(AXIS_KEYS.get(axis, axis) for axis in self.axes)}{effects}{fine}"


#: Dimensions whose entries are numbered and have no values.
NUMBERED = ("solution", "rod", "push")
#: Keys of a study whose names differ from that of their axis.
AXIS_KEYS = {"support": "supports", "contact": "contact_friction_coefficient"}


#: The datasets of a study.
DATASETS: Mapping[str, Dataset] = {
    "limit_curves": Dataset(
        about="limit curves: forces through the contact, and the motions that they cause",
        source="Eqs. (2)-(7), Sec. 3, Fig. 5, and the ellipses of Sec. 4, Fig. 10",
        dims=("effects", "rod_length", "rod_angle", "force_angle"),
        variables=("force", "force_x", "force_y", "spin_ratio", "motion_angle"),
        module="limit_curves",
    ),
    "curves": Dataset(
        about="limit curves at fine force angles, for drawing; at the rod angle of the study",
        source="Eqs. (2)-(7), Sec. 3, Figs. 5 and 6, and the ellipses of Sec. 4, Fig. 10",
        dims=("effects", "rod_length", "force_angle"),
        variables=("force", "force_x", "force_y", "motion_angle"),
        module="limit_curves",
        fine=True,
    ),
    "motion_cones": Dataset(
        about="friction cones, and the motion cones to which they map",
        source="Secs. 3.1, 3.2 and 4, Figs. 6, 7 and 9",
        dims=("effects", "rod_length", "rod_angle", "friction_coefficient"),
        labels=("friction_angle",),
        variables=(
            "friction_cone_right", "friction_cone_left", "motion_cone_right", "motion_cone_left",
            "limit_force_right", "limit_force_left", "pulls", "slips_while_pushing",
        ),
        module="motion_cones",
    ),
    "contact_modes": Dataset(
        about="consistent solutions for each motion of the pusher: none, one or several",
        source="Secs. 2, 3.2, 4 and 5",
        dims=("effects", "contact", "rod_length", "pusher_magnitude", "pusher_angle"),
        inner=("solution", "xy", "twist_component"),
        labels=("friction_coefficient", "friction_angle", "law", "twist_unit"),
        variables=SOLUTIONS,
        module="contact_modes",
    ),
    "mode_maps": Dataset(
        about="sets of consistent contact modes over friction and the direction of the push",
        source="Secs. 2, 3.2, 4 and 5",
        dims=("effects", "contact", "rod_length", "pusher_magnitude", "pusher_angle"),
        labels=("friction_coefficient", "friction_angle", "law"),
        variables=("modes", "sticking_force_angle", "furthest_pull"),
        module="mode_maps",
        fine=True,
    ),
    "acceleration_centers": Dataset(
        about="acceleration centers and cones with support friction and inertia",
        source="Sec. 4, Fig. 12: the paper's conservative bound and the exact set",
        dims=("rod_length", "force_angle", "inertia_share"),
        variables=(
            "center_x", "center_y", "motion_angle", "conservative_cone_right",
            "conservative_cone_left", "exact_cone_right", "exact_cone_left",
        ),
        module="acceleration_centers",
        effects=EffectSet.BOTH,
        pushes=True,
    ),
    "center_regions": Dataset(
        about="regions of possible acceleration centers: the paper's bound and the exact set",
        source="Sec. 4, Fig. 12: the cases for a line of force outside, on and through the ring",
        dims=("rod_length", "rod_angle", "force_angle"),
        inner=("bound_end", "exact_end"),
        variables=("bound_x", "bound_y", "exact_x", "exact_y"),
        module="center_regions",
        effects=EffectSet.BOTH,
        pushes=True,
    ),
    "scenes": Dataset(
        about="the scenes of the figures, a group for each",
        source="Secs. 3 and 4",
        module="scenes",
        section=True,
    ),
    "model_errors": Dataset(
        about="what leaving out inertia or friction changes in pushes of a box, and what both cost",
        source="Secs. 3 and 4, over time",
        inner=("support", "push", "speed", "left_out"),
        labels=("place", "pusher_angle"),
        variables=("pose_error", "evaluations", "evaluations_alone", "coasting_error"),
        module="model_errors",
        section=True,
    ),
    "model_estimates": Dataset(
        about="estimates of what leaving out an effect changes, and what it does, in random pushes",
        source="Secs. 3 and 4, over time",
        inner=("push", "effect"),
        labels=("support", "speed", "is_at_corner"),
        variables=("pose_error", "estimate", "stopping_length", "force_share", "torque_share"),
        module="model_estimates",
        section=True,
        certified=False,
    ),
    "supports": Dataset(
        about="wrenches of each support over centers of rotation, and its ellipsoid",
        source="Sec. 3, Eqs. (1)-(3), for any pressure distribution",
        dims=("support", "center_x", "center_y"),
        inner=("twist_component", "wrench_component"),
        labels=("description", "twist_unit", "wrench_unit"),
        variables=(
            "mean_distance", "force_x", "force_y", "torque", "center_of_pressure_x",
            "center_of_pressure_y", "extent", "integration_constant", "ellipsoid",
            "worst_force_error", "mean_force_error", "worst_motion_error", "mean_motion_error",
        ),
        module="supports",
    ),
    "support_cones": Dataset(
        about="motion cones of each support, and the support points about which their edges pivot",
        source="Secs. 3.1 and 3.2, for any pressure distribution",
        dims=("support", "rod_length", "rod_angle", "friction_coefficient"),
        inner=("edge",),
        labels=("friction_angle",),
        variables=("motion_angle", "pivot", "width", "pulls", "slips_while_pushing"),
        module="support_motions",
    ),
    "support_modes": Dataset(
        about="consistent solutions of each support for each motion of the pusher",
        source="Secs. 2, 3.1 and 3.2, for any pressure distribution",
        dims=("support", "rod_length", "rod_angle", "friction_coefficient", "pusher_angle"),
        inner=("solution", "xy", "twist_component"),
        labels=("friction_angle", "twist_unit"),
        variables=SOLUTIONS,
        module="support_motions",
    ),
    "support_curves": Dataset(
        about="limit curves of each support and of the ring, and the support points of their pivots",
        source="Sec. 3, Fig. 5, for any pressure distribution",
        dims=("support", "force_angle"),
        variables=("force", "motion_angle", "pivot", "ring_force"),
        module="support_motions",
        fine=True,
        rod=True,
    ),
    "support_rods": Dataset(
        about="motion cones of infinite friction and friction that pulling needs, over rod lengths and "
        "over rod angles, of each support and of the ring",
        source="Secs. 3.1 and 3.2, for any pressure distribution",
        dims=("support",),
        inner=("rod", "edge"),
        labels=("sweep", "rod_length", "rod_angle"),
        reads=("rod_length", "rod_angle"),
        variables=(
            "motion_angle", "pulling_friction_angle", "ring_motion_angle",
            "ring_pulling_friction_angle", "inertia_pulling_friction_angle",
        ),
        module="support_motions",
        fine=True,
        rod=True,
    ),
}  # fmt: skip

#: Folder of the simulation logs.
SIMULATIONS = "simulations"
#: Paths of folders in the results that hold a file for each name.
FOLDERS = {SIMULATIONS: "data/simulations"}

#: Datasets about the computation itself, with their contents.
EVIDENCE = {
    "accuracy": "errors and evaluations of every method, a group for each quantity",
    "accuracy_time": "times of every method on one machine, a group for each quantity",
    "effects": "evaluations of each effect, by the listed effects",
    "hard_cases": "double-precision results for numerically hard cases and motions, against references",
}
#: Those that are compared with golden data, and those that depend on the machine: times.
COUNTS, TIMES = ("hard_cases", "accuracy", "effects"), ("accuracy_time",)
#: Names of the dataset files.
FILE_DATASETS = (*DATASETS, *EVIDENCE)
#: Groups of the datasets that are opened one group at a time; the study names the groups of `scenes`.
GROUPS = {
    "scenes": ("NAME",),
    "accuracy": ("cone", "motion", "wrench"),
    "accuracy_time": ("cone", "motion", "wrench"),
}

#: The result tables, with the contents of each file.
TABLES = {
    "golden_verdict.json": "comparison of every variable with the golden data",
    "golden_verdict.txt": "the same comparison as text, worst first",
    "golden_summary.csv": "summary of the comparison by dataset",
    "claims.json": "every claim of the ledger with its verdict, and its checks with argument and numbers",
    "claims.csv": "the claims as a table, one line for each check",
    "numbers.json": "the numbers of the report's prose, each with its unit and source",
    "figures.json": "captions and margins of the figures",
    "infinite_friction_cones.csv": "motion cones of infinite friction by rod length, degrees",
    "provenance.csv": "the study, the code, and the versions of the packages that computed the results",
    "accuracy.csv": "methods for wrench, cone and motion: setting, evaluations, largest error and time",
    "hard_places.csv": "hard cases by place, with their errors in units in the last place",
    "hard_ill.csv": "ill-conditioned cases: condition, digits left and error",
    "effects.csv": "evaluations of each effect in simulations",
}

#: Labels of the contact laws without a coefficient, which follow those of Coulomb along `contact`.
CONTACT_LAWS = ("infinite_friction_free", "infinite_friction_none", "perfectly_rough")
#: Pattern for the name of a file, a group or a study.
NAME = re.compile(r"[A-Za-z0-9_]+")


def dataset_place(name: str) -> tuple[str, str | None]:
    """File in the results that holds a dataset, and its group there.

    Parameters
    ----------
    name : str
        A dataset, "dataset/group", or a file of one of the folders, such as "simulations/slipping".

    Raises
    ------
    InvalidValue
        If there is no dataset with this name.
    """
    stem, slash, part = name.partition("/") if isinstance(name, str) else ("", "", "")
    valid_part = NAME.fullmatch(part) is not None
    if stem in FOLDERS and valid_part:
        return f"{FOLDERS[stem]}/{part}.nc", None
    if stem in FILE_DATASETS and (valid_part or not slash):
        return f"data/{stem}.nc", part or None
    remedy = suggestion(stem, FILE_DATASETS, "name one of these datasets")
    raise InvalidValue("name", name, ", ".join(dataset_names()), remedy)


def dataset_names() -> list[str]:
    """Names that `open_dataset` accepts; NAME is a placeholder for a name chosen by a study."""
    parts = [
        f"{stem}/{part}" if part else stem
        for stem in FILE_DATASETS
        for part in GROUPS.get(stem, ("",))
    ]
    return [*parts, *(f"{folder}/NAME" for folder in FOLDERS)]


def build_command(name: str) -> str:
    """How to build a missing dataset: the command, and what its study must give."""
    stem = name.partition("/")[0]
    if stem in EVIDENCE:
        return "build it with make, in the project's folder"
    entry = DATASETS.get(stem)
    needs = f"lists it under {stem}"
    if entry and stem not in GROUPS:
        needs = f"gives {entry.needs or stem}"
    ours = "sliders" if entry and "support" in entry.dims else "paper"
    run = f"build it with planar-pushing run, from a study that {needs}"
    return f"{run}; make builds it for the study {ours}"


def dataset_file(name: str) -> str:
    """File in the results that holds a dataset; errors as in `dataset_place`."""
    return dataset_place(name)[0]


def contact_labels(coefficients: Iterable[float]) -> list[str]:
    """Labels along the axis `contact`: a Coulomb law for each coefficient, then the other laws."""
    return [
        *(f"coulomb_{number_label(coefficient)}" for coefficient in coefficients),
        *CONTACT_LAWS,
    ]


def number_label(number: float) -> str:
    """Shortest text that identifies a double, such as 1.4, 2 or 1.4000001."""
    return repr(float(number)).removesuffix(".0")
