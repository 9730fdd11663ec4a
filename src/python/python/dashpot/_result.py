"""Base class of all results: conversion to dictionaries, to tables and to HTML for notebooks."""

from __future__ import annotations

import dataclasses
import html
import sys
import types
import typing
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar, Union

import numpy as np

if TYPE_CHECKING:
    import pandas
    import xarray

_R = TypeVar("_R", bound="Result")


_HINTS: dict[type, dict[str, Any]] = {}


def _hints(kind: type[Result]) -> dict[str, Any]:
    """Returns the types of the fields that JSON contains. They are cached, because evaluating them takes longer than building a result."""
    if kind not in _HINTS:
        hints = {}
        for owner in reversed(kind.__mro__):
            for name, hint in owner.__dict__.get("__annotations__", {}).items():
                field = kind.__dataclass_fields__.get(name)
                # A hidden field may have a type that only type checkers import.
                if field is not None and not field.metadata.get("hidden"):
                    hints[name] = eval(hint, vars(sys.modules[owner.__module__])) if isinstance(hint, str) else hint
        _HINTS[kind] = hints
    return _HINTS[kind]


def _build(hint: Any, value: Any) -> Any:
    """Converts a JSON value to the type of a dataclass field."""
    origin = typing.get_origin(hint)
    if origin in (Union, types.UnionType):
        options = [o for o in typing.get_args(hint) if o is not type(None)]
        return None if value is None else _build(options[0], value) if len(options) == 1 else value
    if origin is tuple:
        inner = typing.get_args(hint)
        if len(inner) == 2 and inner[1] is Ellipsis:
            return tuple(_build(inner[0], v) for v in value)
        return tuple(_build(h, v) for h, v in zip(inner, value, strict=True))
    if origin is dict:
        inner = typing.get_args(hint)[1]
        return {k: _build(inner, v) for k, v in value.items()}
    if isinstance(hint, type) and issubclass(hint, Result):
        return hint.from_dict(value)
    if origin is np.ndarray:
        return np.asarray(value, dtype=np.float64)
    if hint is float:
        # JSON has no NaN, so null represents it.
        return float("nan") if value is None else float(value)
    return value


def _plain(value: Any) -> Any:
    if isinstance(value, Result):
        return value.to_dict()
    if isinstance(value, (tuple, list)):
        return [_plain(v) for v in value]
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}
    if isinstance(value, float) and value != value:
        return None
    return value


def _is_left_out(field: dataclasses.Field[Any], value: Any) -> bool:
    """Returns whether the command's JSON lacks a field: a hidden field, or an omitted field that is None or empty."""
    return bool(field.metadata.get("hidden") or (field.metadata.get("omitted") and (value is None or value == ())))


@dataclasses.dataclass(frozen=True, repr=False)
class Result:
    """Base of all results, a frozen dataclass. SI units; extension (rebound) velocity and tension force are positive."""

    @classmethod
    def from_dict(cls: type[_R], data: Mapping[str, Any]) -> _R:
        """Makes a result from the dictionary of :meth:`to_dict`, or from parsed JSON of the command."""
        hints = _hints(cls)
        values = {}
        for field in dataclasses.fields(cls):
            key = field.metadata.get("key", field.name)
            if key in data and field.name in hints:
                values[field.name] = _build(hints[field.name], data[key])
        return cls(**values)

    def to_dict(self) -> dict[str, Any]:
        """Converts the result to plain dictionaries, lists and numbers, with the keys of the command's JSON."""
        out = {}
        for field in dataclasses.fields(self):
            value = getattr(self, field.name)
            if _is_left_out(field, value):
                continue
            out[field.metadata.get("key", field.name)] = _plain(value)
        return out

    def _rows(self) -> list[Row]:
        """Returns the rows of the main table of this result."""
        return [held(self)[0]]

    def _title(self) -> str:
        return type(self).__name__

    def _tables(self) -> dict[str, list[Row]]:
        own, several = held(self)
        return {"": [own], **several} if own else several

    def to_pandas(self) -> pandas.DataFrame:
        """Returns the main table. Requires pandas; :meth:`tables` returns all tables."""
        return frame(self._rows())

    def tables(self) -> dict[str, pandas.DataFrame]:
        """Returns the whole content of the result as tables, by name. Requires pandas.

        The table ``""`` has a single row with the values of the whole result. The other tables are named by the keys of :meth:`to_dict`,
        such as ``changes`` or ``tests.peaks``. If a table combines the lists of several items, its column ``of`` names the item of each row.
        """
        return {name: frame(rows) for name, rows in self._tables().items()}

    def _repr_html_(self) -> str:
        several = {name: rows for name, rows in self._tables().items() if name}
        return table(self._title(), self._rows()) + folded(several)

    def __repr__(self) -> str:
        """Returns a text that is short enough for a prompt. Long sequences are replaced by their length and type."""
        fields = ((f.name, getattr(self, f.name)) for f in dataclasses.fields(self) if f.repr and not f.name.startswith("_"))
        return f"{type(self).__name__}({', '.join(f'{name}={_brief(value)}' for name, value in fields)})"


