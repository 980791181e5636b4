"""The command `schema`."""

import json
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator
from ruamel.yaml import YAML

SCENE = Path("workflow/scenes/tripod.yaml")


@pytest.fixture
def schema(run):
    code, text, _ = run("schema", "scene")
    assert code == 0
    assert json.loads(run("schema", "scene", "--json")[1]) == json.loads(text)
    Draft202012Validator.check_schema(json.loads(text))
    return Draft202012Validator(json.loads(text))


def test_a_scene_file_is_as_the_schema_says(schema):
    content = YAML(typ="safe", pure=True).load(SCENE)
    assert schema.is_valid(content)
    side = {"side": ["-inf", 2.0]}
    assert schema.is_valid(content | {"slider": content["slider"] | side})
    for wrong in (
        {"rod_angle": 180},
        {"rod_length": -1},
        {"radius": 0},
        {"side": ["far", 1]},
        {"rod": 1},
    ):
        assert not schema.is_valid(content | {"slider": content["slider"] | wrong})


@pytest.mark.parametrize("name", ["two_fingers", "finger_in_a_corner", "box_along_a_wall", "box"])
def test_files_of_objects_are_as_the_schema_says(schema, name):
    content = YAML(typ="safe", pure=True).load(Path(f"workflow/scenes/{name}.yaml"))
    assert schema.is_valid(content)
    section = content["simulate"]
    wrong = [{"effects": 3}, {"simulate": section | {"duration": 0}}, {"titel": ""}]
    if "contacts" in content:
        first = content["contacts"][0]
        wrong += [{"contacts": {}}, {"contact": first}, {"simulate": section | {"pusher_angle": 3}}]
        wrong += [{"contacts": [first | {"velocity": [1]}]}, {"contacts": [{"point": [0.5, 0]}]}]
    for change in wrong:
        assert not schema.is_valid(content | change), change


def test_a_kind_that_is_not_there(refused):
    refused(["schema", "sceen"], "kind: 'sceen' given; allowed: scene, ")
