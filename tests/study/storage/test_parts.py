"""Parts of a grid: what each holds, and that what is stored lies in one of them."""

import itertools
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from planar_pushing.study.storage.parts import blocks, chunk_name, cut, points, ranges, shape, sizes

from planar_pushing.study.catalog import CONTACT_LAWS, SPLIT
from planar_pushing.study.slices import study_slice
from planar_pushing.study.study_file import load_study

STUDY = load_study("workflow/config/smoke.yaml")
LENGTHS = st.lists(st.integers(1, 12), min_size=1, max_size=4)


def bounds(part, dims):
    return [(part[dim].start, part[dim].stop) for dim in dims]


@given(LENGTHS, st.integers(1, 300))
def test_blocks_make_up_the_grid(lengths, most):
    dims = [f"dim_{i}" for i in range(len(lengths))]
    grid = dict(zip(dims, lengths, strict=True))
    found = blocks(grid, most)
    sizes_of = [math.prod(b - a for a, b in bounds(part, dims)) for part in found]
    assert sum(sizes_of) == points(grid)
    assert max(sizes_of) <= most
    corners = [tuple(a for a, _ in bounds(part, dims)) for part in found]
    assert corners == sorted(set(corners))


@given(LENGTHS, st.integers(0, 12), st.integers(0, 6), st.integers(1, 5))
def test_what_is_stored_lies_in_one_block(lengths, power, more, tail):
    """Stored pieces count the dimensions behind the grid's too."""
    stored = shape([*lengths, tail], 2**power)[:-1]
    taken = shape(lengths, 2 ** (power + more))
    for length, piece, block in zip(lengths, stored, taken, strict=True):
        assert block % piece == 0 or block == length


def test_a_part_has_the_values_of_its_ranges_alone():
    values = study_slice(STUDY, "contact_modes")
    part = {"contact": slice(3, 6), "pusher_angle": slice(1, 3)}
    found = cut(values, part)
    assert found["grid"]["pusher_angle"] == values["grid"]["pusher_angle"][1:3]
    assert found["grid"]["contact_friction_coefficient"] == [2.0]
    assert found["only"] == {"contact": ["coulomb_2", *CONTACT_LAWS[:2]]}
    assert sizes("contact_modes", found)["contact"] == 3
    again = cut(found, {"contact": slice(1, 2)})
    assert again["only"] == {"contact": [CONTACT_LAWS[0]]}
    assert again["grid"]["contact_friction_coefficient"] == []


def test_the_whole_is_no_part():
    values = study_slice(STUDY, "motion_cones")
    assert cut(values, {}) == values
    assert sizes("scenes", study_slice(STUDY, "scenes")) == {}
    assert blocks({}, 5) == [{}]


@pytest.mark.parametrize("name", SPLIT)
def test_sizes_are_those_of_the_dataset(results, name):
    from planar_pushing.study.store import open_dataset

    found = open_dataset(name, results)
    assert {dim: found.sizes[dim] for dim in SPLIT[name]} == sizes(name, study_slice(STUDY, name))


def test_borders_do_not_depend_on_the_number_of_chunks():
    short, long = ({"a": n, "b": 7} for n in (20, 33))
    steps = {"a": 8, "b": 5}
    before, after = ({chunk_name(part): part for part in ranges(n, steps)} for n in (short, long))
    same = [name for name in before if before[name] == after[name]]
    assert same == [f"a_{i}.b_{j}" for i, j in itertools.product((0, 8), (0, 5))]
    assert list(after)[-1] == "a_32.b_5"
