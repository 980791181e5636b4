"""Compare the figures with stored images, and store new images: `make images`.

Rendered text moves between versions of matplotlib, so the comparison is meaningful only with the locked
versions. The content of a figure is checked by its numbers.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from PIL import Image

from planar_pushing.terms.errors import InvalidFile
from planar_pushing.terms.replacing import replacing
from pulling_by_pushing.figures.studies import PUSHES, pictures
from pulling_by_pushing.study.running.jobs import run_command
from pulling_by_pushing.study.studies import PAPER_FILE, SLIDERS_FILE, study_folder, study_name
from pulling_by_pushing.study.study_file import load_study

#: Scale of a stored image relative to its picture: large enough to reveal a moved label.
STORED_SCALE = 0.36
#: Number of colors in a stored image.
COLORS = 128
#: Largest allowed root mean square difference of color levels, 0 to 255.
LEVEL_TOLERANCE = 2.0


def thumbnail(path: Path) -> Image.Image:
    """Picture reduced to the stored size and number of colors.

    Raises
    ------
    InvalidFile
        If there is no such picture.
    """
    if not path.is_file():
        raise InvalidFile(f"{path}: no such picture; build it with make or snakemake")
    with Image.open(path) as image:
        size = round(STORED_SCALE * image.width), round(STORED_SCALE * image.height)
        small = image.convert("RGB").resize(size, Image.Resampling.LANCZOS)
        return small.quantize(COLORS)


def difference(path: Path, stored: Path) -> float:
    """Root mean square difference of two pictures; infinite if their sizes differ."""
    with Image.open(stored) as image:
        old = np.asarray(image.convert("RGB"), dtype=float)
    new = np.asarray(thumbnail(path).convert("RGB"), dtype=float)
    return float(np.sqrt(np.mean((new - old) ** 2))) if new.shape == old.shape else np.inf


def every_picture(results: Path) -> dict[str, Path]:
    """Pictures of the figures of both default studies and of those on measured pushes."""
    sliders = study_folder(study_name(SLIDERS_FILE), results)
    folders = {PAPER_FILE: results, SLIDERS_FILE: sliders}
    by_study = [pictures(folder, load_study(file)) for file, folder in folders.items()]
    measured = {name: results / "figures" / f"{name}.png" for name in PUSHES}
    return by_study[0] | by_study[1] | measured


def main(arguments: list[str] | None = None) -> int:
    """Print how the figures differ from the stored images; return 1 if any differs or is stored."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", default="results", type=Path)
    parser.add_argument("--golden", default="tests/golden", type=Path)
    parser.add_argument("--write", action="store_true", help="store the images that differ")
    args = parser.parse_args(arguments)
    changed = 0
    for name, picture in every_picture(args.results).items():
        stored = args.golden / "images" / f"{name}.png"
        gap = difference(picture, stored) if stored.is_file() else np.inf
        print(
            f"{name}: {'unchanged' if gap <= LEVEL_TOLERANCE else 'differs'}, {gap:.2f} color levels"
        )
        if gap > LEVEL_TOLERANCE:
            changed += 1
            if args.write:
                with replacing(stored) as temporary:
                    thumbnail(picture).save(temporary, format="PNG", optimize=True)
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(run_command(main))
