"""A job's log tells how it ended, from its imports on; run in a process of its own, as a job is."""

import subprocess
import sys

import pytest

JOB = """
from pulling_by_pushing.study.running.jobs import job_log
with job_log({log!r}) as log:
    {body}
"""
ENDS = {
    "log.info('%d points', 3)": (0, "INFO 3 points"),
    "import planar_pushing.absent": (1, "ModuleNotFoundError: No module named"),
    "raise ValueError('by hand')": (1, "ValueError: by hand"),
    "import os, signal; os.kill(os.getpid(), signal.SIGTERM)": (1, "ERROR terminated"),
    "raise KeyboardInterrupt": (1, "ERROR interrupted"),
}


def run(body, log):
    script = JOB.format(body=body, log=str(log))
    return subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)


@pytest.mark.parametrize("body", ENDS)
def test_a_log_says_how_a_job_ended(body, tmp_path):
    status, said = ENDS[body]
    log = tmp_path / "job.log"
    assert run(body, log).returncode == status
    lines = log.read_text(encoding="utf-8")
    assert lines.startswith("INFO Python 3.")
    assert said in lines
    assert ("INFO done in" in lines) == (status == 0)


def test_an_error_of_ours_is_one_line_without_a_traceback(tmp_path):
    log = tmp_path / "job.log"
    body = "import pulling_by_pushing.study.store as s; s.read_dataset('absent.nc')"
    ended = run(body, log)
    assert ended.returncode == 1
    assert not ended.stderr
    said = log.read_text(encoding="utf-8").splitlines()[1:]
    assert said == ["ERROR absent.nc: no such dataset; build it with make or snakemake"]
