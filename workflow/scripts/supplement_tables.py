"""Write the tables that the supplement on time is set from."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]):
    from pathlib import Path

    from planar_pushing.evidence.writing import write_text
    from planar_pushing.report.results import Results
    from planar_pushing.report.supplement import TABLES

    results = Results(Path(snakemake.params.results), Path(snakemake.params.golden))
    for path in snakemake.output:
        write_text(TABLES[Path(path).name](results), path)