#: Largest length of a sequence of plain values that ``repr`` shows in full.
_SHOWN_AT_PROMPT = 3


def _brief(value: Any) -> str:
    if isinstance(value, Result):
        return f"<{type(value).__name__}>"
    if isinstance(value, (tuple, list)) and len(value) > 0 and (len(value) > _SHOWN_AT_PROMPT or isinstance(value[0], (Result, tuple))):
        return f"<{len(value)} of {type(value[0]).__name__}>"
    return repr(value)


#: Row of a table: values by column name.
Row = dict[str, Any]


def _is_one(value: Any) -> bool:
    """Returns whether a value has named fields, so that it can be a row of a table."""
    return isinstance(value, (Result, Mapping))


def held(thing: Result | Mapping[str, Any]) -> tuple[Row, dict[str, list[Row]]]:
    """Converts a result to one row with its own values, and to tables with its lists of results, by name.

    The row also has the values of nested results, with keys joined by dots. Lists of plain values stay lists in the row.
    """
    own: Row = {}
    tables: dict[str, list[Row]] = {}
    for key, value in _entries(thing):
        if isinstance(value, Mapping) and value and all(map(_is_one, value.values())):
            _list(tables, key, [({"name": name}, one) for name, one in value.items()])
        elif _is_one(value):
            inner, more = held(value)
            own.update({f"{key}.{name}": one for name, one in inner.items()})
            tables.update({f"{key}.{name}": rows for name, rows in more.items()})
        elif isinstance(value, (tuple, list)) and value and all(map(_is_one, value)):
            _list(tables, key, [({}, one) for one in value])
        elif isinstance(value, (tuple, list)) and value and all(isinstance(part, (tuple, list)) and all(map(_is_one, part)) for part in value):
            # A list of lists, such as the iterations of a search. The column `turn` is the number of the inner list.
            _list(tables, key, [({"turn": k + 1}, one) for k, part in enumerate(value) for one in part])
        else:
            own[key] = value
    return own, tables


def _entries(thing: Result | Mapping[str, Any]) -> Iterable[tuple[str, Any]]:
    """Returns the keys and values of :meth:`Result.to_dict`. Nested results are not converted."""
    if isinstance(thing, Mapping):
        return thing.items()
    fields = [(field, getattr(thing, field.name)) for field in dataclasses.fields(thing)]
    return [
        (field.metadata.get("key", field.name), value)
        for field, value in fields
        if not _is_left_out(field, value)
    ]


def _list(tables: dict[str, list[Row]], key: str, things: Iterable[tuple[Row, Any]]) -> None:
    """Appends items as rows to the table ``key``.

    Lists in the items go to one further table for all items, whose column ``of`` is the first text of the item.
    """
    for first, thing in things:
        own, more = held(thing)
        row = {**first, **own}
        tables.setdefault(key, []).append(row)
        whose = next((value for value in row.values() if isinstance(value, str)), None)
        for name, rows in more.items():
            tables.setdefault(f"{key}.{name}", []).extend({"of": whose, **inner} for inner in rows)


