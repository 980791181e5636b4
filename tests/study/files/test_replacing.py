"""Files are replaced whole or not at all."""

import pytest

from planar_pushing.study.files.replacing import replacing


def test_replacing_keeps_the_old_file_when_the_work_fails(tmp_path):
    path = tmp_path / "file.txt"
    path.write_text("old")

    def work():
        with replacing(path) as temporary:
            temporary.write_text("ne")
            raise RuntimeError("half way")

    with pytest.raises(RuntimeError, match="half way"):
        work()
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]
