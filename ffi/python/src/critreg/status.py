"""What became of a call of the library, and the exceptions that tell of it."""

from __future__ import annotations

from enum import IntEnum
from typing import Optional


class Status(IntEnum):
    """The statuses of critreg.h."""

    OK = 0
    NULL_POINTER = 1
    MISALIGNED = 2
    TOO_SMALL = 3
    INVALID_ARGUMENT = 4
    NOT_FINITE = 5
    SYNTAX_ERROR = 6
    CAPACITY_EXCEEDED = 7
    EMPTY_REGION = 8
    NO_SAMPLE = 9
    NO_REGION = 10
    OUT_OF_SEQUENCE = 11
    MISMATCH = 12
    CORRUPT = 13
    BUSY = 14
    CANCELLED = 15
    NOT_A_HANDLE = 16
    NO_PLAN = 17
    USER_STATUS = 1000


class Error(Exception):
    """A call failed: `status` is the code, and the text says why."""

    status: Status

    def __init__(self, message: str, status: Optional[Status] = None) -> None:
        super().__init__(message)
        if status is not None:
            self.status = status


class EmptyRegion(Error):
    """Proven: the region has no parameters in this instance.

    A `sample` callback of a planner raises it, or lets it through; `reason` is then a
    number of the program's own that the planner counts.
    """

    status = Status.EMPTY_REGION

    def __init__(self, message: str = "the region is empty here", reason: Optional[int] = None):
        super().__init__(message)
        self.reason = reason


class NoSample(Error):
    """No parameters were found within the budget; the region may be empty."""

    status = Status.NO_SAMPLE

    def __init__(self, message: str = "no parameters were found", reason: Optional[int] = None):
        super().__init__(message)
        self.reason = reason


class NoRegion(Error):
    """Nothing was learned; the text says why. The planner keeps its own sampler."""

    status = Status.NO_REGION


class NoPlan(Error):
    """No plan was found; the text says what stood in the way."""

    status = Status.NO_PLAN


def error(status: int, message: str) -> Error:
    """The exception of a status."""
    special = {
        Status.EMPTY_REGION: EmptyRegion,
        Status.NO_SAMPLE: NoSample,
        Status.NO_REGION: NoRegion,
        Status.NO_PLAN: NoPlan,
    }
    known = Status(status)
    return special[known](message) if known in special else Error(message, known)
