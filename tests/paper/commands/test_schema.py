"""The command `schema` for study files."""

import json
from pathlib import Path

from jsonschema import Draft202012Validator
from ruamel.yaml import YAML


def test_a_study_is_as_the_schema_says(run):
    schema = Draft202012Validator(json.loads(run("schema", "study")[1]))
    study = YAML(typ="safe", pure=True).load(Path("workflow/config/sliders.yaml"))
    assert schema.is_valid(study)
    assert not schema.is_valid(study | {"grid": {"rod_angle": [180]}})
