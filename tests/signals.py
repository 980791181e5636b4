"""Ctrl-C in tests: `make test &` and nohup hand an ignored SIGINT to their children."""

from __future__ import annotations

import signal


def interruptible() -> None:
    """Let this process hear Ctrl-C; the `preexec_fn` of a child that is sent a signal."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def uninterruptible() -> None:
    """Ignore Ctrl-C, as a child of a shell in the background does."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
