"""Optional dependencies and their extras, so that a missing one is named when it is needed."""

from __future__ import annotations

from importlib.util import find_spec

from planar_pushing.terms.errors import MissingExtra

#: Extras of the package, as named in `pip install`, and the modules that the package imports from each.
EXTRAS = {
    "workflow": ("snakemake",),
    "chunks": ("dask",),
    "cluster": ("snakemake_executor_plugin_slurm",),
    "figures": ("matplotlib", "PIL"),
    "report": ("typst", "PIL"),
    "golden": ("flint",),
    "explore": ("panel", "matplotlib", "PIL"),
    "mujoco": ("mujoco",),
    "manual": ("sphinx", "furo", "myst_nb", "numpydoc", "ipykernel"),
}


def pip_install(extras: str) -> str:
    """Command that installs extras from the project's folder: the package is in no index."""
    return f"pip install '.[{extras}]'"


def require_extra(extra: str) -> None:
    """Raise `MissingExtra` if a dependency of an extra is not installed, without importing any."""
    missing = [name for name in EXTRAS[extra] if find_spec(name) is None]
    if missing:
        raise MissingExtra(
            f"{', '.join(missing)}: not installed; install the extra {extra}: "
            f"{pip_install(extra)} in the project's folder"
        )
