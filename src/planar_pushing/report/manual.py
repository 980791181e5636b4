"""Build the manual: Sphinx writes its pages, and any warning stops it."""

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

#: Makes two builds identical: sets are in one order, and no time of the build is written.
FIXED = {"PYTHONHASHSEED": "0", "SOURCE_DATE_EPOCH": "0"}
#: Files that Sphinx keeps for the next build, and the empty folder of sources.
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
        Further options of `sphinx-build`.

    Raises
    ------
    InvalidFile
        Where Sphinx finds an error or warns; the message holds what it says.
    """
    require_extra("manual")
    with tempfile.TemporaryDirectory() as work:
        # Sphinx leaves executed notebooks beside the pages, and doctrees in their own folder.
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
