"""The smoke study in chunks on a private Slurm: `make test-slurm`.

Whatever is lost on the way, a run ends with the bytes of one on this machine alone.
"""

import os
import re
import signal
import subprocess
import time

import pytest
from workflow.chunked import ENVIRONMENT, RESULTS, command, copy_workflow, files
from workflow.cluster import Cluster, missing, slurm

pytestmark = pytest.mark.alone

CHUNKS = "chunks: {contact_modes: {pusher_angle: 13, contact: 4}}\n"
TARGET = f"{RESULTS}/data/contact_modes.nc"
#: Chunks of contact modes.
NUMBER = 4


@pytest.fixture(scope="session", autouse=True)
def cluster(tmp_path_factory):
    lacking = missing()
    if lacking:
        pytest.skip(lacking)
    found = Cluster(tmp_path_factory.mktemp("slurm"))
    try:
        found.start()
        yield found
    finally:
        found.stop()


class Run:
    """A run of the workflow in a folder of its own."""

    def __init__(self, root):
        self.root = copy_workflow(root, CHUNKS)
        self.started = []

    def start(self, *arguments):
        with (self.root / "said").open("a") as log:
            process = subprocess.Popen(
                command(*arguments), cwd=self.root, env=ENVIRONMENT, stdout=log, stderr=log,
                start_new_session=True,
            )  # fmt: skip
        self.started.append(process)
        return process

    def submit(self, *targets):
        wait = ("--slurm-init-seconds-before-status-checks", "2", "--latency-wait", "10")
        return self.start("--profile", "profiles/slurm", *wait, *targets)

    @property
    def said(self):
        return (self.root / "said").read_text(encoding="utf-8")

    def ends(self, process):
        assert process.wait(timeout=900) == 0, self.said

    def done(self):
        """How often each rule ended."""
        found = re.findall(r"Finished jobid: \d+ \(Rule: (\w+)\)", self.said)
        return {rule: found.count(rule) for rule in found}

    def kill(self):
        """End what a test that failed has left."""
        for process in self.started:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()


@pytest.fixture(scope="session")
def local(tmp_path_factory):
    """Files of a run on this machine."""
    run = Run(tmp_path_factory.mktemp("local"))
    run.ends(run.start("--cores", "2", "data"))
    return files(run.root)


@pytest.fixture
def run(tmp_path, cluster):
    found = Run(tmp_path)
    yield found
    found.kill()
    slurm("scancel", "--user=root")
    cluster.wait_for(lambda: not slurm("squeue", "--noheader"))


def assert_same(run, local):
    found = files(run.root)
    assert found == {name: local[name] for name in found}
    assert sum("chunks/" in name for name in found) == NUMBER


def chunk_jobs():
    """Tasks of Slurm that compute, by their number in the queue."""
    lines = slurm("squeue", "--noheader", "--array", "--states=RUNNING", "--format=%i|%k").split()
    return [line.split("|")[0] for line in lines if "rule_chunk" in line]


def wait_until_one_computes(cluster):
    cluster.wait_for(chunk_jobs)
    return chunk_jobs()[0]


def test_a_run_ends_with_the_bytes_of_a_local_one(run, local):
    run.ends(run.submit("data"))
    assert files(run.root) == local
    assert re.search(r"Submitted array job with Snakemake IDs", run.said)
    run.ends(run.start("--cores", "1", "--dry-run", "data"))
    assert "Nothing to be done" in run.said


def test_a_cancelled_job_is_submitted_again(cluster, run, local):
    process = run.submit(TARGET)
    slurm("scancel", wait_until_one_computes(cluster))
    run.ends(process)
    assert_same(run, local)
    assert run.done()["chunk"] == NUMBER
    assert "Trying to restart job" in run.said


def test_a_drained_node_goes_on_when_it_is_resumed(cluster, run, local):
    process = run.submit(TARGET)
    wait_until_one_computes(cluster)
    node = f"nodename={cluster.host}"
    slurm("scontrol", "update", node, "state=drain", "reason=test")
    try:
        cluster.wait_for(lambda: not chunk_jobs())
        time.sleep(3)
        assert process.poll() is None
    finally:
        slurm("scontrol", "update", node, "state=resume")
    run.ends(process)
    assert_same(run, local)
    assert run.done()["chunk"] == NUMBER


def test_the_controller_may_be_killed_and_started_again(cluster, run, local):
    process = run.submit(TARGET)
    wait_until_one_computes(cluster)
    name = slurm("squeue", "--noheader", "--format=%j").split()[0]
    cluster.wait_for(lambda: cluster.remembers(name))
    cluster.kill("slurmctld")
    time.sleep(5)
    cluster.start_controller()
    run.ends(process)
    assert_same(run, local)
    assert run.done()["chunk"] == NUMBER


def test_the_submitting_process_may_be_killed_and_started_again(cluster, run, local):
    process = run.submit(TARGET)
    wait_until_one_computes(cluster)
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    run.ends(run.submit(TARGET))
    assert_same(run, local)
    assert run.done()["contact_modes"] == 1
