"""Lists the contents of the packages and their licenses, from cargo's list of crates and the files of the crates.

    licences.py texts TARGET PACKAGE...     the license texts of every crate that these packages contain
    licences.py bill TARGET PACKAGE...      a bill of materials, CycloneDX 1.6 as JSON (needs cyclonedx-python-lib)
"""

import json
import os
import re
import subprocess
import sys
import uuid
from datetime import datetime, timezone
from pathlib import Path

# Licenses that require no more than their text with the program. A person reviews any other license before it is shipped.
ALLOWED = {
    "MIT", "Apache-2.0", "Apache-2.0 WITH LLVM-exception", "BSD-1-Clause", "BSD-2-Clause", "BSD-3-Clause", "ISC", "Zlib", "0BSD", "MIT-0",
    "BSL-1.0", "CC0-1.0", "Unlicense", "Unicode-3.0",
    # Licenses of the window's fonts, which are unchanged and have their own names, as these two licenses require.
    "OFL-1.1", "Ubuntu-font-1.0",
}

# Linked parts that are not crates: name, license, description.
BESIDE = {
    "linux": [
        ("Rust standard library", "MIT OR Apache-2.0", "the libraries that come with the Rust compiler"),
        ("LLVM libunwind and compiler-rt", "Apache-2.0 WITH LLVM-exception", "linked by zig in place of libgcc"),
    ],
    "windows": [
        ("Rust standard library", "MIT OR Apache-2.0", "the libraries that come with the Rust compiler"),
        ("libgcc", "GPL-3.0-or-later WITH GCC-exception-3.1", "of GCC; its exception lets programs of any licence hold it"),
        ("mingw-w64 runtime", "ZPL-2.1", "the start of a program for Windows"),
    ],
}


def cargo(target):
    told = subprocess.run(
        ["cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", target],
        check=True, stdout=subprocess.PIPE,
    )
    return json.loads(told.stdout)


def held(metadata, roots):
    """Returns every crate that is part of these packages, by name and version, without those that only build or test."""
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    todo = [identity for identity, package in packages.items() if package["name"] in roots and package["source"] is None]
    if len(todo) != len(set(roots)):
        sys.exit(f"licences.py: this workspace does not have all of {', '.join(roots)}")
    found = set()
    while todo:
        identity = todo.pop()
        if identity not in found:
            found.add(identity)
            deps = nodes[identity]["deps"]
            todo += [dep["pkg"] for dep in deps if any(kind["kind"] is None for kind in dep["dep_kinds"])]
    crates = sorted((packages[identity] for identity in found), key=lambda p: (p["name"], p["version"]))
    return crates, nodes


def expression(package):
    """Returns the license as an SPDX expression. Older crates separate choices by a slash."""
    return re.sub(r"\s*/\s*", " OR ", package["license"] or "")


def may_ship(words):
    """Parses and removes an expression from the front of a list of words, and returns whether it is allowed.

    AND has precedence over OR. At least one choice of each OR must be allowed."""
    def one():
        if words[0] != "(":
            return words.pop(0) in ALLOWED
        words.pop(0)
        allowed = may_ship(words)
        words.pop(0)
        return allowed

    def all_of():
        allowed = one()
        while words and words[0] == "AND":
            words.pop(0)
            allowed = one() and allowed
        return allowed

    allowed = all_of()
    while words and words[0] == "OR":
        words.pop(0)
        allowed = all_of() or allowed
    return allowed


def check(package):
    """Stops the build if the license of a crate was not reviewed."""
    said = expression(package)
    words = re.sub(r"\s+WITH\s+", "_WITH_", said)
    words = [word.replace("_WITH_", " WITH ") for word in re.findall(r"[()]|[^\s()]+", words)]
    if not words or not may_ship(words):
        sys.exit(f"licences.py: {package['name']} {package['version']} is under '{said}', which nobody has looked at; see ALLOWED")


def own_texts(package):
    """Returns name and text of the license and notice files in a crate."""
    folder = Path(package["manifest_path"]).parent
    files = [f for f in folder.iterdir() if re.match(r"(?i)(licen[cs]e|copying|notice|unlicense|copyright)", f.name) and f.is_file()]
    # The license of a font is in the font's folder.
    files += [f for f in folder.glob("fonts/*.txt")]
    return [(f.name, f.read_text(encoding="utf-8", errors="replace").strip()) for f in sorted(files)]


