"""Studies: their tables as data frames, their trials simulated again."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

import pandas

from impetus import _impetus

_KINDS = {"integer": "Int64", "number": "float64"}


def _column(column: dict[str, Any]) -> pandas.Series:
    kind = _KINDS.get(column["type"])
    if kind is None:  # texts, and levels of factors: numbers, where all are
        return pandas.Series(column["values"], dtype=object).infer_objects()
    return pandas.Series(column["values"], dtype=kind)


class Study:
    """A study file, open for reading.

    Each table of `impetus export` is an attribute, and `table(name)`: a data frame with the same
    values. What its columns mean is in `attrs`: "rows" (what a row is), "units" and "meanings" by
    column. A table is read when it is asked for, so gaze, steps and frames cost nothing before.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._file = _impetus.StudyFile(os.fspath(path))

    @property
    def name(self) -> str:
        """The file's name."""
        return self._file.name

    @property
    def tables(self) -> list[str]:
        """The names of its tables."""
        return _impetus.table_names()

    def table(self, name: str) -> pandas.DataFrame:
        """One table as a data frame. Raises InputError where there is none of that name."""
        told = self._file.table(name)
        columns = told["columns"]
        frame = pandas.DataFrame({key: _column(column) for key, column in columns.items()})
        frame.attrs["rows"] = told["rows"]
        frame.attrs["units"] = {k: c["unit"] for k, c in columns.items() if c["unit"]}
        frame.attrs["meanings"] = {k: c["meaning"] for k, c in columns.items()}
        return frame

    def __getattr__(self, name: str) -> pandas.DataFrame:
        if name.startswith("_") or name not in _impetus.table_names():
            raise AttributeError(f"a study has no table {name}; it has {', '.join(self.tables)}")
        return self.table(name)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.tables]

    def replay(self, trial: int, attempt: int | None = None, interval: int = 1) -> _impetus.Replay:
        """Simulates a recorded trial again: an iterator over its steps, each with positions,
        orientations, the hash and the recorded hash. `trial` is the `id` of its row; `attempt`
        None: the one that was completed, else the last."""
        return self._file.replay(trial, attempt, interval)

    def what_if(
        self,
        trial: int,
        settings: Mapping[str, Any],
        attempt: int | None = None,
        interval: int = 1,
    ) -> dict[str, Any]:
        """What would have happened in a recorded trial under other settings of the engine, as
        `impetus replay --with ... --json` has it: {"scheduler": "distance"}, or a JSON Pointer below /engine."""
        given = [f"{key}={_text(value)}" for key, value in settings.items()]
        return self._file.what_if(trial, given, attempt, interval)

    def __repr__(self) -> str:
        return f"<study {self.name}>"


def _text(value: Any) -> str:
    return value if isinstance(value, str) else json.dumps(value, default=lambda number: number.item())


def read(path: str | os.PathLike[str]) -> Study:
    """Opens a study file for reading. Raises InputError where it is none."""
    return Study(path)
