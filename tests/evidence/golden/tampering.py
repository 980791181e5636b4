"""Random changes of a dataset, each of which a check must see."""

import numpy as np

#: Relative change of a number.
CHANGE = 1e-9
#: Attributes that say what numbers mean.
MARKS = ("units", "long_name", "flag_values", "flag_meanings")


def chosen(dataset, kinds, random):
    """A random variable or coordinate of some types, or None."""
    names = [name for name, each in dataset.variables.items() if each.dtype.kind in kinds]
    return str(random.choice(names)) if names else None


def replaced(dataset, name, values):
    """The dataset with other values of a variable or coordinate."""
    changed = dataset.copy()
    changed[name] = (dataset[name].dims, values, dataset[name].attrs)
    return changed


def place(values, allowed, random):
    """A random place where a change is allowed, or None."""
    places = np.flatnonzero(allowed)
    return np.unravel_index(random.choice(places), values.shape) if places.size else None


def value(dataset, random):
    """One number by 1e-9 of itself, one count by one, one flag turned."""
    name = chosen(dataset, "fiub", random)
    values = dataset[name].values.copy()
    moves = np.isfinite(values) & (values != 0) if values.dtype.kind == "f" else values == values
    at = place(values, moves, random)
    if at is None:
        return None
    old = values[at]
    values[at] = {"f": old * (1 + CHANGE), "b": not old}.get(values.dtype.kind, old + 1)
    return replaced(dataset, name, values), f"{name} at {at}: {old!r}"


def not_a_number(dataset, random):
    name = chosen(dataset, "f", random)
    if name is None:
        return None
    values = dataset[name].values.copy()
    at = place(values, ~np.isnan(values), random)
    if at is None:
        return None
    values[at] = np.nan
    return replaced(dataset, name, values), f"{name} at {at}: NaN"


def filled(dataset, random):
    """Zero in place of what is not there."""
    names = [name for name, each in dataset.variables.items() if each.dtype.kind == "f"]
    names = [name for name in names if np.isnan(dataset[name].values).any()]
    if not names:
        return None
    name = str(random.choice(names))
    values = dataset[name].values.copy()
    at = place(values, np.isnan(values), random)
    values[at] = 0.0
    return replaced(dataset, name, values), f"{name} at {at}: 0 for NaN"


def deleted(dataset, random):
    name = str(random.choice(list(dataset.variables)))
    return dataset.drop_vars(name), f"{name}: deleted"


def marked(dataset, random):
    """A unit, a meaning or the value of a flag."""
    name = str(random.choice(list(dataset.variables)))
    marks = [mark for mark in MARKS if mark in dataset[name].attrs]
    if not marks:
        return None
    mark = str(random.choice(marks))
    changed = dataset.copy()
    old = dataset[name].attrs[mark]
    changed[name].attrs = dataset[name].attrs | {mark: other(old)}
    return changed, f"{name}: {mark}"


def retold(dataset, random):
    """What a dataset says of itself as a whole."""
    key = str(random.choice(list(dataset.attrs)))
    return dataset.assign_attrs({key: other(dataset.attrs[key])}), f": attribute {key}"


def other(mark):
    return f"{mark}s" if isinstance(mark, str) else np.asarray(mark) + 1


#: How often each kind is drawn.
KINDS = {value: 0.55, not_a_number: 0.1, filled: 0.05, deleted: 0.1, marked: 0.15, retold: 0.05}


def tampered(dataset, random):
    """A dataset with one random change, and what it is."""
    while True:
        found = random.choice(list(KINDS), p=list(KINDS.values()))(dataset, random)
        if found:
            return found
