"""Write the tables that the report is set from."""

from pathlib import Path

from planar_pushing.report import tables
from planar_pushing.report.results import Results
from planar_pushing.study.jobs import job_log

with job_log(snakemake.log[0]):
    results = Results(Path("results"), Path(snakemake.params.golden))
    texts = {
        "numbers": tables.numbers_text(results),
        "figures": tables.figures_text(results),
        "cones": tables.cones_text(results),
        "verdict": tables.verdict_text(results),
        "provenance": tables.provenance_text(results, snakemake.input.study),
    }
    for name, text in texts.items():
        tables.write_text(text, snakemake.output[name])
