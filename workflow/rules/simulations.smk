# Motion over time: a log and a figure for each scene file that the study simulates.
rule simulations:
    input:
        expand(
            "<results>/data/simulations/{simulation}.nc", simulation=STUDY.simulations
        ),
        expand(
            "<results>/figures/simulation_{simulation}.{kind}",
            simulation=STUDY.simulations,
            kind=["svg", "pdf", "png"],
        ),


rule simulation:
    input:
        scene=lambda wildcards: STUDY.simulations[wildcards.simulation],
    output:
        "<results>/data/simulations/{simulation}.nc",
    log:
        "<results>/logs/data/simulation_{simulation}.log",
    benchmark:
        "<results>/benchmarks/data/simulation_{simulation}.tsv"
    priority: FIRST
    params:
        code=code_of("study.simulations", "study.storage.store", "study.describe"),
        provenance=PROVENANCE,
    message:
        "Simulating {wildcards.simulation}"
    script:
        "../scripts/simulation.py"


rule simulation_figure:
    input:
        data="<results>/data/simulations/{simulation}.nc",
        style="src/planar_pushing/figures/paper.mplstyle",
    output:
        svg=report(
            "<results>/figures/simulation_{simulation}.svg",
            category="Motion over time",
            caption="../report/simulation.rst",
            labels={"figure": "{simulation}"},
        ),
        pdf="<results>/figures/simulation_{simulation}.pdf",
        png="<results>/figures/simulation_{simulation}.png",
    log:
        "<results>/logs/figures/simulation_{simulation}.log",
    benchmark:
        "<results>/benchmarks/figures/simulation_{simulation}.tsv"
    priority: LAST
    params:
        code=code_of("figures.motion.simulation"),
    message:
        "Drawing the simulation {wildcards.simulation}"
    script:
        "../scripts/simulation_figure.py"
