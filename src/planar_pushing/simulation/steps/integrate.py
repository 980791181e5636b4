class TimeStepping:
    pass
