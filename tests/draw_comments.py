"""Draws 100 comment lines of the Rust sources at random, for a reader who has not seen them.

    python3 tests/draw_comments.py SEED

Prints file, line and text. A line counts if it has at least five words, and is neither in a code block nor a link definition."""

import random
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def comment_lines():
    files = subprocess.run(["git", "ls-files", "*.rs"], cwd=ROOT, capture_output=True, text=True, check=True)
    for name in sorted(files.stdout.split()):
        is_code = False
        for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").splitlines(), 1):
            comment = re.match(r"\s*//[/!]?(.*)", line)
            if not comment:
                is_code = False
                continue
            text = comment[1].strip()
            if text.startswith("```"):
                is_code = not is_code
            elif not is_code and len(text.split()) >= 5 and not re.fullmatch(r"\[.*\]:? ?\S*", text):
                yield name, number, text


if len(sys.argv) != 2 or not sys.argv[1].isdigit():
    sys.exit("usage: python3 tests/draw_comments.py SEED")
for name, number, text in random.Random(int(sys.argv[1])).sample(list(comment_lines()), 100):
    print(f"{name}:{number}: {text}")
