"""Build the manual with Sphinx; any warning stops the build."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.extras import require_extra
from planar_pushing.terms.replacing import PathLike

#: Settings for reproducible builds: a fixed order of sets, and no build time in the output.
FIXED = {"PYTHONHASHSEED": "0", "SOURCE_DATE_EPOCH": "0"}
#: Files that Sphinx writes for its next build, and an empty folder of sources.
KEPT = (".buildinfo", "_sources")


def build_manual(source: PathLike, output: PathLike, *options: str) -> None:
    """Write the manual's pages into a new folder.

    Parameters
    ----------
    source : path
        Folder of the pages and Sphinx's configuration.
    output : path
        Folder to write.
    *options : str
        Further options of `sphinx-build`.

    Raises
    ------
    InvalidFile
        If Sphinx reports an error or a warning, which the message repeats.
    """
    require_extra("manual")
    with tempfile.TemporaryDirectory() as work:
        # Sphinx leaves executed notebooks next to the pages, and doctrees in a separate folder.
        pages, trees = Path(work) / "pages" / "html", Path(work) / "trees"
        command = [sys.executable, "-m", "sphinx", "--builder", "html", "--fail-on-warning"]
        command += ["--keep-going", "--quiet", "--doctree-dir", str(trees), *options]
        ended = subprocess.run(
            [*command, str(source), str(pages)],
            env=os.environ | FIXED, capture_output=True, text=True, check=False,
        )  # fmt: skip
        if ended.returncode:
            raise InvalidFile(f"{source}: cannot be built: {ended.stderr.strip()}")
        shutil.copytree(pages, output, ignore=shutil.ignore_patterns(*KEPT))
