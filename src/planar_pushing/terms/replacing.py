"""Files that are written completely or not at all."""

from __future__ import annotations

import glob
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from planar_pushing.terms.locks import PathLike, sole_writer, unwritable

__all__ = ["PathLike", "replacing"]


@contextmanager
def replacing(path: PathLike) -> Iterator[Path]:
    """Temporary path to write to, which replaces `path` once it is complete.

    The temporary file `.NAME.*.part` is new and its name is random, so no link is followed. Those that
    killed runs have left are removed.

    Raises
    ------
    InvalidFile
        If the file cannot be written, or another process or thread is writing it.
    """
    target = Path(path)
    with sole_writer(target, path) as alone:
        if alone:
            _forget_parts(target)
        temporary = target.with_name(f".{target.name}.{os.urandom(4).hex()}.part")
        try:
            os.close(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666))
            yield temporary
            temporary.replace(target)
        except OSError as error:
            raise unwritable(path, error) from None
        finally:
            _forget(temporary)


def _forget_parts(target: Path) -> None:
    """Remove the temporary files of killed runs; nobody else is writing the target."""
    for part in target.parent.glob(f".{glob.escape(target.name)}.????????.part"):
        _forget(part)


def _forget(path: Path) -> None:
    """Remove a file; ignore a missing file or folder."""
    with suppress(OSError):
        path.unlink(missing_ok=True)
