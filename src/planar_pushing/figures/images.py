"""Compare the figures with stored images, and store new ones: `make images`.

Rendered text moves between versions of matplotlib, so this gates nothing but the locked versions; what a
figure shows is checked by its numbers.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from PIL import Image

from planar_pushing.study.figures import FIGURES, GALLERY
from planar_pushing.study.running.jobs import run_command
from planar_pushing.study.studies import SLIDERS_FILE, study_folder, study_name
from planar_pushing.terms.errors import InvalidFile

#: Stored images are this wide, pixels: wide enough to see a moved label.
WIDTH = 720
#: Largest root mean square difference of the color levels, 0 to 255.
TOLERANCE = 2.0


def thumbnail(path: Path) -> Image.Image:
    """Picture of the stored width, in RGB.

    Raises
    ------
    InvalidFile
        Where there is no such picture.
    """
    if not path.is_file():
        raise InvalidFile(f"{path}: no such picture; build it with make or snakemake")
    with Image.open(path) as image:
        height = round(image.height * WIDTH / image.width)
        return image.convert("RGB").resize((WIDTH, height), Image.Resampling.LANCZOS)


def difference(path: Path, stored: Path) -> float:
    """Root mean square difference of two pictures; infinite where their sizes differ."""
    new, old = (np.asarray(thumbnail(each), dtype=float) for each in (path, stored))
    return float(np.sqrt(np.mean((new - old) ** 2))) if new.shape == old.shape else np.inf


def pictures(results: Path) -> dict[str, Path]:
    """Pictures of the figures, those of the study of sliders in its own folder."""
    own = study_folder(study_name(SLIDERS_FILE), results)
    folders = dict.fromkeys(FIGURES, results) | dict.fromkeys(GALLERY, own)
    return {name: folder / "figures" / f"{name}.png" for name, folder in folders.items()}


def main(arguments: list[str] | None = None) -> int:
    """Print how the figures differ from the stored images; 1 where one does or is stored."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", default="results", type=Path)
    parser.add_argument("--golden", default="tests/golden", type=Path)
    parser.add_argument("--write", action="store_true", help="store the images that differ")
    args = parser.parse_args(arguments)
    changed = 0
    for name, picture in pictures(args.results).items():
        stored = args.golden / "images" / f"{name}.png"
        gap = difference(picture, stored) if stored.is_file() else np.inf
        print(f"{name}: {'unchanged' if gap <= TOLERANCE else 'differs'}, {gap:.2f} colour levels")
        if gap > TOLERANCE:
            changed += 1
            if args.write:
                stored.parent.mkdir(parents=True, exist_ok=True)
                thumbnail(picture).save(stored, optimize=True)
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(run_command(main))
