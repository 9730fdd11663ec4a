"""Hands campaigns to workers, writes what comes back, and goes on where a killed run was."""

from __future__ import annotations

import itertools
import os
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from typing import IO, Any

from .._native import DashpotError
from ..campaign import Campaign
from ..identification import fit
from .cluster import Place, client_of, has_dashboard
from .examine import Plan, examine_all
from .jobs import Job
from .store import Store

#: Campaigns in a chunk: what one part holds and what a killed run may lose for each worker. At a second each, a part every
#: quarter of a minute; the scheduler's own work, some milliseconds a chunk, does not show.
CHUNK = 16
#: Chunks under way for each worker: one at work and one waiting, so that none idles while a part is written.
AHEAD = 2

Chunk = list[tuple[Job, str]]


@dataclass(frozen=True)
class Outcome:
    """What a run did."""

    campaigns: int
    """Rows of the table."""
    done_before: int
    """Of these, found finished."""
    failed: int
    """Rows with a reason instead of figures."""
    seconds: float


def run(
    jobs: Sequence[Job],
    out: str | os.PathLike[str],
    plan: Plan | None = None,
    place: Place | None = None,
    *,
    chunk: int = CHUNK,
    again: bool = False,
    tell: Callable[[str], object] | None = None,
) -> Outcome:
    """Examines all campaigns and writes the table.

    :param again: do campaigns once more that failed before.
    :param tell: is told progress, a line at a time.
    """
    plan, place = _ready(plan or Plan()), place or Place()
    say = tell or (lambda _: None)
    started = time.monotonic()
    said = plan.said()
    keyed = [(job, job.key(said)) for job in jobs]
    keys = [key for _, key in keyed]
    store = Store(out)
    try:
        if again:
            store.forget(store.failed())
        rest = [(job, key) for job, key in keyed if key not in store.done]
        before = len(keyed) - len(rest)
        if before:
            say(f"{before} of {len(keyed)} campaigns were done before")
        done, failed = before, 0
        if rest:
            with client_of(place, logs=str(store.folder / "slurm")) as client:
                if has_dashboard() and client.dashboard_link:
                    say(f"dashboard: {client.dashboard_link}")
                for rows in _work(client, plan, _chunks(rest, chunk), place.slurm_jobs or 1):
                    store.add(rows)
                    failed += sum(row["status"] == "failed" for row in rows)
                    done += len(rows)
                    spent = time.monotonic() - started
                    rate = (done - before) / spent
                    left = (len(keyed) - done) / rate if rate > 0 else float("inf")
                    say(f"{done} of {len(keyed)} campaigns, {failed} failed, {60 * rate:.1f} a minute, {left / 60:.1f} min left")
        return Outcome(len(keyed), before, store.table(keys), time.monotonic() - started)
    finally:
        store.close()


def _ready(plan: Plan) -> Plan:
    """The plan with the model of the reference damper, which is the same for all."""
    if plan.reference is None or plan.reference_model is not None or plan.diagnose == "none":
        return plan
    good = Campaign.read(plan.reference, **plan.mapping)
    model = fit(good, family=plan.family, elements=plan.elements, hold_out=plan.hold_out)
    return replace(plan, reference_model=model.text)


def _chunks(rest: Sequence[tuple[Job, str]], size: int) -> Iterator[Chunk]:
    for start in range(0, len(rest), max(1, size)):
        yield list(rest[start : start + max(1, size)])


def _work(client: Any, plan: Plan, chunks: Iterator[Chunk], awaited: int) -> Iterator[list[Any]]:
    """Rows chunk by chunk as they come. A few chunks are under way at a time, however many there are.

    :param awaited: workers that will come; more may be there already or join later.
    """
    from distributed import as_completed

    running: dict[Any, Chunk] = {}

    def submit(chunk: Chunk) -> Any:
        # The plan goes with every chunk: what is scattered to a worker is lost with it, and all that needs it.
        future = client.submit(examine_all, chunk, plan, pure=False)
        running[future] = chunk
        return future

    def more() -> list[Any]:
        # Counted each time: jobs of a cluster start when there is room for them, and not all at once.
        ahead = AHEAD * max(awaited, sum(client.nthreads().values()))
        return [submit(chunk) for chunk in itertools.islice(chunks, max(0, ahead - len(running)))]

    pool = as_completed(more(), loop=client.loop)
    suspects: Chunk = []
    for future in pool:
        chunk = running.pop(future)
        rows = _rows(future)
        del future
        for following in more():
            pool.add(following)
        if rows is None:
            suspects.extend(chunk)
        else:
            yield rows
    # Some campaign ended the process of its worker, which takes what waited there with it: each by itself, to find which.
    for job, key in suspects:
        client.wait_for_workers(1)
        future = submit([(job, key)])
        rows = _rows(future)
        if rows is None:
            reason = f"the process that worked on it ended each time ({type(future.exception()).__name__})"
            rows = [{"key": key, **asdict(job), "status": "failed", "reason": reason}]
        yield rows


def _rows(future: Any) -> list[Any] | None:
    """Rows of a chunk; none where its worker died on it again and again."""
    error = future.exception()
    if error is None:
        rows: list[Any] = future.result()
        return rows
    if future.status != "error":
        raise DashpotError("the cluster went away; what was finished is kept, start the run again to go on")
    return None


def to_terminal(stream: IO[str] | None = None) -> Callable[[str], None]:
    """Progress in place on a terminal, line by line elsewhere."""
    target = stream or sys.stderr

    def tell(text: str) -> None:
        if target.isatty() and " min left" in text:
            target.write(f"\r\x1b[K{text}")
        else:
            target.write(f"{text}\n")
        target.flush()

    return tell
