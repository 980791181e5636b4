# Motion over time: a log and a figure for each scene file that the study simulates.
rule simulations:
    input:
        expand(
            "<results>/data/simulations/{simulation}.nc", simulation=STUDY.simulations
        ),
        expand(
            "<results>/figures/simulation_{simulation}.{kind}",
            simulation=STUDY.simulations,
            kind=KINDS,
        ),


# What the scene file says is among the marks; its layout reruns nothing, so it is no input.
rule simulation:
    output:
        path="<results>/data/simulations/{simulation}.nc",
    log:
        "<results>/logs/data/simulation_{simulation}.log",
    benchmark:
        "<results>/benchmarks/data/simulation_{simulation}.tsv"
    priority: FIRST
    params:
        call="study.running.builds:simulation",
        code=code_of("simulation"),
        name="{simulation}",
        scene=lambda wildcards: STUDY.simulations[wildcards.simulation],
        marks=marks_of(STUDY_FILE),
    message:
        "Simulating {wildcards.simulation}"
    script:
        "../scripts/run.py"


rule simulation_figure:
    input:
        source="<results>/data/simulations/{simulation}.nc",
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
        call="figures.jobs:simulation_figure",
        code=code_of("figure"),
    message:
        "Drawing the simulation {wildcards.simulation}"
    script:
        "../scripts/run.py"
