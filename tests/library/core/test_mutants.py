"""The changes that `make mutants` always makes are changes of the core as it is."""

from __future__ import annotations

import ast

import pytest
from core.building import CORE

from mutants.changes import ALWAYS, changes_of, select_changes
from mutants.switches import LIST, PROJECT, is_free


@pytest.mark.parametrize("function", sorted({function for function, *_ in ALWAYS}))
def test_a_change_that_is_always_made_is_there_once(function):
    paths = [path for path in CORE.rglob("[!_]*.py") if f"def {function}(" in path.read_text()]
    (tree,) = (ast.parse(path.read_text()) for path in paths)
    tree.body = [node for node in tree.body if getattr(node, "name", "") == function]
    changes = select_changes(changes_of({paths[0].relative_to(CORE): tree}), seed=1, count=0)
    expected = [change for change in ALWAYS if change[0] == function]
    assert sorted((each.function, each.old, each.new) for each in changes) == sorted(expected)


def test_a_copy_is_made_only_where_it_replaces_no_other_files(tmp_path):
    assert is_free(tmp_path)
    assert is_free(tmp_path / "new")
    (tmp_path / "src").mkdir()
    assert not is_free(tmp_path)
    (tmp_path / LIST).write_text("[]")
    assert is_free(tmp_path)
    assert not is_free(PROJECT)
