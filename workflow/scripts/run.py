"""Call the function named by a job, with its named files and parameters as keyword arguments."""

import os
import sys
from pkgutil import resolve_name

if os.environ.get("PLANAR_PUSHING_DASK") == "no":
    sys.modules["dask"] = None  # not imported by xarray, as no grid of this run is divided

from pulling_by_pushing.study.running.jobs import job_log

if __name__ == "__main__":  # processes that a job starts read this file again, without a job
    arguments = dict(snakemake.params.items())
    for name in ("code", "captions"):  # for Snakemake and its report
        arguments.pop(name, None)
    arguments |= arguments.pop("values", {})

    with job_log(snakemake.log[0]):
        function = resolve_name(f"pulling_by_pushing.{arguments.pop('call')}")
        function(**dict(snakemake.input.items()), **dict(snakemake.output.items()), **arguments)
