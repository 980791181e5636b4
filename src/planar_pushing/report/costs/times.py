"""Numbers that are times: the minimum over repeated runs on one machine."""

from __future__ import annotations

import json
import re
from collections.abc import Callable

import numpy as np
import numpy.typing as npt
import xarray as xr

from planar_pushing.report.quantities import Numbers, computed

NANO, MICRO, MILLI = 1e9, 1e6, 1e3


def machine(data: xr.Dataset) -> dict[str, str]:
    """Machine on which a dataset was measured, as stored in it."""
    found: dict[str, str] = json.loads(data.attrs["machine"])
    return found


def processor(data: xr.Dataset) -> str:
    """Processor on which a dataset was measured, without the marks of trademarks."""
    return re.sub(r"\((R|TM)\)", "", machine(data)["processor"])


def _least(data: xr.Dataset, times: str, name: str) -> npt.NDArray[np.float64]:
    """Minimum times of a method at its last setting, seconds."""
    return np.asarray(data[times][data.method.values == name][-1].min("repeat").values)


def wrench_time(
    wrench: xr.Dataset, name: str, which: Callable[[npt.NDArray[np.float64]], float], per: float
) -> float:
    """Extreme over the spin ratios of the minimum time for a wrench, most accurate setting."""
    return per * float(which(_least(wrench, "wrench_seconds", name)))


def time_range(
    dataset: str, prefix: str, name: str, per: float = NANO, unit: str = "ns"
) -> Numbers:
    """Smallest and largest time of a method for the wrench over the spin ratios of a dataset."""
    ends = {"least": np.min, "most": np.max}
    return {
        f"{prefix}-{end}": computed(dataset, wrench_time, name, which, per, unit=unit)
        for end, which in ends.items()
    }


def wrench_time_at(wrench: xr.Dataset, name: str, spin_ratio: float, per: float) -> float:
    """Minimum time for a wrench at one spin ratio, most accurate setting."""
    return wrench_time(wrench.sel(spin_ratio=[spin_ratio]), name, np.min, per)


def wrench_ratio(wrench: xr.Dataset, name: str) -> float:
    """Smallest ratio over the spin ratios of a method's time for a wrench to that of the closed form."""
    ours, other = (_least(wrench, "wrench_seconds", each) for each in ("closed form", name))
    return float(np.min(other / ours))


def cone_time(cone: xr.Dataset, name: str) -> float:
    """Minimum time for both edges of a motion cone, most accurate setting, microseconds."""
    return MICRO * float(_least(cone, "cone_seconds", name))


def cone_ratio(cone: xr.Dataset, name: str) -> float:
    """Ratio of the minimum time for a motion cone to that of the closed form."""
    return cone_time(cone, name) / cone_time(cone, "closed form")


def _run(motion: xr.Dataset, method: str, setting: float) -> xr.Dataset:
    """Row of a method at a setting, for the slipping scene."""
    here = (motion.method.values == method) & np.isclose(motion.setting.values, setting, atol=0.0)
    return motion.isel(point=int(np.flatnonzero(here)[0])).sel(scene="slipping")


def run_time(motion: xr.Dataset, method: str, setting: float) -> float:
    """Minimum time for a run of the slipping scene, milliseconds."""
    return MILLI * float(_run(motion, method, setting).motion_seconds.min())


def run_error(motion: xr.Dataset, method: str, setting: float) -> float:
    """Error of the final rod angle of the slipping scene, degrees."""
    return float(_run(motion, method, setting).motion_error)


def both_ratio(effects: xr.Dataset, operation: str) -> float:
    """Ratio of the minimum time with both effects to the sum of the times with one effect, one slider."""
    here = (effects.scene.values == "one slider") & (effects.operation.values == operation)
    times = effects.time[np.flatnonzero(here)].min("repeat").values
    both = np.char.count(effects.effects.values[here].astype(str), "+") > 0
    return float(times[both].sum() / times[~both].sum())


def _divided(effects: xr.Dataset) -> xr.Dataset:
    """Cases of friction that is divided among equal supports."""
    return effects.isel(case=np.flatnonzero(effects.scene.values == "equal supports"))


def most_supports(effects: xr.Dataset) -> float:
    """Largest number of supports among which friction is divided."""
    return float(_divided(effects).number.max())


def divided_ratio(effects: xr.Dataset) -> float:
    """Ratio of the minimum time with the most supports to that with one."""
    times = _divided(effects).set_index(case="number").time.min("repeat")
    return float(times.sel(case=times.case.max()) / times.sel(case=1))
