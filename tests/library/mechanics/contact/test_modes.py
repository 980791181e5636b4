"""Contact modes and outcomes as texts and as numbers."""

import json

import numpy as np
import pytest

import planar_pushing as pp


@pytest.mark.parametrize("member", [*pp.ContactMode, *pp.Outcome])
def test_a_member_is_printed_as_its_name(member, capsys):
    print(member)
    assert capsys.readouterr().out == f"{member.name}\n"
    assert (f"{member}", f"{member:>12}") == (member.name, member.name.rjust(12))


def test_members_are_numbers_still():
    assert (pp.ContactMode.STICK + 1, f"{pp.ContactMode.STICK:02d}") == (2, "01")
    assert json.dumps(pp.Outcome.AMBIGUOUS) == "2"
    assert np.array([pp.ContactMode.STICK]).dtype.kind == "i"
    assert pp.ContactMode(np.int8(3)) is pp.ContactMode.SLIP_LEFT
