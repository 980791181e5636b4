"""Write the tables that the report is set from."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]):
    from pathlib import Path

    from planar_pushing.evidence.writing import write_text
    from planar_pushing.report import tables
    from planar_pushing.report.costs.tables import COST_TABLES
    from planar_pushing.report.results import Results

    results = Results(Path(snakemake.params.results), Path(snakemake.params.golden))
    texts = {
        "numbers": tables.numbers_text(results),
        "figures": tables.figures_text(results),
        "cones": tables.cones_text(results),
        "ellipsoids": tables.ellipsoids_text(results),
        "verdict": tables.verdict_text(results),
        "provenance": tables.provenance_text(results, snakemake.input.study),
    }
    texts |= {name: text(results) for name, text in COST_TABLES.items()}
    for name, text in texts.items():
        write_text(text, snakemake.output[name])
