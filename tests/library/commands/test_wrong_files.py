"""Every command that reads a file, with files of every other kind: one line, nothing written."""

import shutil

import pytest

SCENE = "workflow/scenes/figure_03.yaml"
PUSH = ("--pusher-angle", "90")
BYTES = b"\x00\x9f\x92\x96 no text \xff\xfe"
#: The commands with their files: a scene, a log, pushes, or measurements.
COMMANDS = {
    "solve": ["solve", "SCENE", *PUSH],
    "cone": ["cone", "SCENE"],
    "draw": ["draw", "SCENE", *PUSH, "-o", "NEW.svg"],
    "explore": ["explore", "SCENE", "--no-browser"],
    "simulate": ["simulate", "SCENE", *PUSH, "--duration", "1", "-o", "NEW.nc"],
    "animate": ["animate", "LOG", "-o", "NEW.gif"],
    "identify": ["identify", "PUSHES", "-o", "NEW.yaml"],
    "outline": ["convert", "csv", "workflow/scenes/box.yaml", "--outline", "OUTLINE", "-o", "NEW.nc"],
    "compare": ["compare", "PUSHES", "-o", "NEW.nc"],
    "csv": ["convert", "csv", "TABLE", "--outline", "BOX", "-o", "NEW.nc"],
    "three-feet": ["convert", "three-feet", "TEXT", "-o", "NEW.nc"],
    "mit": ["convert", "mit", "MATLAB", "-o", "NEW.nc"],
}  # fmt: skip
FILES = ("none", "folder", "binary", "empty", "text", "numbers", "cut", "log", "scene")
#: The kind that a command reads.
RIGHT = {"SCENE": "scene", "LOG": "log"}


@pytest.fixture(scope="module")
def files(tmp_path_factory, log):
    """Files of each kind, by name."""
    folder = tmp_path_factory.mktemp("wrong")
    paths = {name: folder / f"{name}_patch_rect1" for name in FILES}
    paths["folder"].mkdir()
    paths["binary"].write_bytes(BYTES)
    paths["empty"].touch()
    paths["text"].write_text("No file of this kind.\n", encoding="utf-8")
    paths["numbers"].write_text("1 2 3\n", encoding="utf-8")
    paths["cut"].write_bytes(log.read_bytes()[:2000])
    shutil.copy(log, paths["log"])
    shutil.copy(SCENE, paths["scene"])
    box = folder / "box.yaml"
    box.write_text("[[0, 0], [9, 0], [9, 9], [0, 9]]", encoding="utf-8")
    return paths | {"BOX": box}


@pytest.mark.parametrize("kind", FILES)
@pytest.mark.parametrize("name", COMMANDS)
def test_a_file_of_another_kind_is_refused_in_one_line(refused, files, tmp_path, name, kind):
    words = COMMANDS[name]
    if kind in [RIGHT.get(word) for word in words]:
        return
    places = {"SCENE", "LOG", "PUSHES", "OUTLINE", "TABLE", "TEXT", "MATLAB"}
    arguments = [
        str(files[kind]) if word in places
        else str(files["BOX"]) if word == "BOX"
        else str(tmp_path / word) if word.startswith("NEW") else word
        for word in words
    ]  # fmt: skip
    refused(arguments, str(files[kind]))
    assert not list(tmp_path.iterdir())
    assert len(list(files["binary"].parent.iterdir())) == len(FILES)  # one of them is not there