def texts(target, roots):
    crates, _ = held(cargo(target), roots)
    crates = [package for package in crates if package["source"] is not None]
    out = [
        "What dashpot is made with",
        "=========================",
        "",
        f"The programs and libraries in this package hold parts of {len(crates)} crates and of what is listed at the end. Here are their licences,",
        "as the crates themselves bring them. A text that several crates share stands once.",
        "",
    ]
    for package in crates:
        check(package)
    seen, missing = {}, []
    for package in crates:
        title = f"{package['name']} {package['version']}"
        out += ["-" * 78, f"{title}: {expression(package)}"]
        if package["authors"]:
            out.append("by " + ", ".join(re.sub(r"\s*<.*?>", "", author) for author in package["authors"]))
        if package["repository"]:
            out.append(package["repository"])
        own = own_texts(package)
        if not own:
            missing.append(title)
            out += ["", "The crate brings no text of its own; that of its licence stands under another crate here."]
        for name, text in own:
            # Equal words with other line breaks are the same text.
            key = " ".join(text.split())
            if key in seen:
                out += ["", f"{name}: as under {seen[key]}"]
            else:
                seen[key] = f"{title}, {name}"
                out += ["", f"{name}:", "", text]
        out.append("")
    out += ["=" * 78, "Beside crates", ""]
    out += [f"{name}: {licence}; {what}" for name, licence, what in BESIDE["windows" if "windows" in target else "linux"]]
    print("\n".join(out))
    if missing:
        print(f"licences.py: no text of their own: {', '.join(missing)}", file=sys.stderr)


def bill(target, roots):
    from cyclonedx.model.bom import Bom
    from cyclonedx.model.component import Component, ComponentType
    from cyclonedx.model.license import LicenseExpression
    from cyclonedx.output.json import JsonV1Dot6
    from cyclonedx.validation.json import JsonStrictValidator
    from cyclonedx.schema import SchemaVersion
    from packageurl import PackageURL

    crates, nodes = held(cargo(target), roots)
    moment = datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), timezone.utc)

    def component(name, version, licence, kind=ComponentType.LIBRARY, purl=None):
        return Component(
            name=name, version=version, type=kind, purl=purl, bom_ref=f"{name}@{version or ''}", licenses=[LicenseExpression(licence)] if licence else [],
        )

    made = {}
    for package in crates:
        own = package["source"] is None
        purl = None if own else PackageURL("cargo", None, package["name"], package["version"])
        made[package["id"]] = component(package["name"], package["version"], expression(package), purl=purl)
    version = next(package["version"] for package in crates if package["name"] == roots[0])
    whole = component("dashpot", version, "MIT OR Apache-2.0", ComponentType.APPLICATION)
    beside = [component(name, None, licence) for name, licence, _ in BESIDE["windows" if "windows" in target else "linux"]]
    bom = Bom(components=[*made.values(), *beside])
    bom.metadata.component, bom.metadata.timestamp = whole, moment
    # The serial number follows from the parts. A random number would make every build differ.
    parts = "\n".join(sorted(part.bom_ref.value for part in [whole, *made.values(), *beside]))
    bom.serial_number = uuid.uuid5(uuid.NAMESPACE_URL, f"dashpot {target}\n{parts}")
    for identity, part in made.items():
        bom.register_dependency(part, [made[dep["pkg"]] for dep in nodes[identity]["deps"] if dep["pkg"] in made])
    bom.register_dependency(whole, [part for part in made.values() if part.name in roots] + beside)
    text = JsonV1Dot6(bom).output_as_string(indent=2)
    wrong = JsonStrictValidator(SchemaVersion.V1_6).validate_str(text)
    if wrong:
        sys.exit(f"licences.py: the bill is no CycloneDX: {wrong}")
    print(text)


def main():
    if len(sys.argv) < 4 or sys.argv[1] not in ("texts", "bill"):
        sys.exit(__doc__)
    (texts if sys.argv[1] == "texts" else bill)(sys.argv[2], sys.argv[3:])


main()
