"""Datasets of the paper's study, which the package `pulling_by_pushing` opens."""

from __future__ import annotations

from importlib.metadata import entry_points
from typing import TYPE_CHECKING, cast

from planar_pushing.terms.errors import MissingExtra
from planar_pushing.terms.replacing import PathLike

if TYPE_CHECKING:
    import xarray as xr

#: Group of the entry points that open datasets.
GROUP = "planar_pushing.datasets"


def open_dataset(
    name: str, results: PathLike = "results", *, study: str | None = None
) -> xr.Dataset:
    """Open a dataset of a study by name.

    Parameters
    ----------
    name : str
        One of limit_curves, curves, motion_cones, contact_modes, mode_maps, acceleration_centers and
        center_regions; a scene such as "scenes/figure_08"; a simulation such as "simulations/slipping";
        or a dataset about the computation itself, such as "accuracy/cone". A study with supports also has
        supports, support_curves, support_cones, support_rods and support_modes. `planar-pushing query`
        lists the datasets that are built.
    results : path
        Results folder of the pipeline.
    study : str, optional
        Name of a study other than the paper's, whose results are in studies/NAME in that folder.

    Returns
    -------
    xarray.Dataset
        Dataset in memory, or read on demand if it is above 64 MB or stored in chunks; angles are in
        degrees.

    Raises
    ------
    InvalidValue
        If there is no dataset or no study with this name.
    InvalidFile
        If the folder is not a results folder, or the dataset has not been built; the message says which
        command builds it.
    """
    openers = entry_points(group=GROUP, name="open_dataset")
    if not openers:
        raise MissingExtra(
            "open_dataset needs the package pulling_by_pushing; reinstall planar-pushing"
        )
    return cast("xr.Dataset", openers["open_dataset"].load()(name, results, study=study))
