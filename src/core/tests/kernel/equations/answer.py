"""Answers cases by the equations of the book: `answer.py PAGE`. Cases come as a list in JSON on standard input; each answer is a line on standard
output: the number of the case, the kind of the answer, its name and its value. A case may `shift` a constant, given as section, name and factor; it
is then answered without its settled state."""

import json
import sys

import damper


def main(page):
    with open(page, encoding="utf-8") as file:
        of_page = damper.constants(file.read())
    for number, case in enumerate(json.load(sys.stdin)):
        constants = of_page
        if "shift" in case:
            section, name, factor = case["shift"]
            shifted = {name: factor * of_page[section][name]}
            constants = {**of_page, section: {**of_page[section], **shifted}}
        around = [case[name] for name in ("x", "v", "side_force", "temperature")]
        model = damper.Damper(case["elements"], case["parameters"], constants)
        parts, rates = model.instant(*around, case["states"])
        answers = {"part": parts, "rate": rates}
        if "shift" not in case:
            answers["settled"] = model.settled(*around)
        for kind, named in answers.items():
            for name, value in named.items():
                print(number, kind, name, repr(float(value)))


if __name__ == "__main__":
    main(*sys.argv[1:])
