"""Files that are written completely or not at all."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from planar_pushing.terms.errors import InvalidFile

PathLike = str | os.PathLike[str]


@contextmanager
def replacing(path: PathLike) -> Iterator[Path]:
    """Temporary path to write to, which replaces `path` once it is complete.

    Its name is always the same, so the next run overwrites the leftovers of a killed one.
    """
    target = Path(path)
    temporary = target.with_name(f".{target.name}.part")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        temporary.write_bytes(b"")
        yield temporary
        temporary.replace(target)
    except OSError as error:
        reason = error.strerror or error
        raise InvalidFile(f"{path}: cannot be written ({reason}); name another file") from None
    finally:
        _forget(temporary)


def _forget(path: Path) -> None:
    """Remove a file; ignore a missing file or folder."""
    with suppress(OSError):
        path.unlink(missing_ok=True)
