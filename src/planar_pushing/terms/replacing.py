"""Files that are written completely or not at all."""

from __future__ import annotations

import glob
import os
import shutil
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from planar_pushing.terms.locks import PathLike, regular_file, sole_writer, unwritable

__all__ = ["PathLike", "replacing", "working_folder"]


@contextmanager
def replacing(path: PathLike) -> Iterator[Path]:
    """Temporary path to write to, which replaces `path` once it is complete.

    If `path` is a link, its target is replaced. A file that is replaced keeps its permissions. The
    temporary file `.NAME.*.part` is new and its name is random, so no link in its place is followed. Those
    that killed runs have left are removed.

    Raises
    ------
    InvalidFile
        If the file cannot be written or is not a regular one, or another process or thread is writing it.
    """
    target = regular_file(path)
    with sole_writer(target, path) as alone:
        if alone:
            _forget_parts(target)
        temporary = target.with_name(f".{target.name}.{os.urandom(4).hex()}.part")
        try:
            old = target.stat() if target.exists() else None
            # Nobody else reads the new content before it has the permissions of the old one.
            mode = 0o666 if old is None else 0o600
            os.close(os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode))
            yield temporary
            if old is not None:
                _keep_permissions(temporary, old)
            temporary.replace(target)
        except OSError as error:
            raise unwritable(path, error) from None
        finally:
            _forget(temporary)


@contextmanager
def working_folder(path: PathLike) -> Iterator[Path]:
    """New folder beside a file, for what the file is made from; it is removed afterwards.

    A folder that a killed run has left is removed first.

    Raises
    ------
    InvalidFile
        If the folder cannot be written, or another process or thread is making the file.
    """
    target = regular_file(path)
    folder = target.with_name(f".{target.name}.blocks")
    with sole_writer(folder, path) as alone:
        if not alone:  # the folder may be that of a running process
            folder = folder.with_name(f"{folder.name}.{os.urandom(4).hex()}")
        shutil.rmtree(folder, ignore_errors=True)
        try:
            folder.mkdir()
        except OSError as error:
            raise unwritable(path, error) from None
        try:
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def _keep_permissions(temporary: Path, old: os.stat_result) -> None:
    """Give a file the mode of an older one, and its owner if that is allowed."""
    with suppress(OSError):
        os.chown(temporary, old.st_uid, old.st_gid)
    temporary.chmod(stat.S_IMODE(old.st_mode))


def _forget_parts(target: Path) -> None:
    """Remove the temporary files of killed runs; nobody else is writing the target."""
    for part in target.parent.glob(f".{glob.escape(target.name)}.????????.part"):
        _forget(part)


def _forget(path: Path) -> None:
    """Remove a file; ignore a missing file or folder."""
    with suppress(OSError):
        path.unlink(missing_ok=True)