def frame(rows: Sequence[Mapping[str, Any]] | Mapping[str, Any]) -> pandas.DataFrame:
    """Converts rows, or columns by name, to a pandas table."""
    try:
        import pandas
    except ImportError as error:
        raise ImportError("to_pandas() needs pandas: pip install 'dashpot[pandas]'") from error
    return pandas.DataFrame(rows if isinstance(rows, Mapping) else list(rows))


def by_test(rows: Sequence[Mapping[str, Any]]) -> pandas.DataFrame:
    """Converts rows with names of tests to a pandas table, with these names as index."""
    made = frame(rows)
    # Without rows, the table has no column `name`.
    return made.set_index("name").rename_axis("test") if len(rows) else made


def dataset(
    along: str, coordinates: Mapping[str, tuple[Any, str]], variables: Mapping[str, tuple[Any, str]], **attributes: Any
) -> xarray.Dataset:
    """Makes an xarray dataset of columns with units. All columns have the dimension ``along``."""
    try:
        import xarray
    except ImportError as error:
        raise ImportError("to_xarray() needs xarray: pip install xarray") from error

    def columns(of: Mapping[str, tuple[Any, str]]) -> dict[str, tuple[str, Any, dict[str, str]]]:
        return {name: (along, values, {"units": unit} if unit else {}) for name, (values, unit) in of.items()}

    return xarray.Dataset(columns(variables), columns(coordinates), attributes)


def _shown(value: Any) -> str:
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.5g}"
    if isinstance(value, (tuple, list)):
        return ", ".join(map(_shown, value)) or "–"
    return str(value)


#: Largest number of rows of a table in a notebook. Longer tables are complete only in to_pandas() and tables().
SHOWN = 60
#: Largest number of characters of a cell, and of remarks above a table, in a notebook. Longer texts are truncated and further remarks
#: are folded, because rows and lists would otherwise exceed a page.
LETTERS, REMARKS = 48, 8
#: Style of the box around a table. A table that is larger than the box scrolls inside it.
_BOX = 'style="max-height:420px;max-width:100%;overflow:auto"'


def table(title: str, rows: Iterable[Mapping[str, Any]], notes: Iterable[str] = ()) -> str:
    """Renders a table as HTML without script or style sheet, with remarks above it."""
    rows = list(rows)
    columns: list[str] = []
    for row in rows:
        columns.extend(c for c in row if c not in columns)
    cell = 'style="text-align:right;padding:1px 8px;white-space:nowrap"'

    def one(value: Any) -> str:
        text = _shown(value)
        if len(text) <= LETTERS:
            return f"<td {cell}>{html.escape(text)}</td>"
        return f'<td {cell} title="{html.escape(text)}">{html.escape(text[: LETTERS - 1])}…</td>'

    head = "".join(f"<th {cell}>{html.escape(c)}</th>" for c in columns)
    lines = [
        "<tr>" + "".join(one(row.get(c)) for c in columns) + "</tr>"
        for row in rows[:SHOWN]
    ]
    more = f"<p>{len(rows) - SHOWN} more rows</p>" if len(rows) > SHOWN else ""
    said = [f"<li>{html.escape(note)}</li>" for note in notes]
    listed = f"<ul>{''.join(said[:REMARKS])}</ul>" if said else ""
    if len(said) > REMARKS:
        listed += f"<details><summary>{len(said) - REMARKS} more remarks</summary><ul>{''.join(said[REMARKS:])}</ul></details>"
    return f"<h4>{html.escape(title)}</h4>{listed}<div {_BOX}><table><tr>{head}</tr>{''.join(lines)}</table></div>{more}"


def folded(tables: Mapping[str, Sequence[Row]]) -> str:
    """Renders tables as HTML sections that open when a user clicks their names."""
    return "".join(
        f"<details><summary>{html.escape(name)} ({len(rows)})</summary>{table(name, rows)}</details>" for name, rows in tables.items() if rows
    )
