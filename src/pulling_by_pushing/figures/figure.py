"""Each figure is a view of datasets: a declaration, a drawing and a caption, found by the figure's name.

A module such as `paper.figure_05` defines `FIGURE`, `draw(figure, data)` and `caption(data)`. Its data are
the datasets that it reads, cut at the values that the study gives. A module of `SEVERAL` holds figures
of one kind, as entries of its table `FIGURES`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from planar_pushing.terms.errors import require_name

if TYPE_CHECKING:
    import xarray as xr

    from planar_pushing.terms.replacing import PathLike

STATICS = "Sec. 3: quasi-static pushing and pulling"
DYNAMICS = "Sec. 4: dynamic pushing and pulling"
FRICTION, INERTIA, BOTH = "support_friction", "inertia", "support_friction+inertia"
#: Folders of the figures, and the modules with several figures.
FOLDERS, SEVERAL = ("paper", "sliders", "evidence"), ("paper.schematics", "paper.mappings")
#: Datasets by the names under which a figure reads them.
Data = Mapping[str, "xr.Dataset"]
#: Values of axes: one value, several in a list, or None for the whole axis; under the name of a dataset,
#: those of this dataset alone.
Cuts = Mapping[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """Declaration of a figure.

    Attributes
    ----------
    title : str
        Subject of the figure in a few words.
    reads : tuple of str
        Datasets that it shows, as "dataset" or "dataset/group", or a JSON file of the project.
    size : tuple of float
        Width and height, inches.
    takes : tuple of str
        Axes at which its entry in the study cuts the datasets.
    cuts : mapping
        Values of further axes at which it cuts them, in the form of `Cuts`.
    section : str
        Section of the paper to which it belongs.
    promise : str
        Content announced by the paper's caption, in our words; empty for a figure that is not in the
        paper.
    """

    title: str
    reads: tuple[str, ...]
    size: tuple[float, float]
    takes: tuple[str, ...] = ()
    cuts: Cuts = field(default_factory=dict)
    section: str = ""
    promise: str = ""


class Drawing(NamedTuple):
    """A figure, the function that draws it, and the one that writes its caption."""

    figure: Figure
    draw: Callable[[Any, Any], None]
    caption: Callable[[Any], str]


#: Module and fields of each figure, by its name. The workflow fills it with `declarations` of an earlier
#: run, because the modules import what draws.
DECLARED: dict[str, tuple[str, dict[str, Any]]] = {}


def modules() -> list[str]:
    """Modules with figures, within the package of figures."""
    folders = (Path(__file__).parent / folder for folder in FOLDERS)
    return sorted(f"{path.parent.name}.{path.stem}" for f in folders for path in f.glob("[!_]*.py"))


def module_names() -> dict[str, str]:
    """Module that contains each figure, by the name of the figure."""
    if DECLARED:
        return {name: module for name, (module, _) in DECLARED.items()}
    several = {name: module for module in SEVERAL for name in _load(module).FIGURES}
    return dict(sorted((_single_names() | several).items()))


def _single_names() -> dict[str, str]:
    """Modules with one figure each, by the name of the figure, without importing them."""
    return {name.rpartition(".")[2]: name for name in modules() if name not in SEVERAL}


def declarations() -> dict[str, tuple[str, dict[str, Any]]]:
    """Module and fields of each figure as plain values, by the name of the figure."""
    return {name: (module, asdict(entry(name))) for name, module in module_names().items()}


def _load(module: str) -> Any:
    return import_module(f"pulling_by_pushing.figures.{module}")


def figure_names() -> list[str]:
    """Names of all figures."""
    return list(module_names())


def module_name(name: str) -> str:
    """Module that contains a figure, such as "paper.figure_05" for "figure_05".

    Raises
    ------
    InvalidValue
        If there is no figure of this name.
    """
    names = _single_names()
    if name not in names:
        names = module_names()
    return names[require_name("figure", name, names, "name one of these figures")]


def drawing(name: str) -> Drawing:
    """Figure with its functions, such as "figure_08"; errors as in `module_name`."""
    module = _load(module_name(name))
    if hasattr(module, "FIGURES"):
        figure_drawing: Drawing = module.FIGURES[name]
        return figure_drawing
    return Drawing(module.FIGURE, module.draw, module.caption)


def entry(name: str) -> Figure:
    """Declaration of a figure; errors as in `module_name`."""
    return Figure(**DECLARED[name][1]) if name in DECLARED else drawing(name).figure


def files(name: str, results: PathLike) -> list[str]:
    """Files that a figure reads, of a study with this results folder; errors as in `module_name`."""
    from pulling_by_pushing.study.catalog import dataset_file

    return sorted(
        {
            source if _is_file(source) else f"{results}/{dataset_file(source)}"
            for source in entry(name).reads
        }
    )


def view(
    name: str, results: PathLike, cuts: Cuts | None = None, read: Callable[..., Any] | None = None
) -> Any:
    """Datasets of a figure, cut at the values of the study; of a file of the project, its content.

    Parameters
    ----------
    name : str
        The figure; errors as in `module_name`.
    results : path
        Results folder of the study.
    cuts : mapping, optional
        Values that the study gives, from `studies.cuts`.
    read : callable, optional
        Function of the name of a dataset and the results folder that reads it; by default
        `store.open_dataset`. A caller with several figures can read each dataset once.

    Returns
    -------
    mapping of str to xarray.Dataset
        By the names in `reads`. An axis that is cut at one value remains as a scalar coordinate.
    """
    from pulling_by_pushing.figures.measured import read_pushes
    from pulling_by_pushing.study.store import open_dataset

    figure = entry(name)
    if any(map(_is_file, figure.reads)):
        return read_pushes(figure.reads[0])
    read = read or open_dataset
    return {source: select_values(read(source, results), cuts_of(figure, source, cuts or {}))
            for source in figure.reads}  # fmt: skip


def cuts_of(figure: Figure, source: str, cuts: Cuts) -> Cuts:
    """Values at which one dataset of a figure is cut: those of the study, and the figure's own."""
    selections = [
        {axis: value for axis, value in axis_values.items() if not isinstance(value, Mapping)}
        | dict(axis_values.get(source, {}))
        for axis_values in (cuts, figure.cuts)
    ]
    return {
        axis: value for axis, value in (selections[0] | selections[1]).items() if value is not None
    }


def select_values(dataset: xr.Dataset, values: Cuts) -> xr.Dataset:
    """Part of a dataset at one or several values of the axes that it has."""
    return dataset.sel(
        {
            axis: list(value) if isinstance(value, (list, tuple)) else value
            for axis, value in values.items()
            if axis in dataset.dims
        }
    )


def _is_file(source: str) -> bool:
    return source.endswith(".json")


def full_caption(name: str, data: Any) -> str:
    """Caption as printed; a reconstruction names its figure in the paper; errors as in `module_name`."""
    figure_drawing = drawing(name)
    if not figure_drawing.figure.promise:
        return figure_drawing.caption(data)
    number = int(name.removeprefix("figure_"))
    return f"{figure_drawing.caption(data)} After Fig. {number} of Lynch and Mason."
