"""Measurements on published pushes: `paper/measured_pushes.json`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.combine import of_object
from planar_pushing.pushes.compare import compare, feet_of
from planar_pushing.pushes.identified import Identified, moments_of
from planar_pushing.pushes.identify import identify
from planar_pushing.pushes.measured import Measured, measured
from planar_pushing.pushes.mit import read_mit
from planar_pushing.pushes.statistics import statistics
from planar_pushing.pushes.three_feet import read_three_feet
from planar_pushing.terms.errors import InvalidValue

#: Folders and endings of the logs.
FOLDERS = {"three_feet": "*.txt", "polygons": "*.mat"}
#: What the numbers are of.
SOURCES = {
    "three_feet": "J. Zhou, R. Paolini, J. A. Bagnell and M. T. Mason, ICRA 2016",
    "polygons": "K.-T. Yu, M. Bauza, N. Fazeli and A. Rodriguez, IROS 2016; as filtered by J. Zhou, Y. Hou and "
    "M. T. Mason",
}  # fmt: skip
COMMAND = "snakemake pushes --config data=FOLDER"
#: Distance of the center of rotation from a foot, mm, of pushes about that foot.
ABOUT = 5.0
#: Distance of a wrench from the load set of a foot, as a fraction of its own size, that counts as in the set.
NEAR = 0.15
#: Significant digits of the numbers.
DIGITS = 4


def measure(folder: Any, seed: int = 0, progress: bool = False) -> dict[str, Any]:
    """Identify supports and compare models on the published logs of a folder.

    Parameters
    ----------
    folder : path
        With `three_feet/*.txt` and `polygons/*.mat`, one of them at least.
    seed : int
        Of the halves and of the draws.
    progress : bool
        Whether to show progress bars.

    Returns
    -------
    dict
        Of numbers, texts and lists, as JSON has them.

    Raises
    ------
    InvalidValue
        Where the folder holds no logs.
    InvalidFile
        Where a log cannot be read.
    """
    files = {name: sorted(Path(folder, name).glob(ending)) for name, ending in FOLDERS.items()}
    if not any(files.values()):
        raise InvalidValue(
            "data", str(folder), "a folder with three_feet/*.txt or polygons/*.mat",
            "give the folder of the published logs",
        )  # fmt: skip
    found: dict[str, Any] = {"command": COMMAND, "seed": seed, "source": SOURCES}
    if files["three_feet"]:
        pushes = read_three_feet(*files["three_feet"])
        footed = np.array([feet_of(of_object(pushes, name)) is not None for name in _names(pushes)])
        for key, chosen in (("three_feet", footed), ("patch", ~footed)):
            names = [name for name, own in zip(_names(pushes), chosen, strict=True) if own]
            if names:
                found[key] = _with_forces(_of_objects(pushes, names), seed, progress)
        if footed.any():
            found["about_a_foot"] = _about_a_foot(pushes)
    if files["polygons"]:
        found["polygons"] = _by_poses(read_mit(*files["polygons"]), seed, progress)
    rounded: dict[str, Any] = _rounded(found)
    return rounded
