"""The result of `assess_push`, and its table."""

from __future__ import annotations

import html
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from planar_pushing.assessment.methods import settings_of
from planar_pushing.mechanics.kernels.arrays import same
from planar_pushing.mechanics.scene import Scene
from planar_pushing.terms.netcdf import write_dataset
from planar_pushing.terms.options import Method
from planar_pushing.terms.replacing import PathLike

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Lengths in meters are told in millimeters.
MILLIMETERS = 1000.0


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class PushAssessment:
    """Which effects a push calls for, what accuracy costs, and how sure the answer is.

    Printing it shows a table, a notebook shows the same, and `plot` draws it. The change of a pose is the
    largest displacement over the outline: one number for displacement and rotation.

    Attributes
    ----------
    effects : xarray.Dataset
        Over `effect`, those of the scene and the candidates. `force_share` and `torque_share`: force
        and torque as shares of those of friction, which 95 percent of the run do not exceed.
        `stopping`: how far the slider would coast from the largest speed and spin of the run, zero
        without inertia. `estimate`: the stopping length, plus the shares times the way of the farthest
        point. `pose_change`: without the effect, over all times; `pose_change_near`: the same, or that
        with the contact moved by `change`, whichever is larger, since symmetry hides effects. `modes`:
        the contact modes without the effect. `needed`: whether the effect is listed in `scene`.
        `speed_limit`: about the speed of the pusher up to which inertia can be left out, NaN if no law
        gives it. Attributes tell the modes and evaluations with all effects and with those needed, and
        the change of the pose by leaving out all others together.
    methods : xarray.Dataset
        Over `setting`, for `scene`: `method`, `value` (relative tolerance, or number of steps), `error`
        of the final pose, `evaluations` of the right-hand side, and `seconds` of processor time of a
        run without its log. Attributes: `cheapest`, the index of the fastest setting that holds the
        tolerance, or -1; `log_seconds`, which each run of `simulate` takes besides; and `machine`.
    inputs : xarray.Dataset
        Over `input` and `side`, for `scene`: `change` of the final pose if the input is off to one
        side; over `input` its `kink`, 0 if both slopes agree, and `same_modes`. The attribute
        `change_together` is the sum over the inputs of the larger changes, which bounds the change if
        all of them are off.
    scene : Scene
        The scene with the needed effects alone, for `simulate` and `simulate_batch`.
    tolerance : float
        Largest change of the pose that does not matter, in the scene's unit of length.
    duration : float
        Simulated time.
    warnings : tuple of str
        Reasons not to trust one trajectory, and runs that end early.
    """

    effects: xr.Dataset
    methods: xr.Dataset
    inputs: xr.Dataset
    scene: Scene
    tolerance: float
    duration: float
    warnings: tuple[str, ...]

    def __eq__(self, other: object) -> Any:
        return same(self, other)

    def __repr__(self) -> str:
        return self.table()

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self.table())}</pre>"

    @property
    def settings(self) -> dict[str, Any]:
        """Arguments of `simulate` for the cheapest setting; empty if none holds the tolerance.

        `rtol`, or `method` and `step`.
        """
        return settings_of(self.methods, self.duration)

    @property
    def unit(self) -> tuple[float, str]:
        """Factor and unit of the lengths of the table: millimeters for meters, else the scene's unit."""
        if self.scene.units is None:
            return 1.0, "length"
        name = self.scene.units.length
        return (MILLIMETERS, "mm") if name == "m" else (1.0, name)

    def table(self) -> str:
        """The assessment as text: effects, methods, inputs and warnings."""
        blocks = self._effects(), self._methods(), self._inputs()
        lines = [line for block in blocks for line in block]
        return "\n".join([*lines, *(f"warning: {warning}" for warning in self.warnings)])

    def to_netcdf(self, path: PathLike) -> None:
        """Write `effects`, `methods` and `inputs` as groups of a netCDF file.

        Raises
        ------
        InvalidFile
            If the file cannot be written.
        """
        root = xr.Dataset(attrs={
            "title": "assessment of a push", "tolerance": self.tolerance, "duration": self.duration,
            "length_unit": self.scene.units.length if self.scene.units else "length",
            "needed": " ".join(self._needed()), "warnings": "\n".join(self.warnings),
        })  # fmt: skip
        groups = {"effects": self.effects, "methods": self.methods, "inputs": self.inputs}
        write_dataset({"/": root} | {f"/{name}": data for name, data in groups.items()}, path)

    def plot(self, axes: Any = None) -> list[Axes]:
        """Draw the three answers side by side: effects, methods, inputs.

        Parameters
        ----------
        axes : sequence of three matplotlib.axes.Axes, optional
            By default those of a new figure.

        Returns
        -------
        list of matplotlib.axes.Axes
        """
        from planar_pushing.drawing.assessment import plot_assessment

        return plot_assessment(
            self.effects, self.methods, self.inputs, self.tolerance, self.unit, axes
        )

    def _needed(self) -> list[str]:
        return [str(name) for name in self.effects["effect"].values[self.effects["needed"].values]]

    def _effects(self) -> list[str]:
        """Lines on the effects."""
        factor, unit = self.unit
        head = [
            [
                "effect",
                "share of",
                "friction",
                "stopping",
                "estimate",
                "pose without",
                "and near",
                "",
                "",
            ],
            ["", "force", "torque", unit, unit, unit, unit, "", "modes without"],
        ]
        rows = []
        for name in self.effects["effect"].values:
            row = self.effects.sel(effect=name)
            shares = [_number(row[key]) for key in ("force_share", "torque_share")]
            names = ("stopping", "estimate", "pose_change", "pose_change_near")
            lengths = [_number(row[key] * factor) for key in names]
            verdict = "list it" if row["needed"] else "leave it out"
            rows.append([str(name), *shares, *lengths, verdict, str(row["modes"].item())])
        attrs = self.effects.attrs
        counts = attrs["evaluations_of_needed"], attrs["evaluations"]
        together = _number(attrs["change_together"] * factor)
        lines = [
            *_columns([*head, *rows], left=(0, 7, 8)),
            f"modes with all effects: {attrs['modes']}",
        ]
        lines.append(
            f"effects needed for {_number(self.tolerance * factor)} {unit}: {', '.join(self._needed())}; "
            f"off by {together} {unit}, {counts[0]} evaluations instead of {counts[1]}"
        )
        return lines + self._limits()

    def _limits(self) -> list[str]:
        """Lines on the speeds up to which inertia can be left out."""
        known = self.effects.isel(effect=np.isfinite(self.effects["speed_limit"].values))
        units = self.scene.units
        of_speed = f" {units.length}/{units.time}" if units else ""
        return [
            f"{name} can be left out up to a speed of about {_number(limit)}{of_speed}"
            for name, limit in zip(known["effect"].values, known["speed_limit"].values, strict=True)
        ]

    def _methods(self) -> list[str]:
        """Lines on the methods."""
        factor, unit = self.unit
        rows = [["method", "rtol or steps", f"error {unit}", "evaluations", "ms", ""]]
        for i in range(self.methods.sizes["setting"]):
            row = self.methods.isel(setting=i)
            is_event_driven = row["method"].item() == Method.EVENT_DRIVEN
            value = (
                f"{row['value'].item():.0e}" if is_event_driven else f"{row['value'].item():.0f}"
            )
            rows.append([
                row["method"].item(), value, f"{row['error'].item() * factor:.1e}",
                str(row["evaluations"].item()), f"{row['seconds'].item() * 1e3:.2f}",
                "cheapest" if i == self.methods.attrs["cheapest"] else "",
            ])  # fmt: skip
        log = f"each run of simulate adds {self.methods.attrs['log_seconds'] * 1e3:.1f} ms for its log"
        return [*_columns(rows, left=(0, 5)), log]

    def _inputs(self) -> list[str]:
        """Lines on the inputs."""
        factor, unit = self.unit
        part = f"{self.inputs.attrs['change_of_inputs'] * 100:g} %"
        rows = [["input", f"+{part} {unit}", f"-{part} {unit}", "kink", ""]]
        for name in self.inputs["input"].values:
            row = self.inputs.sel(input=name)
            changes = [_number(change * factor) for change in row["change"].values]
            kink = f"{row['kink'].item() * 100:.0f} %"
            rows.append([str(name), *changes, kink, "" if row["same_modes"] else "other modes"])
        together = _number(self.inputs.attrs["change_together"] * factor)
        return [
            *_columns(rows, left=(0, 4)),
            f"all inputs off together: at most about {together} {unit}",
        ]


def _number(value: Any) -> str:
    """Three digits; a dash for what is not known, or does not exist."""
    number = float(value)
    return f"{number:.3g}" if np.isfinite(number) else "-"


def _columns(rows: Sequence[Sequence[str]], left: Collection[int]) -> list[str]:
    """Lines with the cells of rows in columns, aligned on the right but for those on the left."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = []
    for row in rows:
        cells = [
            cell.ljust(width) if i in left else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        lines.append("  ".join(cells).rstrip())
    return lines
