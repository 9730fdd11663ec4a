"""Computes cases with the equations of the book: `answer.py PAGE`.

Standard input is a JSON list of cases. Each result is a line on standard output: number of the case, kind of the result, its name and its value. A
case may `shift` a constant, given as section, name and factor. Its steady state is then not computed."""

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
