"""Evaluation of the formulas of the page of equations: formulas, symbols and constants by section.

A formula is text as printed on the page, `H(φ) = φ (1 + (e / d_h)²) + k_s κ_e P(e)`. A space between two values multiplies them. A name directly
followed by a parenthesis is a function.
"""

import math
import re

import damper

POWERS = {"²": 2, "³": 3, "⁴": 4}
TOKEN = re.compile(
    r"\s*(?:(?P<number>\d+(?:\.\d+)?)|(?P<name>∂s/∂x|[^\W\d²³⁴½¼](?:_\([^)]*\)|(?![²³⁴])[\w'])*)|(?P<other>\^¼|[-+*/()|,;√½²³⁴^]))"
)
FUNCTIONS = {"tanh": math.tanh, "exp": math.exp, "max": max, "min": min, "sgn": damper.sgn}


def python(text):
    """Converts a formula to a Python expression with calls of name() and call()."""
    tokens, at = [], 0
    while at < len(text.rstrip()):
        found = TOKEN.match(text, at)
        if not found:
            raise ValueError(f"{text[at:]!r} in {text!r}")
        tokens.append((found.lastgroup, found[found.lastgroup], found.end()))
        at = found.end()
    out, sizes, roots = [], [], []
    # Whether a value has just ended, so that a following value is multiplied with it.
    ended = False

    def begins():
        if ended:
            out.append("*")

    for place, (kind, token, end) in enumerate(tokens):
        if kind == "name":
            begins()
            if text[end : end + 1] == "(":
                out.append(f"call({token!r}, ")
                ended, skips = False, True
                tokens[place + 1] = ("open", "(", end + 1)
            else:
                out.append(f"name({token!r})")
                ended = True
        elif kind == "number" or token == "½":
            begins()
            out.append("0.5" if token == "½" else token)
            ended = True
        elif kind == "open":
            sizes.append(")")
        elif token == "(":
            begins()
            out.append("(")
            sizes.append(")")
            ended = False
        elif token == "|":
            if sizes and sizes[-1] == "|":
                sizes.pop()
                out.append(")")
                ended = True
            else:
                begins()
                out.append("abs(")
                sizes.append("|")
                ended = False
        elif token == ")":
            sizes.pop()
            out.append(")")
            ended = True
        elif token == "√":
            begins()
            # The root applies to the next operand, with or without parentheses: root**x is the square root of x.
            out.append("root**")
            ended = False
        elif token in POWERS:
            out.append(f"**{POWERS[token]}")
        elif token == "^¼":
            out.append("**0.25")
        elif token == "^":
            out.append("**")
            ended = False
        else:
            out.append({";": ","}.get(token, token))
            ended = False
    return "".join(out)


class Root:
    """Operand for which root**x is the square root of x, with the precedence of a power."""

    def __pow__(self, x):
        return math.sqrt(x)


class Section:
    def __init__(self):
        self.formulas, self.symbols, self.constants, self.used = {}, {}, {}, set()


def sections(page):
    found, section, code, last = {}, Section(), False, None
    for line in page.splitlines():
        if line.startswith("```"):
            code = not code
        elif code:
            for chunk in re.split(r",?\s{2,}", re.sub(r"\s+= ", " = ", line.strip())):
                left, equals, right = chunk.partition("= ")
                left = left.rpartition(": ")[2].strip()
                if equals and not re.search(r'["≤≥<>]', right):
                    last = left or last
                    section.formulas.setdefault(last, []).append(right)
        elif line.startswith("#"):
            section = found.setdefault(line.lstrip("#").strip().strip("`"), Section())
        else:
            row = re.match(r"\| ([^|]+) \| ((?:`[a-z0-9_]+`(?:, )?)+) \|", line)
            if row:
                symbols = [symbol.strip() for symbol in re.sub(r"\([^)]*\)", "", row[1]).split(",")]
                section.symbols.update(zip(symbols, re.findall(r"`([^`]+)`", row[2])))
    for title, constants in damper.constants(page).items():
        found[title].constants = constants
    return found


class Sheet:
    """The page with values for its parameters."""

    def __init__(self, page, parameters):
        self.sections, self.parameters = sections(page), parameters

    def value(self, title, left, which=0, **known):
        """Computes the right side of formula `left` of a section; `which` selects one of several.

        A symbol that is not `known` is a parameter, a constant, or another formula of the section."""
        return self.computed(self.sections[title], left, which, known, [])

    def computed(self, section, left, which, known, asked):
        section.used.add((left, which))
        if left in asked:
            raise RecursionError(f"{left} needs itself: {asked}")
        text = section.formulas[left][which]

        def name(symbol):
            if symbol in known:
                return known[symbol]
            if symbol in section.symbols:
                return self.parameters[section.symbols[symbol]]
            if f"2 {symbol}" in section.symbols:
                return 0.5 * self.parameters[section.symbols[f"2 {symbol}"]]
            if symbol in section.constants:
                return section.constants[symbol]
            if symbol in section.formulas:
                return self.computed(section, symbol, 0, known, [*asked, left])
            raise KeyError(f"{symbol} in {left} = {text}")

        def call(function, *arguments):
            if function in known:
                return known[function](*arguments)
            if function in FUNCTIONS:
                return FUNCTIONS[function](*arguments)
            whole = next(left for left in section.formulas if left.startswith(f"{function}("))
            names = re.split(r"[,;]\s*", whole[len(function) + 1 : -1])
            inner = {**known, **dict(zip(names, arguments))}
            return self.computed(section, whole, known.get("forms", {}).get(whole, 0), inner, [*asked, left])

        return eval(python(text), {"name": name, "call": call, "root": Root(), "__builtins__": {"abs": abs}})

    def expression(self, title, text, **known):
        """Computes any expression in the symbols of a section."""
        section = self.sections[title]
        section.formulas["?"] = [text]
        value = self.computed(section, "?", 0, known, [])
        del section.formulas["?"]
        return value
