"""Call the function that a job names, with its named files and its parameters as keywords."""

import inspect
from pkgutil import resolve_name

from planar_pushing.study.running.jobs import job_log

given = dict(snakemake.params.items())
for shown in ("code", "caption", "promise"):  # for Snakemake and its report
    given.pop(shown, None)

with job_log(snakemake.log[0]):
    function = resolve_name(f"planar_pushing.{given.pop('call')}")
    if "threads" in inspect.signature(function).parameters:
        given["threads"] = snakemake.threads
    function(**dict(snakemake.input.items()), **dict(snakemake.output.items()), **given)
