"""Exclusive right to write a file: at most one writer at a time, in all processes and threads."""

from __future__ import annotations

import errno
import fcntl
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from planar_pushing.terms.errors import InvalidFile

PathLike = str | os.PathLike[str]
#: Errors of a file system without locks, such as that of some clusters.
WITHOUT_LOCKS = (errno.ENOLCK, errno.EOPNOTSUPP, errno.ENOSYS)
#: What stands where a regular file is expected, by its type.
OTHER_TYPES = {
    stat.S_IFDIR: os.strerror(errno.EISDIR), stat.S_IFIFO: "Is a pipe", stat.S_IFSOCK: "Is a socket",
    stat.S_IFCHR: "Is a device", stat.S_IFBLK: "Is a device",
}  # fmt: skip


def regular_file(path: PathLike) -> Path:
    """The file to write, which is the target of `path` if that is a link; it need not exist.

    Raises
    ------
    InvalidFile
        If the path is that of a folder, a device, a pipe or a socket, or of a file that the user may not
        write.
    """
    target = Path(os.path.realpath(path))
    try:
        kind = stat.S_IFMT(target.stat().st_mode)
    except FileNotFoundError:
        return target
    except OSError as error:
        raise unwritable(path, error) from None
    if kind != stat.S_IFREG:
        reason = OTHER_TYPES.get(kind, "Is not a regular file")
        raise unwritable(path, OSError(errno.EINVAL, reason))
    if not os.access(target, os.W_OK):
        raise unwritable(path, OSError(errno.EACCES, os.strerror(errno.EACCES)))
    return target


@contextmanager
def sole_writer(target: Path, label: PathLike) -> Iterator[bool]:
    """Create the folder of a file, and keep other writers of the file out until the end of the block.

    The lock is on the empty file `.NAME.lock` beside the file: HDF5 locks the files that it opens, so a
    lock on the file itself would also keep its readers out. The operating system releases the lock of a
    killed process; the next writer then finds `.NAME.lock` without a lock and takes it.

    Parameters
    ----------
    target : Path
        The file.
    label : path
        The file as the user names it, for messages.

    Yields
    ------
    bool
        Whether other writers are kept out; False if the file system does not support locks.

    Raises
    ------
    InvalidFile
        If another process or thread is writing the file, or the folder cannot be written.
    """
    lock = target.with_name(f".{target.name}.lock")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        descriptor, locked = _acquire(lock)
    except BlockingIOError:
        raise InvalidFile(f"{label}: another process is writing it; name another file") from None
    except OSError as error:
        raise unwritable(label, error) from None
    try:
        yield locked
    finally:
        with suppress(OSError):
            lock.unlink()
        os.close(descriptor)


def _acquire(lock: Path) -> tuple[int, bool]:
    """Descriptor of the lock's file, and whether it is locked."""
    while True:
        descriptor = _open_lock(lock)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if _is_at(descriptor, lock):
                return descriptor, True
        except OSError as error:
            if error.errno in WITHOUT_LOCKS:
                return descriptor, False
            os.close(descriptor)
            raise
        os.close(descriptor)  # the previous writer has just ended and removed its lock


def _open_lock(lock: Path) -> int:
    """Open the lock's file, which is created if necessary; a link in its place is removed."""
    flags = os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_CLOEXEC
    try:
        return os.open(lock, flags, 0o666)
    except OSError as error:
        if error.errno != errno.ELOOP:
            raise
        lock.unlink()
        return os.open(lock, flags, 0o666)


def _is_at(descriptor: int, path: Path) -> bool:
    """Whether an open file is still the one at a path."""
    with suppress(FileNotFoundError):
        return os.path.samestat(os.fstat(descriptor), path.lstat())
    return False


def unwritable(path: PathLike, error: OSError) -> InvalidFile:
    """Error for a file that cannot be written."""
    reason = error.strerror or error
    return InvalidFile(f"{path}: cannot be written ({reason}); name another file")
