"""What only the program does: recorded sessions of simulated participants."""

from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import tempfile
import warnings

from impetus import _impetus
from impetus.protocols import save
from impetus.studies import Study, read


class CommandError(RuntimeError):
    """The program refused or failed; the message is its own."""


def program() -> str:
    """The program `impetus`: $IMPETUS, that of the build which this package is part of, or the
    installed one. Raises CommandError where there is none."""
    built = pathlib.Path(__file__).resolve().parent.parent.parent / "impetus"
    for each in (os.environ.get("IMPETUS"), built, shutil.which("impetus")):
        if each and os.path.isfile(each) and os.access(each, os.X_OK):
            return os.fspath(each)
    raise CommandError("impetus: expected the program in $IMPETUS, beside this package or on PATH")


def run(
    protocol: _impetus.Protocol | str | os.PathLike[str],
    to: str | os.PathLike[str],
    observer: str | os.PathLike[str] | None = None,
    participants: int | None = None,
    seed: int | None = None,
    metric: object = None,
) -> Study:
    """Runs simulated participants headless, as `impetus run` does, and returns the study.

    `observer` is a name or a file; None with a protocol in which nobody takes part. What the
    program notes, such as that some had finished before, is a warning. What is
    recorded can be replayed years later, so nothing written in Python may decide it: a metric or an
    observer that is a function is refused, and `impetus.pilot` takes it.
    """
    for name, value in (("metric", metric), ("observer", observer)):
        if callable(value):
            raise _impetus.InputError(
                f"{name}: expected no function in a recorded session, for nobody could replay it; "
                "impetus.pilot() takes one and records nothing"
            )
    if metric is not None:
        raise _impetus.InputError(
            "metric: expected none, for a scene names its own (/engine/schedule/scheduler)"
        )
    with tempfile.TemporaryDirectory(prefix="impetus-") as folder:
        if isinstance(protocol, _impetus.Protocol):
            file: str | os.PathLike[str] = save(
                protocol, pathlib.Path(folder) / "study" / "protocols" / f"{protocol.name}.json"
            )
        else:
            file = protocol
        command = [program(), "run", os.fspath(file), "--db", os.fspath(to)]
        command += [] if observer is None else ["--observer", os.fspath(observer)]
        command += [] if participants is None else ["--participants", str(participants)]
        command += [] if seed is None else ["--seed", str(seed)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        said = done.stderr.strip().splitlines()
        raise CommandError(said[-1].removeprefix("impetus: ") if said else "impetus failed")
    for line in done.stderr.splitlines():
        if line.startswith(("note: ", "warning: ")):
            warnings.warn(line, stacklevel=2)
    return read(to)
