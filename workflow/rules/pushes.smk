# Measured pushes: two figures, drawn from numbers stored in the project. `snakemake pushes --config
# data=FOLDER` first computes these numbers from a folder of published logs.
rule pushes_figures:
    input:
        (
            expand(
                "{results}/figures/{name}.{kind}",
                results=CERTIFIED,
                name=PUSHES,
                kind=KINDS,
            )
            if Path(PUSHES_FILE).is_file()
            else []
        ),


rule pushes_figure:
    input:
        source=PUSHES_FILE,
    output:
        svg=report(
            "{results}/figures/{figure}.svg",
            category="Measured pushes",
            caption="../report/file_figure.rst",
            labels={"figure": "{figure}"},
        ),
        pdf="{results}/figures/{figure}.pdf",
        png="{results}/figures/{figure}.png",
    log:
        "{results}/logs/figures/{figure}.log",
    benchmark:
        "{results}/benchmarks/figures/{figure}.tsv"
    wildcard_constraints:
        figure=one_of(PUSHES),
    params:
        call="figures.render:pushes_figure",
        code=figure_code,
        name="{figure}",
        title=lambda wildcards: entry(wildcards.figure).title,
    message:
        "Drawing {wildcards.figure}"
    script:
        "../scripts/run.py"


if DATA is not None:

    rule measured_pushes:
        input:
            LOGS,
        output:
            json=update(PUSHES_FILE),
            files=DIGESTS,
        log:
            f"{WHOLE or chosen_results(config)}/logs/pushes/measured_pushes.log",
        params:
            call="evidence.measured:measure",
            code=code_of("evidence.measured"),
            folder=DATA,
        message:
            "Evaluating the pushes of {params.folder}"
        script:
            "../scripts/run.py"


rule pushes:
    input:
        measured_files,
        rules.pushes_figures.input,
