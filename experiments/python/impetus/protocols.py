"""Protocols and scenes, from files or written in Python."""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Mapping
from typing import Any

from impetus import _impetus

_UNNAMED = "protocol.json"


def load_protocol(path: str | os.PathLike[str]) -> _impetus.Protocol:
    """The protocol in a file, with the scene that it names, checked. Raises InputError."""
    return _impetus.load_protocol(os.fspath(path))


def protocol(
    document: Mapping[str, Any],
    scene: Mapping[str, Any] | None = None,
    path: str | os.PathLike[str] = _UNNAMED,
) -> _impetus.Protocol:
    """A protocol from a dictionary, checked as `impetus check` checks a file.

    `scene` is what its "scene" names; None: the file of that name. `path` is where the protocol's
    file would lie: names of files count from there, and sentences about mistakes begin with it.
    """
    own = None if scene is None else dict(scene)
    return _impetus.make_protocol(dict(document), os.fspath(path), own)


def load_scene(path: str | os.PathLike[str]) -> dict[str, Any]:
    """The scene in a file, checked, with its meshes and figures held in it. Raises InputError."""
    return _impetus.load_scene(os.fspath(path))


def scene(document: Mapping[str, Any], path: str | os.PathLike[str] = "scene.json") -> dict[str, Any]:
    """A scene from a dictionary, checked; files that it names count from where `path` lies."""
    return _impetus.make_scene(dict(document), os.fspath(path))


def world(
    scene: Mapping[str, Any] | str | os.PathLike[str],
    seed: int = 1,
    path: str | os.PathLike[str] = "scene.json",
) -> _impetus.World:
    """The world of a scene at its start: a dictionary, or a file of one."""
    if isinstance(scene, Mapping):
        return _impetus.scene_world(dict(scene), os.fspath(path), seed)
    return _impetus.load_scene_world(os.fspath(scene), seed)


def save(protocol: _impetus.Protocol, path: str | os.PathLike[str]) -> pathlib.Path:
    """Writes a protocol and its scene as files: the scene where the protocol names it, seen from
    `path`. Raises FileExistsError where either is there already; then nothing is written."""
    file = pathlib.Path(path)
    beside = file.parent / protocol.document["scene"]
    for each in (file, beside):
        if each.exists():
            raise FileExistsError(f"{each}: expected no file, for nothing is overwritten")
    beside.parent.mkdir(parents=True, exist_ok=True)
    file.parent.mkdir(parents=True, exist_ok=True)
    beside.write_text(json.dumps(protocol.scene, indent=2, ensure_ascii=False) + "\n", "utf-8")
    file.write_text(json.dumps(protocol.document, indent=2, ensure_ascii=False) + "\n", "utf-8")
    return file
