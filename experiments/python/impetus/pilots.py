"""Pilots: sessions in which Python answers, or decides what is refined first. Nothing is recorded."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import pandas

from impetus import _impetus

Observer = Callable[[Mapping[str, Any], Sequence[Mapping[str, Any]]], Any]
Metric = Callable[[_impetus.Pair], float]


def pilot(
    protocol: _impetus.Protocol,
    observer: Observer,
    metric: Metric | None = None,
    urgent: str = "large",
    participants: int = 1,
    seed: int = 1,
) -> pandas.DataFrame:
    """Runs headless sessions and returns a data frame with a row for each completed trial.

    `observer(question, shown)` answers: `question` has its kind, words and choices, `shown` a
    dictionary for each stimulus of the trial (its condition, hold and collisions); it returns the
    index of a choice, or what is filled in. `metric(pair)` measures pairs of bodies, of which the
    `urgent` ("large" or "small") are refined first; None: the scene's own.

    A pilot is no study: no file is written and nothing of it can be replayed.
    """
    if participants < 1:
        raise ValueError(f"participants: expected 1 or more, got {participants}")
    rows: list[dict[str, Any]] = []
    for number in range(1, participants + 1):
        code = f"S{number:0{max(2, len(str(participants)))}d}"
        arguments = (protocol, code, seed, observer)
        trials = (
            _impetus.pilot(*arguments)
            if metric is None
            else _impetus.pilot(*arguments, metric, urgent)
        )
        rows += [{"participant": code, **_flat(trial)} for trial in trials]
    return pandas.DataFrame(rows)


def _flat(trial: dict[str, Any]) -> dict[str, Any]:
    """Levels and answers in columns of their own: factor_NAME, answer_NAME."""
    levels = {f"factor_{name}": value for name, value in trial.pop("condition").items()}
    answers = {f"answer_{name}": value for name, value in trial.pop("answers").items()}
    collisions = trial.pop("collisions")
    return {**trial, **levels, **answers, "collisions": collisions}
