"""A reader for napari, untried there: packaging/napari.yaml names it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Union

from ._volume import read

Layers = list[tuple[Any, dict[str, Any], str]]


def reader_of(path: Union[str, list[str]]) -> Callable[[Union[str, list[str]]], Layers]:
    """What napari asks of the path that it is to read: a function that gives its layers."""
    return layers_of


def layers_of(path: Union[str, list[str]]) -> Layers:
    """One image for each volume, its spacing as the scale.

    >>> layers_of([])
    []
    """
    volumes = [read(one) for one in ([path] if isinstance(path, str) else path)]
    return [(v.array, {"name": v.file, "scale": v.spacing}, "image") for v in volumes]
