"""A Slurm of one node on this machine's loopback, for the time of a test.

Its configuration stands in Slurm's system-wide place, since the steps of a job look nowhere else; its
state, spool and logs in a folder of its own. Its daemons are stopped by their process numbers.
"""

from __future__ import annotations

import os
import secrets
import shutil
import signal
import socket
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

CONFIGURATION = Path("/etc/slurm/slurm.conf")
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "scancel")
TEXT = """\
ClusterName=planar
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerParameters=batch_sched_delay=0,sched_interval=2
MpiDefault=none
ReturnToService=2
SlurmdTimeout=60
MinJobAge=300
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory={memory} State=UNKNOWN
PartitionName=main Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def missing() -> str:
    """What keeps a private Slurm from being started; empty where nothing does."""
    lacking = [name for name in PROGRAMS if shutil.which(name) is None]
    if lacking:
        return f"{', '.join(lacking)}: not installed; as root: apt-get install slurm-wlm munge"
    if os.geteuid() != 0:
        return "a private Slurm is started by root alone; run it as root"
    if CONFIGURATION.exists():
        return f"{CONFIGURATION}: this machine has a Slurm of its own; run it elsewhere"
    return ""


def _free_port() -> int:
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        port: int = found.getsockname()[1]
        return port


def slurm(*command: str) -> str:
    """What a command of Slurm prints."""
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    return done.stdout


@dataclass
class Cluster:
    """The daemons of a Slurm whose files are in `folder`."""

    folder: Path
    running: dict[str, subprocess.Popen[bytes]] = field(default_factory=dict)
    host: str = field(default_factory=lambda: socket.gethostname().partition(".")[0])

    def start(self) -> None:
        """Write the configuration, start everything, and wait until the node takes jobs."""
        for name in ("state", "spool", "seed"):
            (self.folder / name).mkdir()
        self.folder.chmod(0o755)
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o600)
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // 2**20
        CONFIGURATION.parent.mkdir(exist_ok=True)
        CONFIGURATION.write_text(
            TEXT.format(
                host=self.host,
                folder=self.folder,
                ports=(_free_port(), _free_port()),
                cpus=os.cpu_count(),
                memory=memory * 9 // 10,
            )
        )
        self.start_munge(key)
        self.start_controller()
        self.run("slurmd", "slurmd", "-D", "-N", self.host)
        self.wait_for(lambda: "idle" in slurm("sinfo", "--noheader", "--format=%T"))

    def start_munge(self, key: Path) -> None:
        paths = {
            "key-file": key,
            "socket": self.folder / "munge.socket",
            "pid-file": self.folder / "munge.pid",
            "log-file": self.folder / "munge.log",
            "seed-file": self.folder / "seed/munge.seed",
        }
        options = [f"--{name}={path}" for name, path in paths.items()]
        self.run("munged", "munged", "--foreground", "--force", *options)
        self.wait_for(paths["socket"].exists)

    def start_controller(self) -> None:
        self.run("slurmctld", "slurmctld", "-D")
        self.wait_for(lambda: "UP" in slurm("scontrol", "ping"))

    def run(self, name: str, *command: str) -> None:
        log = (self.folder / f"{name}.out").open("ab")
        with log:
            self.running[name] = subprocess.Popen(command, stdout=log, stderr=log)

    def kill(self, name: str) -> None:
        """Kill a daemon, as a failure would."""
        daemon = self.running.pop(name)
        daemon.send_signal(signal.SIGKILL)
        daemon.wait()

    def remembers(self, name: str) -> bool:
        """Whether jobs of this name outlive the controller, which writes its state seconds late."""
        return name.encode() in (self.folder / "state/job_state").read_bytes()

    def stop(self) -> None:
        """Cancel what runs, stop the daemons, and remove the configuration."""
        try:
            subprocess.run(["scancel", "--user=root"], check=False, capture_output=True, timeout=30)
            for name in ("slurmd", "slurmctld", "munged"):
                if name in self.running:
                    daemon = self.running.pop(name)
                    daemon.terminate()
                    daemon.wait(timeout=60)
        finally:
            CONFIGURATION.unlink(missing_ok=True)

    def wait_for(self, reached: Callable[[], object], seconds: float = 600.0) -> None:
        """Wait until something holds, or fail with the logs."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                if reached():
                    return
            except (subprocess.SubprocessError, FileNotFoundError):
                pass  # Slurm does not answer, or is about to put a file in the place of another
            time.sleep(0.2)
        raise TimeoutError("\n".join(p.read_text()[-2000:] for p in self.folder.glob("*.out")))
