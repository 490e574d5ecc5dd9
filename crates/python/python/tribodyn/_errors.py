"""Exceptions that say what is wrong, where it stands, and what is allowed."""

from __future__ import annotations

from typing import Optional


class TribodynError(Exception):
    """Any failure of this package."""


class TribodynWarning(UserWarning):
    """Any warning of this package. ``warnings.simplefilter("error", TribodynWarning)`` makes errors of them."""


class ModelWarning(TribodynWarning):
    """What is unusual, beyond what was tested, or more than the model can mean."""


class PlausibilityWarning(TribodynWarning):
    """What no bearing does: do not use the numbers that it names."""


class InputError(TribodynError, ValueError):
    """A value that is refused.

    Attributes:
        file: name of the file with the value; None for an argument
        line: line in it, from 1
        column: column in characters, from 1
        path: path of the value in the file, such as ``geometry.ball_diameter``, or name of the argument
        value: the value as it was given
        allowed: what is allowed
        text: the line of the file
    """

    def __init__(
        self,
        message: str,
        *,
        file: Optional[str] = None,
        line: Optional[int] = None,
        column: Optional[int] = None,
        path: Optional[str] = None,
        value: Optional[str] = None,
        allowed: Optional[str] = None,
        text: Optional[str] = None,
    ) -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.column = column
        self.path = path
        self.value = value
        self.allowed = allowed
        self.text = text

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuilt, (type(self), str(self), dict(self.__dict__))


class CaseError(InputError):
    """A case file, or a value in it, that is refused."""


class SolveError(TribodynError, RuntimeError):
    """Equations whose solution was not found.

    Attributes:
        file: name of the case
        residual: largest relative residual of all balances at the end
        iterations: Newton steps taken
    """

    def __init__(
        self,
        message: str,
        *,
        file: Optional[str] = None,
        residual: Optional[float] = None,
        iterations: Optional[int] = None,
    ) -> None:
        super().__init__(message)
        self.file = file
        self.residual = residual
        self.iterations = iterations

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuilt, (type(self), str(self), dict(self.__dict__))


class FileError(TribodynError, OSError):
    """A file that cannot be read or written.

    Attributes:
        file: the file
    """

    def __init__(self, message: str, *, file: Optional[str] = None) -> None:
        super().__init__(message)
        self.file = file

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuilt, (type(self), str(self), dict(self.__dict__))


class ClusterError(TribodynError, ConnectionError):
    """A cluster that is gone, or that cannot do its work.

    Attributes:
        dataset: folder of what is finished; the same call goes on from there
        finished: rows that are finished
        rows: rows of the whole study
    """

    def __init__(self, message: str, *, dataset: Optional[str] = None, finished: int = 0, rows: int = 0) -> None:
        super().__init__(message)
        self.dataset = dataset
        self.finished = finished
        self.rows = rows

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuilt, (type(self), str(self), dict(self.__dict__))


class Stopped(KeyboardInterrupt):
    """A run that was interrupted. Its recording is closed, and ``run(..., resume=True)`` goes on with it.

    Attributes:
        simulated_s: simulated time up to there, s
        duration_s: simulated time at which it would have ended, s
        recording: the recording
    """

    def __init__(self, message: str, *, simulated_s: float, duration_s: float, recording: str) -> None:
        super().__init__(message)
        self.simulated_s = simulated_s
        self.duration_s = duration_s
        self.recording = recording


def _rebuilt(kind: type[BaseException], message: str, facts: dict[str, object]) -> BaseException:
    """An exception that comes from another process."""
    exception = kind(message, **facts)
    return exception
