"""Options of the command in the sentences of the compiled part, as the arguments of this package that do the same."""

from __future__ import annotations

import re

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
    "initial-position": "initial_position",
    "model": "family",
    "elements": "elements",
    "hold-out": "hold_out",
    "reference": "reference",
    "motion-scale": "motion_scale",
    "force-scale": "force_scale",
    "position-offset": "position_offset",
    "from-source": "library",
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
#: A channel with its unit or heading.
_PAIR = r"(\w+)=(\"[^\"]*\"|[^\s,;()]*[^\s,;().]|\.\.\.)"
#: A whole command stays one: it is what the sentence says to run.
_OPTION = re.compile(
    r"(?P<command>dashpot [a-z]+(?:-[a-z]+)*(?: [A-Z]+)? --[a-z-]+(?: [a-z_]+=\S+| [a-z]+)?)"
    rf"|(?<![\w-])--(?P<pair>unit|column) {_PAIR}(?: --(?P=pair) {_PAIR})*"
    + "".join(rf"|(?<![\w-])--{name} (?P<{name}>{words})\b" for name, words in _WORDS.items())
    + r"|(?<![\w-])--sample-rate (?P<rate>[\d.]+)"
    + rf"|(?<![\w-])--(?P<bare>{'|'.join(sorted(_NAMES, key=len, reverse=True))})(?![\w-])"
)


def as_arguments(sentence: str) -> str:
    """A sentence that speaks of options of the command, for somebody who calls functions."""

    def said(found: re.Match[str]) -> str:
        if found["command"]:
            return found[0]
        if found["pair"]:
            # Given twice, an option is one argument with two entries.
            entries = (
                f'"{channel}": {value}' if value.startswith('"') or value == "..." else f'"{channel}": "{value}"'
                for channel, value in re.findall(_PAIR, found[0])
            )
            return f"{_NAMES[found['pair']]}={{{', '.join(entries)}}}"
        if found["rate"]:
            return f"sample_rate_hz={found['rate']}"
        for name in _WORDS:
            if found[name]:
                return f'{_NAMES[name]}="{found[name]}"'
        return _NAMES[found["bare"]]

    return _OPTION.sub(said, sentence)
