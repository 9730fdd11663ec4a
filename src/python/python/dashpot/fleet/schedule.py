"""Distribution of campaigns to workers, storage of their rows, and continuation of a killed run."""

from __future__ import annotations

import itertools
import os
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import IO, Any

import pyarrow.parquet as pq

from .._native import DashpotError, Figures, RecordError, SettingsFigures
from ..campaign import Campaign
from ..family import Family
from .checks import checked
from .cluster import Place, client_of, has_dashboard, wait_for_workers
from .examine import PASSING, Plan, examine_all, fitted, in_two_directions, judged
from .jobs import Job
from .store import NOT_DONE, Store

#: Number of campaigns in a chunk, whose rows form one part. A killed run can lose the work on one or two chunks of each worker. At 1 s per
#: campaign, a worker completes a chunk every 16 s, so the scheduler's few milliseconds per chunk are negligible.
CHUNK = 16
#: Number of submitted chunks for each worker: one in work and one waiting, so that no worker is idle while a part is written.
AHEAD = 2

Chunk = list[tuple[Job, str]]


@dataclass(frozen=True)
class Outcome:
    """Result of a run."""

    campaigns: int
    """Number of rows of the table."""
    done_before: int
    """Number of rows that an earlier run had finished."""
    failed: int
    """Number of rows with the reason of a failure instead of results."""
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
    """Evaluates all campaigns and writes the table.

    :param again: evaluates failed campaigns of earlier runs again.
    :param tell: function that receives progress messages, one line at a time.
    :raises DashpotError: if jobs, plan or place are invalid, before the first campaign is evaluated. The message names the invalid argument.
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
            """Returns the entries of the job list for this row, and the verdict of this run's limits on its measured values."""
            kind = Figures if plan.over is None else SettingsFigures
            measured = kind.parse(row["measured"]) if row["measured"] else None
            settings = [one["setting"] for one in row["settings"] or ()]
            return {**asdict(given[place]), **judged(plan.limits, measured, row["setting_unit"] or "", settings)}

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
    """Prepares a row for storage. A row with a temporary failure of an existing campaign gets a key that does not count as finished."""
    if not row.get(PASSING) or not os.path.exists(row["campaign"]):
        return row
    return {**row, "key": row["key"] + NOT_DONE, "reason": f"{row['reason']}; the next run tries it again"}


def _ready(plan: Plan) -> Plan:
    """Returns the plan with the model of the reference damper, which is fitted once for all campaigns."""
    if plan.reference is None or plan.reference_model is not None or plan.diagnose == "none":
        return plan
    good = Campaign.read(plan.reference, **plan.mapping)
    model = fitted(good, plan)
    if plan.over is not None and not isinstance(model, Family):
        raise DashpotError(f"the reference {plan.reference} has tests at one {plan.over}; a damper over {plan.over} needs at least two")
    return replace(plan, reference_model=model.text)


def _chunks(rest: Sequence[tuple[Job, str]], size: int) -> Iterator[Chunk]:
    for start in range(0, len(rest), size):
        yield list(rest[start : start + size])


def _work(client: Any, plan: Plan, chunks: Iterator[Chunk], awaited: int) -> Iterator[list[Any]]:
    """Yields the rows of each chunk when the chunk is finished. Only a few chunks are submitted at a time.

    :param awaited: smallest number of workers for which chunks are submitted, because not all workers may have started yet.
    """
    from distributed import as_completed

    running: dict[Any, Chunk] = {}

    def submit(chunk: Chunk) -> Any:
        # Every chunk contains the plan. Data that is scattered to a worker would be lost with this worker, and so would all dependent tasks.
        future = client.submit(examine_all, chunk, plan, pure=False)
        running[future] = chunk
        return future

    def more() -> list[Any]:
        # The number of workers is evaluated each time, because the jobs of a cluster start one after another.
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
    # A campaign that ends the process of its worker loses all chunks of this worker. Therefore each of their campaigns is submitted alone.
    for job, key in suspects:
        client.wait_for_workers(1)
        future = submit([(job, key)])
        rows = _rows(future)
        if rows is None:
            reason = f"the process that worked on it ended each time ({type(future.exception()).__name__})"
            rows = [{"key": key, **asdict(job), "status": "failed", "reason": reason}]
        yield rows


def _rows(future: Any) -> list[Any] | None:
    """Returns the rows of a chunk, or None if its worker died or its rows were lost.

    :raises DashpotError: if the cluster is no longer reachable.
    """
    if future.exception() is None:
        try:
            rows: list[Any] = future.result()
            return rows
        except Exception:  # noqa: BLE001
            # `examine_all` raises no exception. So the worker ended after the work, before the rows were fetched, and the rows are lost.
            pass
    if future.status != "error":
        raise DashpotError("the cluster went away; what was finished is kept, start the run again to go on")
    return None


def to_terminal(stream: IO[str] | None = None) -> Callable[[str], None]:
    """Makes a function that writes progress messages. On a terminal, progress replaces its last line; elsewhere, each message is a line."""
    target = stream or sys.stderr

    def tell(text: str) -> None:
        if target.isatty() and " min left" in text:
            target.write(f"\r\x1b[K{text}")
        else:
            target.write(f"{text}\n")
        target.flush()

    return tell
