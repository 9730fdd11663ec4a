"""Dask clients on this computer, on a Dask cluster, or on Slurm."""

from __future__ import annotations

import contextlib
import importlib.util
import logging
import signal
import subprocess
import tempfile
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from .._native import DashpotError


@dataclass(frozen=True)
class Place:
    """Location of the workers. Without an address and Slurm jobs, it is this computer."""

    workers: int | None = None
    """Number of worker processes on this computer; one for each processor if not given."""
    address: str | None = None
    """Address of the scheduler of a Dask cluster, such as ``tcp://10.0.0.5:8786``."""
    slurm_jobs: int | None = None
    """Number of Slurm jobs, each with one worker. Jobs that end too early are replaced."""
    slurm_queue: str | None = None
    slurm_memory: str = "2GB"
    slurm_walltime: str = "24:00:00"


def has_dashboard() -> bool:
    """Returns whether Dask's dashboard can run on this computer. It requires Bokeh."""
    return importlib.util.find_spec("bokeh") is not None


@contextlib.contextmanager
def client_of(place: Place, logs: str | None = None) -> Iterator[Any]:
    """Context of a Dask client. Workers that were started for it are stopped at its end.

    :param logs: folder for the output of Slurm jobs.
    """
    try:
        import distributed
    except ImportError as error:
        raise DashpotError("a fleet needs Dask: pip install 'dashpot[fleet]'") from error
    from dask import config

    with contextlib.ExitStack() as stack:
        # Dask must not retry a chunk whose worker died. It would give the chunk to new workers, which would die during their start, and such
        # workers are not restarted. Instead, `schedule` retries the campaigns of the chunk one at a time.
        stack.enter_context(config.set({"distributed.scheduler.allowed-failures": 0}))
        if place.address is not None:
            target: Any = place.address
        elif place.slurm_jobs is not None:
            target = stack.enter_context(_slurm(place, place.slurm_jobs, logs))
        else:
            target = stack.enter_context(
                distributed.LocalCluster(
                    n_workers=place.workers,
                    threads_per_worker=1,
                    processes=True,
                    # Port 0 selects a free port, because another cluster may use the default port.
                    dashboard_address=":0",
                    silence_logs=logging.ERROR,
                )
            )
        yield stack.enter_context(_connected(target))


def _connected(target: Any) -> Any:
    import distributed
    from distributed.comm.addressing import get_address_host_port

    try:
        if isinstance(target, str):
            # Rejects an invalid address, because a client with it would delay the end of the program by a minute.
            get_address_host_port(target)
        return distributed.Client(target, set_as_default=False)
    except (OSError, ValueError, distributed.TimeoutError) as error:
        if not isinstance(target, str):
            raise
        said = str(error) or type(error).__name__
        raise DashpotError(f"there is no Dask scheduler at {target}: {said}; an address is such as tcp://10.0.0.5:8786") from error


#: First waiting time for a worker, s, after which a message is shown. Each further waiting time is four times longer, up to 600 s.
_PATIENCE = 5.0


def wait_for_workers(client: Any, say: Callable[[str], object]) -> None:
    """Waits until the cluster has a worker. Passes messages to ``say`` while it has none."""
    import distributed

    pause = _PATIENCE
    while not client.nthreads():
        try:
            client.wait_for_workers(1, timeout=pause)
        except distributed.TimeoutError:
            say("the cluster has no worker yet; campaigns begin when it has one (Ctrl-C ends the run)")
            pause = min(600.0, 4 * pause)


#: Interval of the check for missing Slurm jobs.
_LOOK = "5s"


def slurm_cluster() -> Any:
    """Imports the class of Slurm clusters, and restores the handler of Ctrl-C afterwards.

    The import of dask-jobqueue installs a handler that ends the process.
    """
    handler = signal.getsignal(signal.SIGINT)
    try:
        from dask_jobqueue.slurm import SLURMCluster
    except ImportError as error:
        raise DashpotError("Slurm needs dask-jobqueue: pip install 'dashpot[slurm]'") from error
    finally:
        if handler is not None and threading.current_thread() is threading.main_thread():
            signal.signal(signal.SIGINT, handler)
    return SLURMCluster


def _slurm(place: Place, jobs: int, logs: str | None) -> Any:
    cluster = slurm_cluster()(
        cores=1,
        processes=1,
        memory=place.slurm_memory,
        queue=place.slurm_queue,
        walltime=place.slurm_walltime,
        log_directory=logs,
    )
    try:
        _ask_slurm(cluster.job_script())
    except BaseException:
        cluster.close()
        raise
    # With `scale`, jobs that Slurm ends (walltime, preemption) would not be replaced, and the run would wait forever after the last one.
    cluster.adapt(minimum_jobs=jobs, maximum_jobs=jobs, interval=_LOOK)
    return cluster


def _ask_slurm(script: str) -> None:
    """Checks with ``sbatch --test-only`` that Slurm accepts the job, because the cluster does not report a rejected job.

    :raises DashpotError: if Slurm rejects the job, or this computer has no ``sbatch``.
    """
    with tempfile.NamedTemporaryFile("w", suffix=".sh") as file:
        file.write(script)
        file.flush()
        try:
            asked = subprocess.run(["sbatch", "--test-only", file.name], capture_output=True, text=True, check=False)
        except FileNotFoundError as error:
            raise DashpotError("there is no sbatch on this computer: --slurm works where jobs are submitted to Slurm") from error
    if asked.returncode:
        said = " ".join(line.split(":", 2)[-1].strip() for line in asked.stderr.strip().splitlines())
        raise DashpotError(f"Slurm does not take the jobs: {said}; look at --slurm-queue, --slurm-memory and --slurm-walltime")
