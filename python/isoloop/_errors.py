"""The errors that isoloop raises, with what happened as attributes."""

from __future__ import annotations

import re
from typing import Any


class Error(Exception):
    """An error of isoloop; its text says what is so and what to do.

    Attributes
    ----------
    exit_code : int
        That with which the command ends for the same reason.
    file, place : str
        Whose it is and where in it ("voxel (0, 1, 2)", in the array's axes); may be empty.
    text : str
        What is so, without advice.
    advice : list of str
        What may be done; each is enough.
    option : str
        The keyword that it is about, or empty.
    """

    exit_code: int = 5

    def __init__(self, message: str, **data: Any) -> None:
        super().__init__(in_keywords(message))
        self.file: str = data.get("file", "")
        self.place: str = data.get("place", "")
        self.text: str = in_keywords(data.get("text", message))
        self.advice: list[str] = [in_keywords(way) for way in data.get("advice", [])]
        self.option: str = in_keywords(data.get("option", "")).rstrip("=")


class UsageError(Error, ValueError):
    """An argument that makes no sense, by itself or for the volume at hand."""

    exit_code = 2


class InvalidInput(Error, ValueError):
    """A volume that cannot be read or must not be trusted: damaged, missing, NaN among its voxels.

    `fault` is "damaged", "unreadable", "unsupported", "not finite" or "unwritable".
    """

    exit_code = 3

    def __init__(self, message: str, **data: Any) -> None:
        super().__init__(message, **data)
        self.fault: str = data.get("fault", "damaged")


class LimitExceeded(Error, MemoryError):
    """More memory or voxels than allowed or than there is; said before they are asked for.

    `needed` and `limit` are counts of `unit` ("bytes" or "voxels"; empty where they are not known),
    `stage` is that of the work, or empty.
    """

    exit_code = 4

    def __init__(self, message: str, **data: Any) -> None:
        super().__init__(message, **data)
        self.unit: str = data.get("unit", "")
        self.needed: int = data.get("needed", 0)
        self.limit: int = data.get("limit", 0)
        self.stage: str = data.get("stage", "")


class SelfCheckFailed(Error, RuntimeError):
    """A result that contradicts another one, which is never given as an answer: please report it."""

    exit_code = 5


class IsoloopWarning(UserWarning):
    """What a user should look at: of how a volume was read, or of what was left out."""


_FLAG = re.compile(r"--([a-z][a-z-]*)(?: (-?[0-9][^\s,;:)]*|[A-Z]+|auto|sform|qform|handle|tunnel))?")


def in_keywords(sentence: str) -> str:
    """The sentence with keywords in place of flags: "spacing=X" for "--spacing X".

    >>> in_keywords("choose one with --grid NAME or raise --max-memory")
    'choose one with grid=NAME or raise max_memory='
    """
    return _FLAG.sub(lambda flag: f"{flag[1].replace('-', '_')}={flag[2] or ''}", sentence)


def error_of(exit_code: int, sentence: str, **data: Any) -> Error:
    """The error of the compiled module, by the exit code that the command has for it."""
    for kind in (UsageError, InvalidInput, LimitExceeded):
        if kind.exit_code == exit_code:
            return kind(sentence, **data)
    return SelfCheckFailed(sentence, **data)
