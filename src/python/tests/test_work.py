"""Tests of long work: interruption by Ctrl-C, work in threads, and work in processes."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from fleets import damper, measure

import dashpot


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> dashpot.Campaign:
    folder = tmp_path_factory.mktemp("own") / "campaign"
    measure(damper(), folder, seed=1)
    return dashpot.Campaign.read(folder)


def at_first_word(act: Callable[[], object]) -> tuple[Callable[[float, str], object], list[str]]:
    """Makes a progress function that calls ``act`` at its first call, and the list of the texts that it received."""
    told: list[str] = []

    def progress(done: float, text: str) -> None:
        if not told:
            act()
        told.append(text)

    return progress, told


@pytest.mark.skipif(sys.platform == "win32", reason="no signals to send")
@pytest.mark.parametrize("work", ["fit", "diagnose", "validate", "against", "read"])
@pytest.mark.filterwarnings("ignore:the model file names no tests")
def test_ctrl_c_stops_it(own: dashpot.Campaign, work: str) -> None:
    """A signal during the work stops it without a result, and the same work succeeds afterwards."""
    model = damper()
    begun = threading.Event()
    progress, told = at_first_word(begun.set)
    calls: dict[str, Callable[[], object]] = {
        "fit": lambda: dashpot.fit(own, progress=progress),
        "diagnose": lambda: dashpot.diagnose(model, own, progress=progress),
        "validate": lambda: model.validate(own, progress=lambda d, t: (progress(d, t), stopped.wait(1.0))),
        # The signal comes at the first model for comparison, and not before.
        "against": lambda: model.validate(own, against=["spencer", "network"], progress=lambda d, t: progress(d, t) if t == "spencer" or told else None),
        "read": lambda: dashpot.Campaign.read(own.paths[0], progress=lambda d, t: (progress(d, t), stopped.wait(1.0))),
    }
    stopped = threading.Event()

    def press() -> None:
        begun.wait(60)
        os.kill(os.getpid(), signal.SIGINT)

    hand = threading.Thread(target=press)
    hand.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            calls[work]()
    finally:
        stopped.set()
        hand.join()
    before = len(told)
    progress(1.0, "again")
    calls[work]()
    assert len(told) > before + 1


@pytest.mark.skipif(sys.platform == "win32", reason="no signals to send")
@pytest.mark.parametrize("work", ["simulate", "steady_force"])
def test_ctrl_c_stops_long_motions_and_curves_in_the_middle(work: str) -> None:
    model = damper()
    t = np.linspace(0, 20, 2001)
    calls: dict[str, Callable[[], object]] = {
        "simulate": lambda: model.simulate(t, 0.02 * np.sin(20 * t), step_s=5e-6),
        "steady_force": lambda: model.steady_force(np.linspace(-1, 1, 10_000_000)),
    }
    started = time.monotonic()
    calls[work]()
    whole = time.monotonic() - started
    hand = threading.Timer(0.1 * whole, os.kill, (os.getpid(), signal.SIGINT))
    started = time.monotonic()
    hand.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            calls[work]()
    finally:
        hand.join()
    assert time.monotonic() - started < 0.6 * whole


@pytest.mark.parametrize("work", ["simulate", "steady_force"])
def test_long_motions_and_curves_give_the_lock_back(work: str) -> None:
    model = damper()
    t = np.linspace(0, 20, 2001)
    calls: dict[str, Callable[[], object]] = {
        "simulate": lambda: model.simulate(t, 0.02 * np.sin(20 * t), step_s=5e-6),
        "steady_force": lambda: model.steady_force(np.linspace(-1, 1, 10_000_000)),
    }
    worker = threading.Thread(target=calls[work])
    started = time.monotonic()
    worker.start()
    ticks = 0
    while worker.is_alive():
        time.sleep(0.002)
        ticks += 1
    # Hundreds of ticks per second are expected. The limit is ten, because the machine may be busy. With a held lock, there would be none.
    assert ticks > 10 * (time.monotonic() - started)


def test_a_long_motion_tells_its_progress() -> None:
    told: list[tuple[float, str]] = []
    damper().simulate([0, 1], [0, 0.01], step_s=1e-5, progress=lambda d, t: told.append((d, t)))
    assert len(told) > 3 and told == sorted(told) and {text for _, text in told} == {"simulating"}
    with pytest.raises(KeyError):
        damper().simulate([0, 1], [0, 0.01], progress=lambda d, t: {"never": 0}[t])


def test_an_exception_of_the_progress_function_stops_it(own: dashpot.Campaign) -> None:
    told: list[float] = []

    def refuse(done: float, text: str) -> None:
        told.append(done)
        raise KeyError(text)

    with pytest.raises(KeyError):
        dashpot.fit(own, progress=refuse)
    assert len(told) == 1 and told[0] < 1.0


def _fitted(campaign: dashpot.Campaign) -> str:
    return dashpot.fit(campaign, family="fv").text


def _stepped(model: dashpot.Model) -> list[float]:
    forces = dashpot.Damper(model, np.zeros(1000)).step(np.linspace(-1, 1, 1000), 1e-3)
    return list(np.asarray(forces))


@pytest.mark.filterwarnings("ignore::DeprecationWarning")  # Python warns of a fork of a process with several threads
@pytest.mark.parametrize("method", multiprocessing.get_all_start_methods())
def test_processes_fit_and_step(own: dashpot.Campaign, method: str) -> None:
    """Processes work even if they were forked after threads had been started, which a child process does not have."""
    model = damper()
    expected = _fitted(own), _stepped(model)
    with multiprocessing.get_context(method).Pool(2) as pool:
        fitted, stepped = pool.map_async(_fitted, [own, own]), pool.map_async(_stepped, [model, model])
        assert fitted.get(120) == [expected[0]] * 2
        assert stepped.get(120) == [expected[1]] * 2


def test_threads_fit_beside_each_other(own: dashpot.Campaign) -> None:
    with ThreadPoolExecutor(3) as threads:
        assert set(threads.map(_fitted, [own] * 3)) == {_fitted(own)}


def test_the_number_of_threads_changes_no_digit(own: dashpot.Campaign) -> None:
    expected = _fitted(own), _stepped(damper())
    try:
        for count in (1, 3):
            dashpot.set_threads(count)
            assert (_fitted(own), _stepped(damper())) == expected
        with pytest.raises(ValueError, match="threads"):
            dashpot.set_threads(-1)
    finally:
        dashpot.set_threads(0)


def test_one_damper_cannot_be_stepped_twice_at_a_time() -> None:
    many = dashpot.Damper(damper(), np.zeros(200_000))
    refused: list[BaseException] = []

    def hammer() -> None:
        for _ in range(10):
            try:
                many.step(0.1, 1e-3)
            except BaseException as error:  # noqa: BLE001
                refused.append(error)

    threads = [threading.Thread(target=hammer) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert refused and all(isinstance(e, dashpot.StepError) and "another thread" in str(e) for e in refused), refused[:1]


def test_everything_goes_through_pickle(own: dashpot.Campaign, tmp_path: Path) -> None:
    model = dashpot.fit(own, family="fv")
    validation = model.validate(own)
    found = dashpot.diagnose(model, own, candidates=["free_play"], max_effects=1)
    many = dashpot.Damper([model, damper()], [0.0, 0.01])
    many.step(0.3, 1e-3)

    again = pickle.loads(pickle.dumps(own))
    assert again.to_dict() == own.to_dict() and again.paths == own.paths
    assert [r.fingerprint for r in again] == [r.fingerprint for r in own]
    assert dashpot.fit(again, family="fv") == model
    record = pickle.loads(pickle.dumps(own[1]))
    assert record == own[1] and np.array_equal(record.force, own[1].force) and record.fingerprint == own[1].fingerprint
    assert len(pickle.dumps(own[1])) < len(pickle.dumps(own)) / 2
    plain = dashpot.Record.from_dict(own[1].to_dict())
    assert pickle.loads(pickle.dumps(plain)) == plain

    kept = pickle.loads(pickle.dumps(validation))
    test = validation.tests[0].name
    assert kept == validation and np.array_equal(kept.forces(test), validation.forces(test))
    assert kept.campaign.names == own.names
    kept = pickle.loads(pickle.dumps(found))
    assert kept == found and kept.improved == found.improved
    assert np.array_equal(kept.curves(test)["after"], found.curves(test)["after"])
    kept = pickle.loads(pickle.dumps(many))
    assert np.array_equal(kept.state, many.state) and np.array_equal(kept.step(0.1, 1e-3), many.step(0.1, 1e-3))
    single = dashpot.Damper(model, 0.01)
    assert pickle.loads(pickle.dumps(single)).step(0.1, 1e-3) == single.step(0.1, 1e-3)


def test_results_are_short_at_a_prompt(own: dashpot.Campaign) -> None:
    model = dashpot.fit(own, family="fv")
    validation = model.validate(own)
    for result in (own, own[0], model, model.fit, validation, validation.tests[0], model.simulate([0, 1], [0, 0.01])):
        assert 20 < len(repr(result)) < 800, repr(result)
    assert f"tests=<{len(own)} of TestValidation>" in repr(validation)
    assert "N>" in repr(model.simulate([0, 1], [0, 0.01]))


@pytest.mark.parametrize("work", [
    "dashpot.fit(campaign)", "[model.simulate(t, x) for _ in range(10**6)]", "model.simulate(t, x, step_s=1e-6)",
    "model.steady_force(np.full(10**8, 0.1))",
])
def test_a_thread_that_works_when_the_program_ends_does_not_abort_it(own: dashpot.Campaign, work: str) -> None:
    """The process is not aborted, although Python does not wait for such a thread and ends before its work returns."""
    program = (
        "import threading, time, numpy as np, dashpot\n"
        "from fleets import damper\n"
        f"campaign, model = dashpot.Campaign.read({own.paths[0]!r}), damper()\n"
        "t = np.arange(0, 20, 1e-4); x = 0.02 * np.sin(20 * t)\n"
        "begun = threading.Event()\n"
        f"threading.Thread(target=lambda: (begun.set(), {work}), daemon=True).start()\n"
        "begun.wait(); time.sleep(0.3)\n"
        "print('end')\n"
    )
    ran = subprocess.run([sys.executable, "-c", program], cwd=Path(__file__).parent, capture_output=True, text=True, check=False, timeout=120)
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "end\n", "")
