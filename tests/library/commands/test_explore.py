"""The command `explore`: what is wrong is said before a server starts."""

import socket
import sys

import pytest


def test_a_wrong_scene_is_one_line(refused, tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(
        "title: Glue\nslider: {rod_length: 2, rod_angle: 45}\ncontact: {law: glue}\n"
        "effects: [{type: ring_friction, weight: 1}]\n",
        encoding="utf-8",
    )
    refused(["explore", str(path)], f"{path}: contact.law: ")


def test_a_missing_scene_is_one_line(refused, tmp_path):
    refused(["explore", str(tmp_path / "none.yaml")], f"{tmp_path}/none.yaml: no such file; ")


def test_a_port_in_use_is_refused(refused):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        refused(["explore", "--no-browser", "--port", str(port)], f"port: {port} given")


@pytest.mark.parametrize("port", ["-1", "70000"])
def test_a_port_is_a_port(refused, port, monkeypatch):
    """It is checked before the server, which takes seconds, is imported."""
    monkeypatch.setitem(sys.modules, "planar_pushing.explorer.server", None)
    refused(["explore", "--no-browser", "--port", port], f"port: {port} given")
