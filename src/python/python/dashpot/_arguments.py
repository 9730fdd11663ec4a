"""Replacement of command options in messages of the extension module by the equivalent arguments of this package.

The extension module passes its exceptions through :func:`as_arguments`. Its JSON (notes, reasons, advice) passes through :func:`loads`.
"""

from __future__ import annotations

import json
import re
from typing import Any

#: Options that are replaced without a value, and the equivalent arguments.
_NAMES = {
    "unit": "units",
    "column": "columns",
    "ignore": "ignore",
    "flip": "flip",
    "positive": "positive",
    "exclude": "exclude",
    "subfolders": "subfolders=True",
    "sample-rate": "sample_rate_hz",
    "dates": "dates",
    "delay": "delay_s",
    "rig-mass": "rig_mass_kg",
    "initial-position": "initial_position_m",
    "force-zero": "force_zero_n",
    "displacement-zero": "displacement_zero_m",
    "setting": "setting",
    "clicks": "clicks",
    "model": "family",
    "elements": "elements",
    "hold-out": "hold_out",
    "reference": "reference",
    "group": "group",
    "motion-scale": "motion_scale",
    "force-scale": "force_scale",
    "position-offset": "position_offset_m",
    "from-source": "library",
    "against": "against",
    "host-step": "host_step_s",
    "wheel-mass": "wheel_mass_kg",
    "for-step": "for_step_s",
    "force": "force=True",
    "carmaker": "carmaker_length_m",
    "binary": "binaries",
    "library": "library",
    "gas-force": "gas_force_n",
    "friction": "friction_n",
    "matrix": "matrix",
    "noise": "noise_percent",
    "strength": "severity=False",
}
_CHANNELS = "time|displacement|velocity|force|side_force|temperature"
#: Pattern of the values of each option that accepts only a few words.
_WORDS = {
    "ignore": _CHANNELS,
    "flip": "force|motion",
    "positive": "rebound|compression",
    "dates": "day-first|month-first",
    "model": "thesis|fv|piecewise|lag",
}
#: Options whose value is a number.
_MEASURED = (
    "sample-rate", "delay", "rig-mass", "initial-position", "force-zero", "displacement-zero", "position-offset", "motion-scale", "force-scale",
    "for-step", "clicks",
)  # fmt: skip
#: Phrases on what only the command does in one run, and the equivalent for this package.
_PHRASES = {"--clicks all makes a model of each": "one call for each gives a model of each"}
#: Pattern of a channel with its unit or heading, such as ``force=kN``.
_PAIR = r"(\w+)=(\"[^\"]*\"|[^\s,;()]*[^\s,;().]|\.\.\.)"
#: Pattern of every text to replace. A whole command is matched but kept, because the message tells the user to run it.
_OPTION = re.compile(
    r"(?P<command>dashpot [a-z]+(?:-[a-z]+)*(?: [A-Z]+)? --[a-z-]+(?: [a-z_]+=\S+| [a-z]+)?)"
    rf"|(?P<phrase>{'|'.join(map(re.escape, _PHRASES))})"
    rf"|(?<![\w-])--(?P<pair>unit|column) {_PAIR}(?: --(?P=pair) {_PAIR})*"
    + "".join(rf"|(?<![\w-])--{name} (?P<{name}>{words})\b" for name, words in _WORDS.items())
    # Only an option with a numeric value includes the number after it.
    + rf"|(?<![\w-])--(?P<measured>{'|'.join(_MEASURED)})[ =](?P<number>-?\d[\d.]*(?:e-?\d+)?(?<!\.))"
    + rf"|(?<![\w-])--(?P<bare>{'|'.join(sorted(_NAMES, key=len, reverse=True))})(?![\w-])"
)


def as_arguments(sentence: str) -> str:
    """Replaces options of the command in a message by the equivalent arguments of this package."""

    def said(found: re.Match[str]) -> str:
        if found["command"]:
            return found[0]
        if found["phrase"]:
            return _PHRASES[found[0]]
        if found["pair"]:
            # A repeated option becomes one argument with several entries.
            entries = (
                f'"{channel}": {value}' if value.startswith('"') or value == "..." else f'"{channel}": "{value}"'
                for channel, value in re.findall(_PAIR, found[0])
            )
            return f"{_NAMES[found['pair']]}={{{', '.join(entries)}}}"
        if found["measured"]:
            return f"{_NAMES[found['measured']]}={found['number']}"
        for name in _WORDS:
            if found[name]:
                return f'{_NAMES[name]}="{found[name]}"'
        return _NAMES[found["bare"]]

    out, end, follows = "", 0, False
    for found in _OPTION.finditer(sentence):
        between = sentence[end : found.start()]
        # Options are separated by spaces, arguments by commas.
        out += (", " if follows and between == " " else between) + said(found)
        end, follows = found.end(), not found["command"]
    return out + sentence[end:]


def loads(said: str) -> Any:
    """Parses JSON of the extension module. Options of the command in its messages are replaced by arguments of this package."""
    return _spoken(json.loads(said)) if "--" in said else json.loads(said)


def _spoken(value: Any) -> Any:
    if isinstance(value, str):
        return as_arguments(value) if "--" in value else value
    if isinstance(value, list):
        return [_spoken(v) for v in value]
    if isinstance(value, dict):
        return {k: _spoken(v) for k, v in value.items()}
    return value
