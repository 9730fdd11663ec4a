"""Options of the command in the sentences of the compiled part, as the arguments of this package that do the same.

Exceptions come here from the compiled part, and everything that it says as JSON (notes, reasons, advice) through :func:`loads`.
"""

from __future__ import annotations

import json
import re
from typing import Any

#: Options without a value that a sentence need name, and the arguments in their place.
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
#: What an option of a few words may be given.
_WORDS = {
    "ignore": _CHANNELS,
    "flip": "force|motion",
    "positive": "rebound|compression",
    "dates": "day-first|month-first",
    "model": "thesis|fv|piecewise|lag",
}
#: Options that take a number.
_MEASURED = (
    "sample-rate", "delay", "rig-mass", "initial-position", "force-zero", "displacement-zero", "position-offset", "motion-scale", "force-scale",
    "for-step", "clicks",
)  # fmt: skip
#: What only the command does in one run, and what does it here.
_PHRASES = {"--clicks all makes a model of each": "one call for each gives a model of each"}
#: A channel with its unit or heading.
_PAIR = r"(\w+)=(\"[^\"]*\"|[^\s,;()]*[^\s,;().]|\.\.\.)"
#: A whole command stays one: it is what the sentence says to run.
_OPTION = re.compile(
    r"(?P<command>dashpot [a-z]+(?:-[a-z]+)*(?: [A-Z]+)? --[a-z-]+(?: [a-z_]+=\S+| [a-z]+)?)"
    rf"|(?P<phrase>{'|'.join(map(re.escape, _PHRASES))})"
    rf"|(?<![\w-])--(?P<pair>unit|column) {_PAIR}(?: --(?P=pair) {_PAIR})*"
    + "".join(rf"|(?<![\w-])--{name} (?P<{name}>{words})\b" for name, words in _WORDS.items())
    # A number is no part of an option that takes none.
    + rf"|(?<![\w-])--(?P<measured>{'|'.join(_MEASURED)})[ =](?P<number>-?\d[\d.]*(?:e-?\d+)?(?<!\.))"
    + rf"|(?<![\w-])--(?P<bare>{'|'.join(sorted(_NAMES, key=len, reverse=True))})(?![\w-])"
)


def as_arguments(sentence: str) -> str:
    """A sentence that speaks of options of the command, for somebody who calls functions."""

    def said(found: re.Match[str]) -> str:
        if found["command"]:
            return found[0]
        if found["phrase"]:
            return _PHRASES[found[0]]
        if found["pair"]:
            # Given twice, an option is one argument with two entries.
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
        # Options stand beside each other, arguments have a comma between them.
        out += (", " if follows and between == " " else between) + said(found)
        end, follows = found.end(), not found["command"]
    return out + sentence[end:]


def loads(said: str) -> Any:
    """What the compiled part says as JSON, its sentences in the words of this package."""
    return _spoken(json.loads(said)) if "--" in said else json.loads(said)


def _spoken(value: Any) -> Any:
    if isinstance(value, str):
        return as_arguments(value) if "--" in value else value
    if isinstance(value, list):
        return [_spoken(v) for v in value]
    if isinstance(value, dict):
        return {k: _spoken(v) for k, v in value.items()}
    return value
