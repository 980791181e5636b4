"""Compare the pages that a forge shows with their sources, and store them: `make pages`."""

from __future__ import annotations

import argparse
import io
import sys
from pathlib import Path

import numpy as np
from PIL import Image

from planar_pushing.terms.replacing import replacing
from pulling_by_pushing.figures.pages.markdown import (
    OUTPUT,
    RESULTS,
    SOURCE,
    render_page,
    rendered_pages,
)
from pulling_by_pushing.study.running.jobs import run_command

#: Largest root mean square difference of color levels of two pictures, 0 to 255: text moves a little.
LEVEL_TOLERANCE = 4.0


def same_picture(new: Image.Image, path: Path) -> bool:
    """Whether a stored picture is that of a page, but for text that moved a little."""
    if not path.is_file():
        return False
    with Image.open(path) as image:
        old = np.asarray(image.convert("RGB"), dtype=float)
    levels = np.asarray(new.convert("RGB"), dtype=float)
    if levels.shape != old.shape:
        return False
    return bool(np.sqrt(np.mean((levels - old) ** 2)) <= LEVEL_TOLERANCE)


def differing_files(page: Path, results: Path = RESULTS) -> dict[Path, bytes]:
    """Stored files of a page that differ from what it is now, with their new content."""
    text, pictures = render_page(page, results)
    path, new = OUTPUT / page, text.encode()
    files = {} if path.is_file() and path.read_bytes() == new else {path: new}
    for name, picture in pictures.items():
        stored = OUTPUT / "pictures" / name
        if not same_picture(picture, stored):
            file = io.BytesIO()
            picture.save(file, format="PNG", optimize=True)
            files[stored] = file.getvalue()
    return files


def main(arguments: list[str] | None = None) -> int:
    """Print which stored pages differ from their sources; return 1 if any differs or is stored."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", default=RESULTS, type=Path)
    parser.add_argument("--write", action="store_true", help="store the files that differ")
    args = parser.parse_args(arguments)
    changed = 0
    for page in rendered_pages():
        files = differing_files(page, args.results)
        print(f"{OUTPUT / page}: {'differs' if files else 'unchanged'}")
        changed += len(files)
        for path, content in files.items() if args.write else ():
            path.parent.mkdir(parents=True, exist_ok=True)
            with replacing(path) as temporary:
                temporary.write_bytes(content)
    for path in sorted(OUTPUT.rglob("*.md")):
        if not (SOURCE / path.relative_to(OUTPUT)).is_file():
            print(f"{path}: has no source; remove it")
            changed += 1
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(run_command(main))
