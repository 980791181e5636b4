"""Logs and error messages without tracebacks for the workflow's jobs and the Makefile's commands."""

from __future__ import annotations

import fcntl
import logging
import platform
import sys
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from importlib.metadata import version
from pathlib import Path

from planar_pushing.terms.errors import PlanarPushingError
from planar_pushing.terms.signals import Termination, termination_as_interrupt

PACKAGE = "planar_pushing"
#: Number of log lines to show for a failed job.
TAIL = 12


@contextmanager
def job_log(path: str) -> Iterator[logging.Logger]:
    """Log a job to `path`: our own errors by their message, others with a traceback.

    The job must run in a separate process and import its modules inside this context, so that failed
    imports are also logged. If a job is started again while its first process is still running, which can
    happen on a cluster, it waits for that process.
    """
    with open(path, "a", encoding="utf-8") as lock:  # noqa: PTH123 - held open
        with suppress(OSError):  # a cluster's file system may not support locks
            fcntl.flock(lock, fcntl.LOCK_EX)
        with termination_as_interrupt():
            yield from _log_to(path)


def _log_to(path: str) -> Iterator[logging.Logger]:
    logger = logging.getLogger(PACKAGE)
    handler = logging.FileHandler(path, mode="w", encoding="utf-8")
    handler.setFormatter(logging.Formatter("%(levelname)s %(message)s"))
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
    logger.info("Python %s, numpy %s", platform.python_version(), version("numpy"))
    start = time.perf_counter()
    try:
        yield logger
        logger.info("done in %.1f s", time.perf_counter() - start)
    except PlanarPushingError as error:
        logger.error("%s", error)
        raise SystemExit(1) from None
    except Exception:
        logger.error("%s", traceback.format_exc())
        raise SystemExit(1) from None
    except KeyboardInterrupt as interrupt:
        is_termination = isinstance(interrupt, Termination)
        logger.error("%s", "terminated" if is_termination else "interrupted")
        raise SystemExit(1) from None
    finally:
        logger.removeHandler(handler)
        handler.close()


def failure_text(rule: str, message: str, logs: Sequence[str]) -> str:
    """Message for a failed job: its name, the last lines of its logs, and the remedy."""
    lines = [f"FAILED: {rule}" + (f" ({message})" if message else "")]
    for log in logs:
        path = Path(log)
        log_lines = (
            path.read_text(encoding="utf-8").splitlines() if path.is_file() else ["no such file"]
        )
        lines += [f"  end of {log}:", *(f"    {line}" for line in log_lines[-TAIL:])]
    return "\n".join([*lines, "  fix the error and run make again; it continues from here"])


def run_command(main: Callable[[], int]) -> int:
    """Run a command of the Makefile; print a message and return 2 if an input is invalid."""
    try:
        return main()
    except PlanarPushingError as error:
        print(error, file=sys.stderr)
        return 2
