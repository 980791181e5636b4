"""Divide the pushes of objects into halves, and score models on the half to which they are not fitted."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import active_children, get_context
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from planar_pushing.mechanics.kernels.arrays import CORES
from planar_pushing.mechanics.plane import Array
from planar_pushing.pushes.fit.scores import QUANTITIES
from planar_pushing.pushes.logs.arguments import whole_number
from planar_pushing.pushes.logs.measured import Index, Mask, Measured, measurements_of
from planar_pushing.pushes.models import Fit, Half, errors_of
from planar_pushing.simulation.runs import progress_bar

#: Smallest number of different pushes to which a half of resampled pushes fits models.
FEWEST = 4
#: Kinds of divided pushes: all of them, or as many drawn with replacement.
PLAIN, RESAMPLED = 0, 1
#: Calls a function for each of some arguments, in order.
Apply = Callable[[Callable[..., Any], Iterable[Any]], Iterable[Any]]


class Fold(NamedTuple):
    """Rows of an object's pushes to which models are fitted, with repetition, and that are scored."""

    fit: Index
    score: Index


class Task(NamedTuple):
    """Models to fit to some pushes of an object and to score on others; it can be sent to a process."""

    pushes: xr.Dataset
    fold: Fold
    fits: Mapping[str, Fit]
    options: Mapping[str, Any]


def score_fold(task: Task) -> Array:
    """Errors of models on the scored pushes, shape (3, models, pushes); NaN if one does not apply."""
    every, (fit, score) = measurements_of(task.pushes), task.fold
    half = Half(task.pushes.isel(push=fit), every.part(fit), dict(task.options))
    scored = every.part(score)
    errors = np.full((len(QUANTITIES), len(task.fits), len(score)), np.nan)
    for k, fit_model in enumerate(task.fits.values()):
        fitted = fit_model(half)
        if fitted is not None:
            errors[:, k] = errors_of(*fitted, scored)
    return errors


class Job(NamedTuple):
    """A task, the kind and the number of its split, and the rows of the object's pushes among all."""

    kind: int
    split: int
    rows: Index
    task: Task


def usable_for_fits(pushes: Measured) -> Mask:
    """Pushes to which a model can be fitted: with forces, or at a side."""
    return np.asarray(pushes.has_force | ~pushes.at_corner)


def divisions(
    pushes: Measured, number: int, splits: int, seed: int
) -> Iterator[tuple[int, int, Fold]]:
    """Kind, number of the split, and fold of all fits to an object; a single split has no resamples.

    Parameters
    ----------
    pushes : Measured
        Pushes of one object.
    number : int
        Number of the object; its resamples are independent of those of other objects.
    splits, seed : int
    """
    kinds = [divide(len(pushes), splits, seed)]
    if splits > 1:
        kinds.append(divide_resamples(usable_for_fits(pushes), splits, [seed, RESAMPLED, number]))
    for kind, pairs in enumerate(kinds):
        for split, folds in enumerate(pairs):
            for fold in folds:
                yield kind, split, fold


def divide(count: int, splits: int, seed: int) -> list[tuple[Fold, Fold]]:
    """Random divisions of pushes into halves; each half is fitted once and scored once."""
    generator = np.random.default_rng(seed)
    return [_folds(generator.permutation(count)) for _ in range(splits)]


def divide_resamples(usable: Mask, splits: int, seed: list[int]) -> list[tuple[Fold, Fold]]:
    """Random divisions of pushes that are drawn with replacement.

    The different pushes that were drawn are divided, so that no push is in both halves; a fit counts each
    as often as it was drawn. Draws with fewer than four different usable pushes in a half are repeated.
    """
    generator = np.random.default_rng(seed)
    return [_divide_resample(usable, generator) for _ in range(splits)]


def _divide_resample(usable: Mask, generator: np.random.Generator) -> tuple[Fold, Fold]:
    while True:
        counts = np.bincount(
            generator.integers(len(usable), size=len(usable)), minlength=len(usable)
        )
        folds = _folds(generator.permutation(np.flatnonzero(counts)))
        if all(np.count_nonzero(usable[fold.fit]) >= FEWEST for fold in folds):
            break
    one, other = (Fold(np.repeat(fold.fit, counts[fold.fit]), fold.score) for fold in folds)
    return one, other


def _folds(order: Index) -> tuple[Fold, Fold]:
    one, other = (np.sort(half) for half in np.array_split(order, 2))
    return Fold(one, other), Fold(other, one)


def score_jobs(
    jobs: list[Job], shape: tuple[int, ...], workers: Any, progress: bool
) -> tuple[Array, Index]:
    """Errors of each kind and split, and how often each push was drawn.

    Parameters
    ----------
    jobs : list of Job
    shape : tuple of int
        Numbers of splits, quantities, models, and pushes.
    workers : int or callable
        Number of processes, or a function like `map`.
    progress : bool

    Returns
    -------
    errors : ndarray, shape (2, *shape)
    counts : ndarray of int, shape (2, splits, pushes)
    """
    errors, counts = np.full((2, *shape), np.nan), np.zeros((2, shape[0], shape[-1]), dtype=int)
    with _mapping(workers) as apply, progress_bar(len(jobs), "half", progress) as bar:
        results = apply(score_fold, [job.task for job in jobs])
        for (kind, split, rows, task), scored in zip(jobs, results, strict=True):
            errors[kind, split][..., rows[task.fold.score]] = scored
            np.add.at(counts[kind, split], rows[task.fold.fit], 1)
            bar.update(1)
    return errors, counts


def require_workers(value: Any) -> Any:
    """Return a function like `map` or a number of processes, all cores for -1, or raise `InvalidValue`."""
    if callable(value):
        return value
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool) and value == -1:
        return os.cpu_count() or 1
    return whole_number("workers", value, 1)


def use_one_core() -> None:
    """Make calls of kernels in a process use one core, as there are as many processes as cores."""
    CORES.set(1)


@contextmanager
def _mapping(workers: Any) -> Iterator[Apply]:
    """Function that maps tasks, and the processes that it needs."""
    if callable(workers):
        yield workers
    elif workers == 1:
        yield map
    else:
        with process_pool(workers) as pool:
            yield pool.map


@contextmanager
def process_pool(workers: int) -> Iterator[ProcessPoolExecutor]:
    """Pool of processes that use one core each, and that end with the block, also if it is interrupted."""
    others = active_children()
    pool = ProcessPoolExecutor(workers, get_context("spawn"), use_one_core)
    try:
        yield pool
    except KeyboardInterrupt:
        # SIGTERM, unlike Ctrl-C in a terminal, has reached this process alone.
        for process in set(active_children()).difference(others):
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)
