"""The command `init` writes a study and a scene that work as they are."""

from planar_pushing.scenes.files import load_scene_file
from pulling_by_pushing.study.study_file import load_study


def test_what_is_written_runs_from_any_folder(run, tmp_path, monkeypatch):
    code, out, _ = run("init", str(tmp_path / "mine"))
    assert code == 0
    assert f"to build it: planar-pushing run {tmp_path}/mine/my_study.yaml\n" in out
    monkeypatch.chdir("/")
    study = load_study(tmp_path / "mine/my_study.yaml")
    assert study.simulations == {"push_and_pull": str(tmp_path / "mine/scene.yaml")}
    assert load_scene_file(tmp_path / "mine/scene.yaml").simulate
    for name in ("my_study.yaml", "scene.yaml"):
        assert (tmp_path / "mine" / name).read_text(encoding="utf-8").count("\n#") > 3


def test_an_extra_that_is_missing_is_installed_first(run, tmp_path, monkeypatch):
    monkeypatch.setattr("planar_pushing.terms.extras.find_spec", lambda name: None)
    _, out, _ = run("init", str(tmp_path / "my folder"))
    command = f"planar-pushing run '{tmp_path}/my folder/my_study.yaml'"
    install = "pip install '.[workflow,figures]' in the project's folder"
    assert f"to build it: {install}, then {command}\n" in out


def test_nothing_is_overwritten(refused, tmp_path):
    (tmp_path / "scene.yaml").write_text("mine")
    said = f"{tmp_path}/scene.yaml: already exists; choose another folder"
    refused(["init", str(tmp_path)], said)
    assert [path.name for path in tmp_path.iterdir()] == ["scene.yaml"]
