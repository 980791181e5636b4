rule golden:
    input:
        [],
