"""Exceptions for missing files and for files that would be overwritten, derived from those that Python programs expect."""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Iterator

from . import _native


class _OfTheSystem(OSError):
    """Base of dashpot exceptions that are also an :class:`OSError`. Their text is the message of dashpot."""

    def __init__(self, sentence: str, path: str | None = None, code: int | None = None) -> None:
        super().__init__(sentence)
        self.filename, self.errno = path, code

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[object, ...]:
        return (type(self), (self.args[0], self.filename, self.errno))


class MissingRecordsError(_native.RecordError, _OfTheSystem, FileNotFoundError):
    """The path of records does not exist: a :class:`RecordError` and a :class:`FileNotFoundError`."""


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
    """Converts an error of the extension module to one that is also a ``FileNotFoundError`` if one of ``paths`` does not exist."""
    try:
        yield
    except _native.DashpotError as error:
        missing = _MISSING.get(type(error))
        absent = next((os.fspath(p) for p in paths if p is not None and not os.path.lexists(p)), None)
        if missing is None or absent is None:
            raise
        raise missing(str(error), absent, errno.ENOENT) from None


def write_new(path: str | os.PathLike[str], text: str, force: bool) -> None:
    """Writes a text to a file atomically. Without ``force``, a file that already contains the text is not written again.

    :raises OverwriteError: if a file with another content exists and ``force`` is not given.
    """
    # The extension module reports a folder in the file's path.
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
