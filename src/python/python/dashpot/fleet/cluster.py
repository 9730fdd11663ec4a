"""Where the work runs: this computer, a Dask cluster, or Slurm."""

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
    """Where the work runs. This computer where neither an address nor Slurm jobs are given."""

    workers: int | None = None
    """Worker processes on this computer; one for each processor if not given."""
    address: str | None = None
    """Scheduler of a Dask cluster, such as ``tcp://10.0.0.5:8786``."""
    slurm_jobs: int | None = None
    """Slurm jobs, one worker each; those that end before the work does are replaced."""
    slurm_queue: str | None = None
    slurm_memory: str = "2GB"
    slurm_walltime: str = "24:00:00"


def has_dashboard() -> bool:
    """Whether Dask's dashboard can run here; without it there is progress on the terminal alone."""
    return importlib.util.find_spec("bokeh") is not None


@contextlib.contextmanager
def client_of(place: Place, logs: str | None = None) -> Iterator[Any]:
    """A Dask client at that place; what was started for it ends with it.

    :param logs: folder for what Slurm jobs say.
    """
    try:
        import distributed
    except ImportError as error:
        raise DashpotError("a fleet needs Dask: pip install 'dashpot[fleet]'") from error
    from dask import config

    with contextlib.ExitStack() as stack:
        # A chunk whose worker died is taken apart and tried again by us, one campaign at a time. Were it handed to fresh workers
        # right away, each would die while it starts, and a worker that dies so early is not started again.
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
                    # Any free port: another cluster may have the usual one.
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
            # A client of an address that cannot be would hold up the end of the program for a minute.
            get_address_host_port(target)
        return distributed.Client(target, set_as_default=False)
    except (OSError, ValueError, distributed.TimeoutError) as error:
        if not isinstance(target, str):
            raise
        said = str(error) or type(error).__name__
        raise DashpotError(f"there is no Dask scheduler at {target}: {said}; an address is such as tcp://10.0.0.5:8786") from error


#: How long is waited for a first worker, s, before that is said, and said again.
_PATIENCE = 5.0


def wait_for_workers(client: Any, say: Callable[[str], object]) -> None:
    """Waits until the cluster has a worker, and says so where it has none for long."""
    import distributed

    pause = _PATIENCE
    while not client.nthreads():
        try:
            client.wait_for_workers(1, timeout=pause)
        except distributed.TimeoutError:
            say("the cluster has no worker yet; campaigns begin when it has one (Ctrl-C ends the run)")
            pause = min(600.0, 4 * pause)


#: How often it is looked whether jobs are missing.
_LOOK = "5s"


def slurm_cluster() -> Any:
    """The class of clusters on Slurm. Its package ends the process at Ctrl-C from its import on; here Ctrl-C keeps its handler."""
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
    # Not `scale`: jobs that the scheduler ends (walltime, somebody with more right to the computer) would not come back, and
    # with the last of them the run would wait forever.
    cluster.adapt(minimum_jobs=jobs, maximum_jobs=jobs, interval=_LOOK)
    return cluster


def _ask_slurm(script: str) -> None:
    """Whether Slurm would take the job; a job that it refuses is never heard of again otherwise."""
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
