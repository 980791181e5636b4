"""Errors of fits to parts of pushes, kept by digests of the pushes, the options and the code."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path

import numpy as np
import xarray as xr

from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.halves import Apply, Task, process_pool
from planar_pushing.terms.replacing import replacing
from pulling_by_pushing.study.running.code import code_of

#: Folder of the errors of each fit.
FOLDER = Path(".snakemake/folds")
#: Module whose imports are the code of the fits.
MODULE = "evidence.folds"


@contextmanager
def kept_map(processes: int, folder: Path = FOLDER) -> Iterator[Apply]:
    """Function like `map` for the tasks of `compare` that computes errors which are not in a folder."""
    code = code_of(MODULE)
    folder.mkdir(parents=True, exist_ok=True)
    with process_pool(processes) as pool:

        def apply(function: Callable[[Task], Array], tasks: Iterable[Task]) -> Iterable[Array]:
            return pool.map(partial(kept_errors, function, folder, code), tasks)

        yield apply


def kept_errors(function: Callable[[Task], Array], folder: Path, code: str, task: Task) -> Array:
    """Errors of a task from a folder, or computed and kept there."""
    file = folder / f"{task_digest(task, code)}.npy"
    if file.is_file():
        return np.asarray(np.load(file))
    errors = function(task)
    with replacing(file) as temporary, temporary.open("wb") as stream:
        np.save(stream, errors)
    return errors


def task_digest(task: Task, code: str) -> str:
    """Digest of the pushes, rows, models and options of a task, and of the code."""
    digest = hashlib.sha256(code.encode())
    digest.update(repr((list(task.fits), sorted(task.options.items()))).encode())
    for rows in task.fold:
        digest.update(np.asarray(rows, dtype=np.int64).tobytes() + b"\0")
    for entry in _entries(task.pushes):
        digest.update(entry + b"\0")
    return digest.hexdigest()


def _entries(pushes: xr.Dataset) -> Iterator[bytes]:
    """Names, dimensions, attributes and values of a dataset."""
    yield repr(sorted(pushes.attrs.items())).encode()
    for name, variable in sorted(pushes.variables.items(), key=lambda entry: str(entry[0])):
        yield repr((name, variable.dims, variable.shape)).encode()
        values = variable.values
        yield repr(values.tolist()).encode() if values.dtype == object else values.tobytes()
