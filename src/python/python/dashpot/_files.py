"""Files that are missing, and files that would be overwritten, as the exceptions that Python programs expect."""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Iterator

from . import _native


class _OfTheSystem(OSError):
    """An error of dashpot that is one of the operating system too: it says the sentence of the first."""

    def __init__(self, sentence: str, path: str | None = None, code: int | None = None) -> None:
        super().__init__(sentence)
        self.filename, self.errno = path, code

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[object, ...]:
        return (type(self), (self.args[0], self.filename, self.errno))


class MissingRecordsError(_native.RecordError, _OfTheSystem, FileNotFoundError):
    """A path of records that does not exist: a :class:`RecordError` and a :class:`FileNotFoundError`."""


class MissingModelError(_native.ModelError, _OfTheSystem, FileNotFoundError):
    """A model file or a table that does not exist: a :class:`ModelError` and a :class:`FileNotFoundError`."""


class MissingLimitsError(_native.ValidationError, _OfTheSystem, FileNotFoundError):
    """A table of limits, or a model to compare with, that does not exist: a :class:`ValidationError` and a :class:`FileNotFoundError`."""


class MissingExportError(_native.ExportError, _OfTheSystem, FileNotFoundError):
    """A file that an export needs and that does not exist: an :class:`ExportError` and a :class:`FileNotFoundError`."""


class MissingMatrixError(_native.RigError, _OfTheSystem, FileNotFoundError):
    """A test matrix that does not exist: a :class:`RigError` and a :class:`FileNotFoundError`."""


class MissingGroupsError(_native.DiagnosisError, _OfTheSystem, FileNotFoundError):
    """Groups of records that do not exist: a :class:`DiagnosisError` and a :class:`FileNotFoundError`."""


class MissingDimensionsError(_native.DimensionsError, _OfTheSystem, FileNotFoundError):
    """A file of dimensions that does not exist: a :class:`DimensionsError` and a :class:`FileNotFoundError`."""


class OverwriteError(_native.OutputError, _OfTheSystem, FileExistsError):
    """A file that would be overwritten: an :class:`OutputError` and a :class:`FileExistsError`."""


_MISSING: dict[type[Exception], type[_OfTheSystem]] = {
    _native.RecordError: MissingRecordsError,
    _native.ModelError: MissingModelError,
    _native.ValidationError: MissingLimitsError,
    _native.ExportError: MissingExportError,
    _native.RigError: MissingMatrixError,
    _native.DiagnosisError: MissingGroupsError,
    _native.DimensionsError: MissingDimensionsError,
}


@contextlib.contextmanager
def needs(*paths: str | os.PathLike[str] | None) -> Iterator[None]:
    """Raises the error of the compiled part as a ``FileNotFoundError`` too where one of these paths does not exist."""
    try:
        yield
    except _native.DashpotError as error:
        missing = _MISSING.get(type(error))
        absent = next((os.fspath(p) for p in paths if p is not None and not os.path.lexists(p)), None)
        if missing is None or absent is None:
            raise
        raise missing(str(error), absent, errno.ENOENT) from None


def write_new(path: str | os.PathLike[str], text: str, force: bool) -> None:
    """Writes a text to a file, whole or not at all.

    :raises OverwriteError: where another file stands there and ``force`` is not given. A file with this very text stays as it is.
    """
    # That a folder is no file the compiled part says.
    if not force and os.path.lexists(path) and not os.path.isdir(path):
        try:
            with open(path, encoding="utf-8", newline="") as file:
                same = file.read(len(text) + 1) == text
        except (OSError, UnicodeDecodeError):
            same = False
        if not same:
            raise OverwriteError(
                f"{os.fspath(path)} is there already; name another file, or give force=True to replace it", os.fspath(path), errno.EEXIST
            )
        return
    _native.write(os.fspath(path), text, force)
