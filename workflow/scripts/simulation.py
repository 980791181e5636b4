"""Simulate one scene file over time."""

from planar_pushing.study.running.jobs import job_log

with job_log(snakemake.log[0]) as log:
    from planar_pushing.study.describe import of_study
    from planar_pushing.study.files.scenes import load_scene_file
    from planar_pushing.study.simulations import simulate_file
    from planar_pushing.study.storage.store import write_dataset

    log.info("simulating %s", snakemake.wildcards.simulation)
    found = simulate_file(load_scene_file(snakemake.input.scene))
    found = of_study(found, snakemake.wildcards.simulation, snakemake.params.provenance)
    write_dataset(found, snakemake.output[0])
