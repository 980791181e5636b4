"""Blocks of a grid and chunks of a study: their borders, their names, and what a job takes."""

import itertools
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from planar_pushing.terms.netcdf import block_shape
from pulling_by_pushing.study import chunks
from pulling_by_pushing.study.chunks import (
    blocks,
    chunk_name,
    chunk_parts,
    chunk_slice,
    chunk_steps,
)
from pulling_by_pushing.study.slices import split_ranges, study_slice
from pulling_by_pushing.study.study_file import load_study

LENGTHS = st.lists(st.integers(1, 12), min_size=1, max_size=4)
STUDY = load_study("workflow/config/smoke.yaml").model_copy(
    update={"chunks": {"contact_modes": {"pusher_angle": 10, "contact": 3}, "motion_cones": {}}}
)


def bounds(part, dims):
    return [(part[dim].start, part[dim].stop) for dim in dims]


@given(LENGTHS, st.integers(1, 300))
def test_blocks_make_up_the_grid(lengths, most):
    grid = {f"dim_{i}": length for i, length in enumerate(lengths)}
    found = blocks(grid, most)
    counts = [math.prod(b - a for a, b in bounds(part, grid)) for part in found]
    assert sum(counts) == math.prod(lengths)
    assert max(counts) <= most
    corners = [tuple(a for a, _ in bounds(part, grid)) for part in found]
    assert corners == sorted(set(corners))


@given(LENGTHS, st.integers(0, 12), st.integers(0, 6), st.integers(1, 5))
def test_a_stored_piece_lies_in_one_block(lengths, power, more, tail):
    """Stored pieces count the dimensions behind the grid's too."""
    stored = block_shape([*lengths, tail], 2**power)[:-1]
    taken = block_shape(lengths, 2 ** (power + more))
    for length, piece, block in zip(lengths, stored, taken, strict=True):
        assert block % piece == 0 or block == length


def test_a_dataset_without_a_grid_is_one_block():
    assert blocks({}, 5) == [{}]


def test_chunks_follow_the_order_of_the_dimensions():
    assert chunk_steps(STUDY, "contact_modes") == {"contact": 3, "pusher_angle": 10}
    found = chunk_parts(STUDY, "contact_modes")
    assert list(found) == [
        f"contact_{i}.pusher_angle_{j}" for i, j in itertools.product((0, 3, 6), (0, 10, 20))
    ]
    assert found["contact_6.pusher_angle_20"] == {
        "contact": slice(6, 7),
        "pusher_angle": slice(20, 25),
    }


def test_a_chunk_reads_its_own_values_of_the_axes():
    part = chunk_parts(STUDY, "contact_modes")["contact_3.pusher_angle_20"]
    values, whole = chunk_slice(STUDY, "contact_modes", part), study_slice(STUDY, "contact_modes")
    assert values["grid"]["contact"] == whole["grid"]["contact"][3:6]
    assert values["grid"]["pusher_angle"] == whole["grid"]["pusher_angle"][20:]
    assert values["grid"]["rod_length"] == whole["grid"]["rod_length"]


def test_only_the_chunk_of_a_changed_value_changes():
    grid = STUDY.grid.model_copy(
        update={"pusher_angle": tuple(angle + (angle == 0) for angle in STUDY.grid.pusher_angle)}
    )
    other = STUDY.model_copy(update={"grid": grid})
    parts = chunk_parts(STUDY, "contact_modes")
    assert chunk_parts(other, "contact_modes") == parts
    changed = [
        name
        for name, part in parts.items()
        if chunk_slice(STUDY, "contact_modes", part) != chunk_slice(other, "contact_modes", part)
    ]
    assert changed == [f"contact_{i}.pusher_angle_10" for i in (0, 3, 6)]


def test_borders_do_not_depend_on_the_number_of_chunks():
    short, long = ({"a": n, "b": 7} for n in (20, 33))
    steps = {"a": 8, "b": 5}
    before, after = (
        {chunk_name(part): part for part in split_ranges(n, steps)} for n in (short, long)
    )
    same = [name for name in before if before[name] == after[name]]
    assert same == [f"a_{i}.b_{j}" for i, j in itertools.product((0, 8), (0, 5))]
    assert list(after)[-1] == "a_32.b_5"


@pytest.mark.parametrize("count", [1, 10**6, 10**10])
def test_a_job_asks_for_more_as_it_grows(count):
    assert 1 <= chunks.threads(count) <= chunks.threads(10 * count) <= chunks.MOST_THREADS
    assert chunks.MINUTES <= chunks.minutes(count) < chunks.minutes(10**7 * count)
