"""The stored schemas are those of the models."""

import json
from pathlib import Path

import pytest

from pulling_by_pushing.study.schemas import SCHEMAS, schema_text


@pytest.mark.parametrize("name", SCHEMAS)
def test_schema_is_that_of_the_model(name):
    stored = Path(f"workflow/schemas/{name}.schema.json").read_text(encoding="utf-8")
    assert stored == schema_text(name), "run make schemas"
    json.loads(stored)
