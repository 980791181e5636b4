"""Units and long names, one table."""
def attributes(name):
    return {}
