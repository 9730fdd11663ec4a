"""``python -m dashpot.fleet``: evaluation of thousands of campaigns from the command line."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from typing import Any

from .._native import DashpotError
from ..limits import read_limits
from .cluster import Place
from .examine import Plan
from .jobs import find_jobs
from .report import check_target, write_report
from .schedule import CHUNK, run, to_terminal

_EXAMPLES = """examples:
  python -m dashpot.fleet campaigns/ --out results.parquet
  python -m dashpot.fleet fleet.csv --out results.parquet --limits limits.csv --reference good/ --report fleet.html
  python -m dashpot.fleet semi_active/ --setting current --out results.parquet --limits limits.csv --report fleet.html
  python -m dashpot.fleet fleet.csv --out results.parquet --scheduler tcp://10.0.0.5:8786
  python -m dashpot.fleet fleet.csv --out results.parquet --slurm 100 --slurm-queue normal

fleet.csv has the columns campaign, serial, batch, date (all but the first may be missing); its paths count from its own folder.
limits.csv is the table of dashpot validate --limits: quantity, velocity_m_s, low, high, or nominal and tolerance; with --setting also setting.
A run that was ended goes on where it was when it is started again: finished campaigns are kept in OUT.parts.
"""


def _pairs(given: Sequence[str], option: str) -> dict[str, str]:
    pairs = {}
    for text in given:
        name, equals, value = text.partition("=")
        if not equals or not name or not value:
            raise DashpotError(f"{option} is given as CHANNEL=..., such as force=kN, not {text!r}")
        pairs[name] = value
    return pairs


def _positive(text: str) -> int:
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return number


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m dashpot.fleet",
        description="Fit every campaign, judge it against limits, diagnose it against a reference damper; one row a damper.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("campaigns", nargs="+", metavar="CAMPAIGNS", help="folders with records, folders of such folders, or lists (CSV)")
    add("--out", required=True, metavar="F.parquet", help="table to write, one row a damper")
    add("--report", metavar="F.html", help="report over the fleet (needs matplotlib)")
    add("--limits", metavar="F.csv", help="what a good damper may do")
    add("--reference", metavar="GOOD", help="campaign of a damper known to be good, through the same tests on the same rig")
    add("--diagnose", choices=("all", "failed", "none"), default="all", help="which are diagnosed against the reference [default: all]")
    add("--max-effects", type=_positive, default=1, metavar="N", help="most effects to add in a diagnosis [default: 1]")
    add("--candidates", metavar="NAMES", help="effects that may be named, separated by commas; all if not given")
    add("--family", choices=("thesis", "fv", "piecewise", "lag"), default="thesis", help="kind of model [default: thesis]")
    add("--setting", metavar="NAME",
        help='fit each damper over this setting of its tests, such as current or clicks; "none" fits tests at several settings as one damper')  # fmt: skip
    add("--elements", metavar="NAMES", help="elements that the fit may use, separated by commas")
    add("--hold-out", metavar="GLOBS", help="tests to leave out of the fit, separated by commas; * stands for anything")
    add("--positive", choices=("rebound", "compression"), help="direction that the files count positive")
    add("--unit", action="append", default=[], metavar="CHANNEL=UNIT", help="unit of a channel whose heading has none")
    add("--column", action="append", default=[], metavar="CHANNEL=HEADING", help="heading of a channel's column")
    add("--ignore", action="append", default=[], metavar="CHANNEL", help="channel to leave unread")
    add("--dates", choices=("day-first", "month-first"), help="which of day and month comes first in dates such as 3/11/2026")
    add("--subfolders", action="store_true",
        help="read the records in the subfolders of a campaign as its tests; the names of their tests begin with the folder")  # fmt: skip
    add("--workers", type=_positive, metavar="N", help="worker processes on this computer [default: one a processor]")
    add("--scheduler", metavar="ADDRESS", help="a Dask cluster to use instead")
    add("--slurm", type=_positive, metavar="JOBS", help="Slurm jobs to start instead, one worker each")
    add("--slurm-queue", metavar="NAME", help="Slurm partition")
    add("--slurm-memory", default="2GB", metavar="SIZE", help="memory of a job [default: 2GB]")
    add("--slurm-walltime", default="24:00:00", metavar="TIME", help="longest time of a job [default: 24:00:00]")
    add("--chunk", type=_positive, default=CHUNK, metavar="N", help=f"campaigns handed out and written together [default: {CHUNK}]")
    add("--retries", type=int, default=2, metavar="N", help="tries again after a fault that is not the campaign's [default: 2]")
    add("--again", action="store_true", help="do campaigns once more that failed before")
    add("--quiet", action="store_true", help="no progress")
    return parser


def _split(text: str | None) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split(",") if part.strip()) if text else ()


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command and returns its exit code: 0, 1 if every campaign failed, 2 after an error message, or 130 after Ctrl-C."""
    args = _parser().parse_args(arguments)
    try:
        mapping: dict[str, Any] = {
            "positive": args.positive,
            "units": _pairs(args.unit, "--unit"),
            "columns": _pairs(args.column, "--column"),
            "ignore": args.ignore,
            "subfolders": args.subfolders,
            "dates": args.dates,
        }
        plan = Plan(
            family=args.family,
            setting=args.setting,
            elements=_split(args.elements) or None,
            hold_out=_split(args.hold_out),
            mapping={name: value for name, value in mapping.items() if value},
            limits=read_limits(args.limits) if args.limits else (),
            reference=args.reference,
            diagnose=args.diagnose,
            max_effects=args.max_effects,
            candidates=_split(args.candidates) or None,
            retries=max(0, args.retries),
        )
        if args.report:
            check_target(args.report)
        place = Place(args.workers, args.scheduler, args.slurm, args.slurm_queue, args.slurm_memory, args.slurm_walltime)
        tell = (lambda _: None) if args.quiet else to_terminal()
        done = run(find_jobs(args.campaigns), args.out, plan, place, chunk=args.chunk, again=args.again, tell=tell)
        print(f"{done.campaigns} campaigns in {args.out}, {done.done_before} of them done before, {done.failed} failed")
        if args.report:
            write_report(args.out, args.report)
            print(f"report: {args.report}")
        if done.failed == done.campaigns:
            print("dashpot.fleet: no campaign could be identified; the table has the reason of each", file=sys.stderr)
            return 1
    except (DashpotError, OSError, UnicodeDecodeError) as error:
        print(f"dashpot.fleet: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("dashpot.fleet: ended; what was finished is kept, start it again to go on", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
