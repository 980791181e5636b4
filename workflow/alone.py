"""Run a command while no other one runs that this file started: a second waits, and says so.

Only the standard library: it runs before there is an environment. The lock goes with the process, so that
a killed run leaves none.
"""

import fcntl
import signal
import subprocess
import sys
from pathlib import Path

LOCK = Path(".snakemake/make")


def main(command: list[str]) -> int:
    """Run the command; its status."""
    LOCK.parent.mkdir(exist_ok=True)
    with LOCK.open("a") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            print("another make is setting up this folder; waiting for it", flush=True)
            fcntl.flock(lock, fcntl.LOCK_EX)
        return subprocess.run(command, check=False).returncode


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)
