"""The commands of the paper with files and folders of another kind: one line, nothing written."""

import pytest

FILES = {
    "none": None, "binary": b"\x00\x9f\x92\x96 no text \xff\xfe", "empty": b"", "text": b"No study.\n",
    "netCDF": b"\x89HDF\r\n\x1a\n",
    "scene": b"slider: {rod_length: 2, rod_angle: 45}\ncontact: {law: coulomb, friction_coefficient: 1}\n",
}  # fmt: skip
COMMANDS = {
    "plan": ["plan", "FILE"],
    "run": ["run", "FILE", "--dry-run"],
    "study of check": ["check", "FOLDER", "--study", "FILE"],
    "results of check": ["check", "FILE"],
    "results of query": ["query", "motion_cones", "--results", "FILE"],
    "dataset of query": ["query", "FILE"],
}


@pytest.fixture
def path(tmp_path, request):
    """A file of another kind; the folder holds nothing else."""
    file = tmp_path / "other.yaml"
    if request.param == "folder":
        file.mkdir()
    elif FILES[request.param] is not None:
        file.write_bytes(FILES[request.param])
    return file


@pytest.mark.parametrize("path", [*FILES, "folder"], indirect=True)
@pytest.mark.parametrize("name", COMMANDS)
def test_a_file_of_another_kind_is_refused_in_one_line(refused, path, tmp_path_factory, name):
    before = sorted(path.parent.iterdir())
    folder = str(tmp_path_factory.mktemp("results"))
    words = {"FILE": str(path), "FOLDER": folder}
    refused([words.get(word, word) for word in COMMANDS[name]], "")
    assert sorted(path.parent.iterdir()) == before


@pytest.mark.parametrize("kind", ["binary", "empty", "scene"])
def test_init_writes_into_no_file(refused, tmp_path, kind):
    file = tmp_path / "file"
    file.write_bytes(FILES[kind])
    refused(["init", str(file)], f"{file}/my_study.yaml: cannot be written")
    assert file.read_bytes() == FILES[kind]
