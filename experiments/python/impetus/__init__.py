"""Impetus: experiments on how believable an approximated collision looks.

    study = impetus.read("study.sqlite")            # tables as data frames, with units and meanings
    protocol = impetus.load_protocol("protocols/causality.json")
    impetus.run(protocol, to="study.sqlite", observer="causality", participants=12)
    world = protocol.world(protocol.conditions()[0])
    step = world.step()                             # the program's own engine, bit for bit

Whatever a file or a dictionary has wrong is said in one sentence, as the program says it
(`impetus.InputError`).
"""

from impetus._impetus import (
    Collision,
    Contact,
    InputError,
    Pair,
    Protocol,
    Replay,
    Step,
    StoreError,
    Tree,
    World,
    build_name,
    metric_names,
    version,
)
from impetus.commands import CommandError, program, run
from impetus.pilots import pilot
from impetus.protocols import load_protocol, load_scene, protocol, save, scene, world
from impetus.studies import Study, read

__all__ = [
    "Collision",
    "CommandError",
    "Contact",
    "InputError",
    "Pair",
    "Protocol",
    "Replay",
    "Step",
    "StoreError",
    "Study",
    "Tree",
    "World",
    "build_name",
    "load_protocol",
    "load_scene",
    "metric_names",
    "pilot",
    "program",
    "protocol",
    "read",
    "run",
    "save",
    "scene",
    "version",
    "world",
]
