# Measured pushes: two figures, drawn from numbers stored in the project. `snakemake pushes --config
# data=FOLDER` first computes these numbers from a folder of published logs.


if DATA is not None:

    rule measured_pushes:
        input:
            LOGS,
        output:
            json=update(PUSHES_FILE),
            files=DIGESTS,
        log:
            f"{WHOLE or chosen_results(config)}/logs/pushes/measured_pushes.log",
        threads: workflow.cores
        params:
            **runs("evidence.measured:measure"),
            folder=DATA,
        message:
            "Evaluating the pushes of {params.folder}"
        script:
            RUN


rule pushes_figures:
    input:
        expand(
            "{results}/figures/{name}.{kind}",
            results=CERTIFIED if Path(PUSHES_FILE).is_file() else [],
            name=PUSHES,
            kind=KINDS,
        ),


rule pushes:
    input:
        measured_files,
        rules.pushes_figures.input,
