"""Hands campaigns to workers, writes what comes back, and goes on where a killed run was."""

from __future__ import annotations

import itertools
import os
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import IO, Any

import pyarrow.parquet as pq

from .._native import DashpotError, Figures, RecordError
from ..campaign import Campaign
from ..identification import fit
from .checks import checked
from .cluster import Place, client_of, has_dashboard, wait_for_workers
from .examine import PASSING, Plan, examine_all, in_two_directions, judged
from .jobs import Job
from .store import NOT_DONE, Store

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
    :raises DashpotError: naming what of jobs, plan or place cannot be, before any campaign is computed.
    """
    if isinstance(chunk, bool) or not isinstance(chunk, int) or chunk < 1:
        raise DashpotError(f"chunk is {chunk!r}; it is a whole number above 0")
    given = [_job(job) for job in jobs]
    plan, place = checked(plan or Plan()), place or Place()
    say = tell or (lambda _: None)
    started = time.monotonic()
    store = Store(out)
    try:
        for part in store.damaged:
            say(f"{store.folder / part} is damaged and was set aside; its campaigns are done anew")
        plan = _ready(plan)
        said = plan.said()
        # A worker may have another working directory.
        work = [replace(job, campaign=os.path.abspath(job.campaign)) for job in given]
        keys = [job.key(said, plan.subfolders) for job in work]
        if again:
            store.forget(store.failed())
        rest = [(job, key) for key, job in dict(zip(keys, work, strict=True)).items() if key not in store.done]
        missing = {key for _, key in rest}
        before = sum(key not in missing for key in keys)
        if before:
            say(f"{before} of {len(keys)} campaigns were done before")
        done, failed = 0, 0
        if rest:
            with client_of(place, logs=str(store.folder / "slurm")) as client:
                if has_dashboard() and client.dashboard_link:
                    say(f"dashboard: {client.dashboard_link}")
                wait_for_workers(client, say)
                for rows in _work(client, plan, _chunks(rest, chunk), place.slurm_jobs or 1):
                    store.add([_kept(row) for row in rows])
                    failed += sum(row["status"] == "failed" for row in rows)
                    done += len(rows)
                    rate = done / (time.monotonic() - started)
                    left = (len(rest) - done) / rate if rate > 0 else float("inf")
                    now = before + done
                    say(f"{now} of {len(keys)} campaigns, {failed} failed, {60 * rate:.1f} a minute, {left / 60:.1f} min left")

        def finish(place: int, row: Mapping[str, Any]) -> Mapping[str, Any]:
            """What the list says of the damper, and what the limits of this run say of what was measured."""
            measured = Figures.parse(row["measured"]) if row["measured"] else None
            return {**asdict(given[place]), **judged(plan.limits, measured)}

        without = store.table(keys, finish)
        read = pq.read_table(out, columns=["positive", "positive_confidence"]).to_pydict()
        turned = in_two_directions(read["positive"], read["positive_confidence"])
        if turned:
            say(f"note: {turned}")
        return Outcome(len(keys), before, without, time.monotonic() - started)
    finally:
        store.close()


def _job(job: Job) -> Job:
    if not isinstance(job, Job):
        raise RecordError(f"jobs are dashpot.fleet.Job, not {type(job).__name__}; dashpot.fleet.find_jobs(paths) makes them")
    return job.checked()


def _kept(row: Mapping[str, Any]) -> Mapping[str, Any]:
    """A row as it is kept. One that failed for what lies outside its campaign is told but not done."""
    if not row.get(PASSING) or not os.path.exists(row["campaign"]):
        return row
    return {**row, "key": row["key"] + NOT_DONE, "reason": f"{row['reason']}; the next run tries it again"}


def _ready(plan: Plan) -> Plan:
    """The plan with the model of the reference damper, which is the same for all."""
    if plan.reference is None or plan.reference_model is not None or plan.diagnose == "none":
        return plan
    good = Campaign.read(plan.reference, **plan.mapping)
    model = fit(good, family=plan.family, elements=plan.elements, hold_out=plan.hold_out)
    return replace(plan, reference_model=model.text)


def _chunks(rest: Sequence[tuple[Job, str]], size: int) -> Iterator[Chunk]:
    for start in range(0, len(rest), size):
        yield list(rest[start : start + size])


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
    if future.exception() is None:
        try:
            rows: list[Any] = future.result()
            return rows
        except Exception:  # noqa: BLE001
            # The work raises nothing. Its worker ended between the end of the work and the fetching of what came out, and took it along.
            pass
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
