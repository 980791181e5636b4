"""White margins of a picture, which the report leaves out between a figure and its caption."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from planar_pushing.study.files.replacing import PathLike
from planar_pushing.terms.errors import InvalidFile

#: White that stays around a picture, points.
KEPT = 2.0
POINTS_PER_INCH = 72.0


def margins(path: PathLike) -> dict[str, float]:
    """White above and below a PNG picture that can be cut away, points.

    Raises
    ------
    InvalidFile
        Where there is no such picture, or it shows nothing.
    """
    if not Path(path).is_file():
        raise InvalidFile(f"{path}: no such picture; build it with make or snakemake")
    with Image.open(path) as image:
        scale = POINTS_PER_INCH / float(image.info.get("dpi", (POINTS_PER_INCH,) * 2)[1])
        height = image.height
        rows = np.flatnonzero((np.asarray(image.convert("L")) < 255).any(axis=1))
    if not rows.size:
        raise InvalidFile(f"{path}: shows nothing; remove it and build it anew")
    white = {"top": rows[0], "bottom": height - 1 - rows[-1]}
    return {side: round(max(0.0, float(count) * scale - KEPT), 1) for side, count in white.items()}
