"""Set the manual: Sphinx writes its pages, and stops at any warning."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from planar_pushing.study.files.replacing import PathLike
from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.extras import require_extra

#: What makes two builds the same bytes: sets in one order, and no time of the build.
FIXED = {"PYTHONHASHSEED": "0", "SOURCE_DATE_EPOCH": "0"}
#: What Sphinx keeps for a next build, and the empty folder of sources.
KEPT = (".buildinfo", "_sources")


def build_manual(source: PathLike, output: PathLike, *options: str) -> None:
    """Write the manual's pages into a new folder.

    Parameters
    ----------
    source : path
        The folder of the pages and of Sphinx's configuration.
    output : path
        The folder to write.
    *options : str
        Options of `sphinx-build` besides.

    Raises
    ------
    InvalidFile
        Where Sphinx finds an error or warns; the message holds what it says.
    """
    require_extra("manual")
    with tempfile.TemporaryDirectory() as work:
        # Executed notebooks are left beside the pages, and doctrees where -d says.
        pages, trees = Path(work) / "pages" / "html", Path(work) / "trees"
        command = [sys.executable, "-m", "sphinx", "--builder", "html", "--fail-on-warning"]
        command += ["--keep-going", "--quiet", "--doctree-dir", str(trees), *options]
        ended = subprocess.run(
            [*command, str(source), str(pages)],
            env=os.environ | FIXED, capture_output=True, text=True, check=False,
        )  # fmt: skip
        if ended.returncode:
            raise InvalidFile(f"{source}: cannot be set: {ended.stderr.strip()}")
        shutil.copytree(pages, output, ignore=shutil.ignore_patterns(*KEPT))
