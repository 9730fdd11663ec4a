"""Tests of fleets: no result is lost, no campaign is evaluated twice, and the table does not depend on the workers."""

from __future__ import annotations

import datetime
import importlib.util
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fleets import TESTS, damper, fleet, measure, turn

import dashpot
from dashpot._native import Figures
from dashpot.limits import rows as rows_of

pq = pytest.importorskip("pyarrow.parquet")
distributed = pytest.importorskip("distributed")

from dashpot.fleet import Job, Limit, Place, find_jobs, read_limits, write_report  # noqa: E402
from dashpot.fleet import run as run_jobs  # noqa: E402
from dashpot.fleet.checks import checked  # noqa: E402
from dashpot.fleet.cluster import wait_for_workers  # noqa: E402
from dashpot.fleet.examine import Plan, examine, examine_all  # noqa: E402
from dashpot.fleet.files import RECORDS  # noqa: E402
from dashpot.fleet.schedule import _kept, _rows  # noqa: E402
from dashpot.fleet.report import Quantity, figure_of  # noqa: E402
from dashpot.fleet.store import Store  # noqa: E402
from dashpot.fleet.statistics import batches, control, drift, far_off  # noqa: E402

#: Elements of the test dampers. A fit with these elements takes 0.2 s.
ELEMENTS = "series_compliance,coulomb_friction,gas_preload"


def start(*arguments: str | Path) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "dashpot.fleet", *map(str, arguments)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)


def run(*arguments: str | Path) -> str:
    process = start(*arguments)
    out, err = process.communicate(timeout=600)
    assert process.returncode == 0, err
    return out + err


#: Number of dampers in the fleet.
COUNT = 24


@pytest.fixture(scope="module")
def cluster() -> Iterator[list[str]]:
    """Starts a Dask cluster before the run, and yields the arguments that select it."""
    import distributed

    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs="ERROR") as local:
        yield ["--scheduler", local.scheduler_address]


@pytest.fixture(scope="module")
def campaigns(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Makes the list of a fleet in which one campaign is missing, one is unreadable, and one damper has high friction."""
    folder = tmp_path_factory.mktemp("fleet")
    listed = fleet(folder, COUNT)
    shutil.rmtree(folder / "d00007")
    for file in (folder / "d00011").iterdir():
        file.write_text("this is no record\n")
    shutil.rmtree(folder / "d00013")
    measure(damper(friction=90), folder / "d00013", seed=13)
    return listed


def rows(path: Path) -> list[dict[str, Any]]:
    table: list[dict[str, Any]] = pq.read_table(path).to_pylist()
    return table


def test_one_worker_and_two_make_the_same_bytes(campaigns: Path, tmp_path: Path) -> None:
    common: list[str | Path] = [campaigns, "--family", "fv", "--chunk", "3", "--quiet"]
    run(*common, "--workers", "1", "--out", tmp_path / "one.parquet")
    run(*common, "--workers", "2", "--out", tmp_path / "two.parquet")
    assert (tmp_path / "one.parquet").read_bytes() == (tmp_path / "two.parquet").read_bytes()


def test_bad_campaigns_are_rows_and_the_others_have_their_numbers(campaigns: Path, cluster: list[str], tmp_path: Path) -> None:
    limits = tmp_path / "limits.csv"
    limits.write_text(
        "quantity,velocity_m_s,low,high\nfriction,,,60\nforce,0.262,900,1600\ngas_force,,100,180\nhysteresis,0.26,,400\n"
    )
    out = tmp_path / "fleet.parquet"
    said = run(campaigns, "--elements", ELEMENTS, "--limits", limits, "--out", out, "--report", tmp_path / "fleet.html", *cluster)
    assert f"{COUNT} campaigns" in said and "2 failed" in said
    table = rows(out)
    assert [r["serial"] for r in table] == [f"SN{k:05d}" for k in range(COUNT)]
    assert table[7]["status"] == "failed" and "d00007" in table[7]["reason"]
    assert table[11]["status"] == "failed" and "d00011" in table[11]["reason"]
    good = [r for r in table if r["status"] == "ok"]
    assert len(good) == COUNT - 2
    assert [r["serial"] for r in good if r["judgement"] == "failed"] == ["SN00013"]
    assert table[13]["missed"][0].startswith("friction: ")
    for row in good:
        assert row["coulomb_force_low"] <= row["coulomb_force"] <= row["coulomb_force_high"]
        assert row["batch"] and row["date"].startswith("2026-")
    # A row equals the results of the package for this campaign alone, and its model can be simulated.
    campaign = dashpot.Campaign.read(campaigns.parent / "d00000")
    model = dashpot.fit(campaign, elements=ELEMENTS.split(","))
    assert table[0]["model"] == model.text
    assert table[0]["coulomb_force"] == model["coulomb_force"]
    assert table[0]["force_at_+0.262_m_s"] == model.steady_force(0.262)[0]
    report = (tmp_path / "fleet.html").read_text()
    assert "SN00013" in report and "coulomb_force" in report and "d00011" in report and report.count("<img") > 5
    # The report begins with the numbers of verdicts. Then it has one row with the verdict for each damper.
    assert f"Limits: {COUNT - 3} PASS, 1 FAIL." in report
    listed = report[report.index("<h2>Dampers</h2>") :].split("</table>")[0].split("<tr>")[2:]
    assert [row.split("</td>")[0].removeprefix("<td>") for row in listed] == [f"SN{k:05d}" for k in range(COUNT)]
    assert "FAIL: friction" in listed[13] and "PASS" in listed[0] and "not identified" in listed[7]


def test_a_row_names_the_tests_that_were_left_out(tmp_path: Path) -> None:
    measure(damper(), tmp_path / "d", seed=1)
    spoilt = tmp_path / "d" / "a5_v130.csv"
    head, *rows = spoilt.read_text().splitlines()
    spoilt.write_text("\n".join([head, *(row.rsplit(",", 1)[0] + ",500.0" for row in rows)]) + "\n")
    row = examine(find_jobs([tmp_path / "d"])[0], "key", Plan(elements=tuple(ELEMENTS.split(","))))
    assert row["status"] == "ok" and row["tests"] == 4
    assert "a5_v130" in row["notes"][0]


def test_a_reference_names_what_changed(campaigns: Path, cluster: list[str], tmp_path: Path) -> None:
    measure(damper(), tmp_path / "good", seed=99)
    out = tmp_path / "changed.parquet"
    few = [campaigns.parent / f"d{k:05d}" for k in range(10, 20) if k != 11]
    run(
        *few, "--elements", ELEMENTS, "--reference", tmp_path / "good", "--candidates", "free_play",
        "--out", out, "--report", tmp_path / "r.html", "--quiet", *cluster,
    )  # fmt: skip
    row = next(r for r in rows(out) if r["serial"] == "d00013")
    assert row["verdict"] is not None and row["summary"]
    changed = {c["name"]: c for c in row["changes"]}
    friction = changed["coulomb_force"]
    # The interval belongs to the change, so an error of the reference's value shifts both ends.
    assert friction["low"] <= friction["reference"] + 60 <= friction["high"]
    assert friction["reference"] == pytest.approx(30, abs=5)
    report = (tmp_path / "r.html").read_text()
    outlier = report[report.index("<h2>Outliers") :].split("d00013")[1].split("</tr>")[0]
    assert "changed: coulomb_force" in outlier


def test_a_report_tells_a_drift(tmp_path: Path) -> None:
    """The report shows a drift of friction that increases with the serial number. The list has another order than the serial numbers."""
    pytest.importorskip("matplotlib")
    noise = np.random.default_rng(5)
    store = Store(tmp_path / "t.parquet")
    order = noise.permutation(60).tolist()
    number = {"name": "coulomb_force", "index": None, "unit": "N", "standing": "identified"}
    store.add(
        [
            {
                "key": f"k{k}", "campaign": f"c{k}", "serial": f"D{k}", "batch": "", "date": "", "status": "ok",
                "parameters": [{**number, "value": v, "low": v - 1, "high": v + 1}],
            }
            for k in order
            for v in [30 + 0.2 * k + float(noise.normal())]
        ]
    )  # fmt: skip
    store.table([f"k{k}" for k in order])
    store.close()
    write_report(tmp_path / "t.parquet", tmp_path / "t.html")
    text = (tmp_path / "t.html").read_text()
    assert "in 100 serial numbers" in text and "in 30 days" not in text
    slope = float(text.split("drifts by ")[1].split(" ")[0])
    assert slope == pytest.approx(20, abs=3)


def kill(process: subprocess.Popen[str]) -> None:
    """Kills a run and its workers at the same time, so that no handler can run."""
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def test_a_run_that_is_killed_goes_on_where_it_was(campaigns: Path, cluster: list[str], tmp_path: Path) -> None:
    arguments: list[str | Path] = [campaigns, "--family", "fv", "--chunk", "1", "--workers", "2"]
    whole, out = tmp_path / "whole.parquet", tmp_path / "killed.parquet"
    run(*arguments[:-2], *cluster, "--out", whole, "--quiet")
    parts = tmp_path / "killed.parquet.parts"
    written = 0
    for _ in range(2):
        process = start(*arguments, "--out", out)
        deadline = time.monotonic() + 120
        while len(list(parts.glob("part-*"))) <= written and process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.01)
        kill(process)
        before, written = written, len(list(parts.glob("part-*")))
        assert written > before
    assert not out.exists()
    kept = {p.name: p.stat().st_mtime_ns for p in parts.glob("part-*")}
    said = run(*arguments, "--out", out)
    assert "0 of them done before" not in said
    # Finished parts are unchanged, and the table equals that of an uninterrupted run.
    assert {n: (parts / n).stat().st_mtime_ns for n in kept} == kept
    assert out.read_bytes() == whole.read_bytes()
    assert f"{COUNT} of them done before" in run(*arguments, "--out", out)
    assert out.read_bytes() == whole.read_bytes()


def test_a_changed_record_is_done_again_and_nothing_else(campaigns: Path, cluster: list[str], tmp_path: Path) -> None:
    folder = tmp_path / "two"
    for k in range(2):
        shutil.copytree(campaigns.parent / f"d{k:05d}", folder / f"d{k}")
    arguments: list[str | Path] = [folder, "--family", "fv", "--out", tmp_path / "t.parquet", *cluster]
    run(*arguments)
    first = rows(tmp_path / "t.parquet")
    shutil.rmtree(folder / "d1")
    measure(damper(1.5), folder / "d1", seed=5)
    assert "1 of them done before" in run(*arguments)
    second = rows(tmp_path / "t.parquet")
    assert second[0] == first[0]
    assert second[1]["force_at_+0.262_m_s"] > 1.3 * first[1]["force_at_+0.262_m_s"]


def test_a_campaign_that_ends_its_worker_is_a_row(campaigns: Path, tmp_path: Path) -> None:
    """A campaign at which the worker's process always dies becomes a failed row, although no exception reports it."""
    script = tmp_path / "dies.py"
    script.write_text(
        "import os, dashpot\n"
        "from dashpot.fleet import Plan, Place, find_jobs, run\n"
        "import dashpot.fleet.schedule as module\n"
        "def dying(jobs, plan):\n"
        "    if any(job.campaign.endswith('d00003') for job, _ in jobs):\n"
        "        os._exit(11)\n"
        "    from dashpot.fleet.examine import examine_all\n"
        "    return examine_all(jobs, plan)\n"
        "if __name__ == '__main__':\n"
        "    module.examine_all = dying\n"
        f"    jobs = find_jobs([{str(campaigns)!r}])[:6]\n"
        f"    run(jobs, {str(tmp_path / 'dies.parquet')!r}, Plan(family='fv'), Place(workers=1), chunk=3)\n"
    )
    ran = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, check=False, timeout=300)
    assert ran.returncode == 0, ran.stderr
    table = rows(tmp_path / "dies.parquet")
    assert [r["status"] for r in table] == ["ok"] * 3 + ["failed"] + ["ok"] * 2
    assert "ended each time" in table[3]["reason"]


def test_rows_that_are_lost_with_their_worker_are_done_again() -> None:
    """Rows are computed again if their worker ends after the work, before the rows are fetched."""

    class Lost:
        """A finished task whose worker is gone when its rows are fetched."""

        def __init__(self, status: str) -> None:
            self.status = "finished"
            self.then = status

        def exception(self) -> None:
            return None

        def result(self) -> list[Any]:
            self.status = self.then
            raise distributed.KilledWorker("examine_all-1", "tcp://127.0.0.1:1", 1)

    assert _rows(Lost("error")) is None
    with pytest.raises(dashpot.DashpotError, match="the cluster went away"):
        _rows(Lost("cancelled"))


def test_a_passing_fault_is_tried_again(campaigns: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    job = find_jobs([campaigns])[0]
    faults = [OSError("the file server went away")] * 2
    read = dashpot.Campaign.read

    def unsteady(path: str) -> dashpot.Campaign:
        if faults:
            raise faults.pop()
        return read(path)

    monkeypatch.setattr("dashpot.fleet.examine.Campaign.read", unsteady)
    assert examine(job, "k", Plan(family="fv", retries=2))["status"] == "ok"
    faults = [OSError("the file server went away")] * 3
    row = examine(job, "k", Plan(family="fv", retries=2))
    assert row["status"] == "failed" and "file server" in row["reason"] and "3 times" in row["reason"]


def test_a_second_run_on_the_same_table_is_refused(campaigns: Path, tmp_path: Path) -> None:
    arguments: list[str | Path] = [campaigns, "--elements", ELEMENTS, "--workers", "1", "--out", tmp_path / "t.parquet"]
    first = start(*arguments)
    while not (tmp_path / "t.parquet.parts" / "lock").exists() and first.poll() is None:
        time.sleep(0.01)
    time.sleep(0.2)
    second = start(*arguments)
    _, err = second.communicate(timeout=60)
    kill(first)
    assert second.returncode == 2 and "another run is writing" in err


def test_what_cannot_be_is_said(campaigns: Path, tmp_path: Path) -> None:
    (tmp_path / "table.csv").write_text("a,b\n1,2\n")
    (tmp_path / "list.csv").write_text("campaign,date\nx,yesterday\n")
    limits = tmp_path / "limits.csv"
    refused: list[tuple[list[str | Path], str]] = [
        ([tmp_path / "nowhere", "--out", tmp_path / "o.parquet"], "no such file"),
        ([campaigns, "--out", tmp_path / "table.csv"], "no Parquet file"),
        ([campaigns, "--out", tmp_path / "no" / "o.parquet"], "make it first"),
        ([tmp_path / "list.csv", "--out", tmp_path / "o.parquet"], "line 2: 'yesterday' is no date"),
    ]
    for arguments, words in refused:
        process = start(*arguments)
        _, err = process.communicate(timeout=60)
        assert process.returncode == 2 and words in err and "Traceback" not in err, err
    for text, words in [
        ("quantity,low,hgih\n", 'line 1: there is no column "hgih"'),
        ("quantity,velocity_m_s,low,high\ncolour,,1,2\n", 'line 2: "colour" is nothing that can be limited'),
        ("quantity,velocity_m_s,low,high\n\nforce,,1,2\n", "line 3"),
        ("quantity,velocity_m_s,low,high\nfriction,,x,2\n", "no number"),
        ("quantity,velocity_m_s,low,high\nfriction,,3,2\n", "is above high"),
        ("quantity,velocity_m_s,low,high\nfriction,,,\n", "neither low nor high"),
        ("quantity,velocity_m_s,low,high\n", "no limit below it"),
        ("quantity,velocity_m_s,low,high\nforce,nan,1,2\n", "no number"),
        ("quantity,velocity_m_s,low,high\nforce,-0.5,800,900\n", "positive at a negative velocity"),
        ("quantity,nominal,tolerance\nfriction,30,\n", "belong together"),
    ]:
        limits.write_text(text)
        with pytest.raises(dashpot.DashpotError, match=words):
            read_limits(limits)


def test_limits_are_judged_by_what_the_rig_measured(tmp_path: Path) -> None:
    measure(damper(), tmp_path / "c", seed=1, tests=[*TESTS, (0.025, 0.4)])
    measure(damper(1.2), tmp_path / "short", seed=2, tests=[(0.005, 0.26)])
    (tmp_path / "short" / "a5_v260.csv").rename(tmp_path / "c" / "short.csv")
    campaign = dashpot.Campaign.read(tmp_path / "c")
    validation = damper().validate(campaign)
    measured = Figures.measure(campaign._native)
    assert Figures.parse(measured.text).text == measured.text

    def value(quantity: str, velocity: float | None = None, amplitude: float | None = None) -> float | None:
        (found,) = json.loads(measured.judge(rows_of([Limit(quantity, velocity, 0, 1e6, amplitude)])))["limits"]
        return None if found["measured"] is None else float(found["measured"]["value_n"])

    # The expected force at 0.26 m/s is that of the FV curve at 0.25 m/s, plus friction, minus gas force. The largest amplitude supplies it.
    assert value("force", 0.26) == pytest.approx(1150 + 30 - 140, rel=0.03)
    assert value("force", 0.26, 0.005) == pytest.approx(1.2 * 1150 + 30 - 140, rel=0.03)
    # The force is interpolated between two tests of one amplitude if their velocities differ by a factor of at most 2. Between tests farther
    # apart, and above the fastest test, there is no force.
    assert value("force", 0.45) == pytest.approx(1150 + 0.8 * 350 + 30 - 140, rel=0.03)
    assert value("force", 0.1) is None and value("force", 1.5) is None
    # The friction is evaluated above half of the peak velocity of 3 mm/s. At the mean velocity of 2.4 mm/s, the valves add a small force.
    assert value("friction") == pytest.approx(30 + 0.0024 * 0.5 * (600 + 330) / 0.1, abs=2)
    assert value("gas_force") == pytest.approx(140, abs=5)
    own = next(t for t in validation.tests if t.name == "a25_v260")
    assert own.hysteresis is not None and value("hysteresis", 0.26) == own.hysteresis.mean_gap_n.measured
    assert value("hysteresis", 0.24) is None
    assert value("hysteresis") == max(t.hysteresis.mean_gap_n.measured for t in validation.tests if t.hysteresis is not None)
    (tmp_path / "c" / "a25_v3.csv").unlink()
    fast = dashpot.Campaign.read(tmp_path / "c")
    found = damper().validate(fast, limits=[Limit("friction", None, 0, 1e6), Limit("force", 1.5, 0, 1e6)]).limits
    assert found is not None and not found.passed
    missed = found.missed
    assert ["not tested" in told for told in missed] == [True, True] and "6 mm/s" in missed[0]
    row = examine(find_jobs([tmp_path / "c"])[0], "k", Plan(family="fv", limits=(Limit("friction", None, 0, 1e6),)))
    assert row["judgement"] == "incomplete" and "not tested" in row["missed"][0]


def test_the_table_of_limits_in_the_book_is_read(tmp_path: Path) -> None:
    book = (Path(__file__).parents[3] / "docs" / "book" / "src" / "identification.md").read_text(encoding="utf-8")
    lines = book[book.index("    quantity,velocity_m_s,low,high,nominal") :].split("\n\n")[0].splitlines()
    (tmp_path / "book.csv").write_text("\n".join(line.strip() for line in lines) + "\n")
    limits = read_limits(tmp_path / "book.csv")
    assert [limit.quantity for limit in limits] == ["force", "force", "gas_force", "friction", "hysteresis"]
    assert (limits[0].low, limits[0].high, limits[0].label) == (1700 - 136, 1700 + 136, "R3")
    (tmp_path / "german.csv").write_bytes("# vorn\nquantity;velocity_m_s;low;high;unit;name\nforce;0,524;0,9;1;kN;Dämpfer\n".encode("cp1252"))
    assert read_limits(tmp_path / "german.csv") == (Limit("force", 0.524, 900, 1000, None, "Dämpfer"),)


def test_lists_and_limits_tell_their_mistakes_alike(tmp_path: Path) -> None:
    for first, row, words in [
        ("{},oops", "", "line 2: there is no column .oops. in a "),
        ("{0},{0}", "", "line 2: the column .{}. stands there twice"),
        ("{}", "a,b", "line 3: has 2 fields where the header has 1"),
    ]:
        for name, column, read in [("l.csv", "quantity", read_limits), ("f.csv", "campaign", find_jobs)]:
            (tmp_path / name).write_text(f"# ours\n{first.format(column)}\n{row}\n")
            with pytest.raises(dashpot.DashpotError, match=words.format(column)):
                read(tmp_path / name)
    # Headings in capitals and with spaces are accepted in tables of limits and in lists of campaigns.
    (tmp_path / "l.csv").write_text("Quantity,Velocity m-s,LOW,high\nGas Force,,1,2\n")
    assert read_limits(tmp_path / "l.csv") == (Limit("gas_force", None, 1, 2),)
    (tmp_path / "f.csv").write_text(" Campaign , SERIAL\nx,S1\n")
    assert [job.serial for job in find_jobs(tmp_path / "f.csv")] == ["S1"]


def test_a_limit_that_nothing_can_keep_is_refused_before_the_work(tmp_path: Path) -> None:
    measure(damper(), tmp_path / "c", seed=1, tests=TESTS[:1])
    campaign = dashpot.Campaign.read(tmp_path / "c")
    for limit, words in [
        (Limit("friktion", None, 0, 1), '"friktion" is nothing that can be limited'),
        (Limit("force", None, 0, 1), "needs the speed"),
        (Limit("friction", None, 2, 1), "is above high"),
        (Limit("friction", None, -math.inf, math.inf), "neither low nor high"),
        (Limit("friction", None, math.nan, 1), "low is NaN"),
        (Limit("hysteresis", 0.5, 0, 1, -0.05), "is no amplitude of a damper"),
    ]:
        with pytest.raises(dashpot.DashpotError, match=f"Plan.limits: limit 2 of those given: .*{words}"):
            checked(Plan(limits=(Limit("friction", None, 0, 9), limit)))
        with pytest.raises(dashpot.ValidationError, match=words):
            damper().validate(campaign, limits=[limit])


class TestStatistics:
    """Tests of statistics with known results."""

    NOISE = np.random.default_rng(3).normal(0, 1, 400)

    def test_outliers(self) -> None:
        values = self.NOISE.copy()
        values[17] = 9
        off = np.abs(far_off(values))
        assert off.argmax() == 17 and (off > 3.5).sum() <= 2
        assert (far_off(np.full(9, 5.0)) == 0).all()
        # Values that come from a prior agree to many digits. A different value must be an outlier, but not at a distance of 1e10.
        held = np.array([2.5e6 * (1 + 1e-12 * k) for k in range(20)])
        held[3] = 2.6e6
        assert far_off(held)[3] == pytest.approx(40, rel=1e-6) and np.abs(np.delete(far_off(held), 3)).max() < 1e-6
        # A difference within the uncertainty of the values is no outlier.
        assert np.abs(far_off(np.array([1.0] * 5 + [1.2]), least=0.1)).max() < 3.5
        # More than half of the values are equal. A very different value must still be an outlier, and a slightly different value must not.
        few = far_off(np.array([0.0] * 13 + [12.0, 50000.0, np.nan]))
        assert few[14] > 3.5 > abs(few[13]) and few[0] == 0 and np.isnan(few[15])

    def test_drift(self) -> None:
        at = np.arange(400.0)
        slope = drift(at, 0.02 * at + self.NOISE)
        assert slope is not None and slope.stands_out and abs(slope.slope - 0.02) < 3 * slope.deviation
        flat = drift(at, self.NOISE)
        assert flat is not None and not flat.stands_out
        assert drift(np.zeros(400), self.NOISE) is None

    def test_control_chart(self) -> None:
        values = self.NOISE[:100].copy()
        values[50] += 8
        chart = control(values)
        assert chart is not None and 50 in chart.beyond and len(chart.beyond) <= 3
        stepped = np.concatenate([self.NOISE[:40], self.NOISE[:40] + 2.5])
        shifted = control(stepped)
        assert shifted is not None and any(p >= 40 for p in shifted.shifted)
        assert control(np.array([1.0, 2.0])) is None

    def test_batches(self) -> None:
        found = batches(["a"] * 200 + ["b"] * 200, np.concatenate([self.NOISE[:200], self.NOISE[200:] + 1]))
        assert [b.name for b in found] == ["a", "b"]
        assert found[0].high < found[1].low


#: Largest allowed increase of the peak memory of the run or of a worker, MiB, for a fleet that is five times larger.
GROWTH = 30


@pytest.mark.skipif(os.environ.get("DASHPOT_LONG") is None, reason="1200 campaigns: DASHPOT_LONG is not set")
def test_memory_does_not_grow_with_the_fleet(tmp_path: Path) -> None:
    sys.path.insert(0, str(Path(__file__).parents[1] / "benchmarks"))
    from fleet import measured  # type: ignore[import-not-found]

    fleet(tmp_path, 1000)
    lines = (tmp_path / "fleet.csv").read_text().splitlines()
    peaks = []
    for count in (200, 1000):
        listed = tmp_path / f"first{count}.csv"
        listed.write_text("\n".join(lines[: count + 1]) + "\n")
        peaks.append(measured(listed, tmp_path / f"{count}.parquet", "fv", 1)[1][:2])
        print(f"{count} campaigns: run and worker at most {peaks[-1]} MiB")
    assert all(large < small + GROWTH for small, large in zip(*peaks, strict=True)), peaks


def test_a_report_is_the_same_twice(campaigns: Path, cluster: list[str], tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    run(campaigns, "--family", "fv", "--out", tmp_path / "r.parquet", "--quiet", *cluster)
    write_report(tmp_path / "r.parquet", tmp_path / "a.html")
    write_report(tmp_path / "r.parquet", tmp_path / "b.html")
    assert (tmp_path / "a.html").read_bytes() == (tmp_path / "b.html").read_bytes()
    (tmp_path / "c.html").write_text("my notes")
    with pytest.raises(dashpot.OutputError):
        write_report(tmp_path / "r.parquet", tmp_path / "c.html")


def test_a_cluster_on_slurm_leaves_ctrl_c_as_it_was() -> None:
    if importlib.util.find_spec("dask_jobqueue") is None:
        pytest.skip("dask-jobqueue is not installed")
    code = (
        "import signal\nfrom dashpot.fleet.cluster import slurm_cluster\nbefore = signal.getsignal(signal.SIGINT)\n"
        "assert slurm_cluster().__name__ == 'SLURMCluster' and signal.getsignal(signal.SIGINT) is before\n"
    )
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr


def test_workers_that_stay_up_see_a_reference_that_was_put_right(tmp_path: Path) -> None:
    measure(damper(), tmp_path / "d", seed=1)
    measure(damper(friction=90), tmp_path / "good", seed=2)
    job = find_jobs([tmp_path / "d"])[0]

    def reference_friction() -> float:
        good = dashpot.fit(dashpot.Campaign.read(tmp_path / "good"), elements=ELEMENTS.split(","))
        plan = Plan(
            elements=tuple(ELEMENTS.split(",")), reference=str(tmp_path / "good"), reference_model=good.text, candidates=("free_play",)
        )
        row = examine(job, "k", plan)
        assert row["status"] == "ok", row["reason"]
        told: list[dict[str, Any]] = row["changes"]
        return next((c["reference"] for c in told if c["name"] == "coulomb_force"), 0.0)

    assert reference_friction() == pytest.approx(90, abs=10)
    shutil.rmtree(tmp_path / "good")
    measure(damper(), tmp_path / "good", seed=3)
    assert reference_friction() < 60
    assert Plan(reference=str(tmp_path / "good")).said() != Plan(reference=str(tmp_path / "d")).said()


class TestJobs:
    """Tests of the search for campaigns, and of the detection of changed campaigns."""

    @pytest.fixture
    def two(self, tmp_path: Path) -> Path:
        for k in range(2):
            measure(damper(), tmp_path / "fleet" / f"d{k}", seed=k, tests=TESTS[:2])
        return tmp_path / "fleet"

    def test_a_change_of_any_file_that_is_read_is_seen(self, two: Path) -> None:
        deep = two / "d0"
        (deep / "slow").mkdir()
        (deep / "a25_v3.csv").rename(deep / "slow" / "a25_v3.csv")
        job, single = find_jobs([deep])[0], find_jobs([two / "d1" / "a25_v3.csv"])[0]
        keys = [job.key("")]
        (deep / "campaign.toml").write_text('format = "dashpot campaign profile 1"\nsubfolders = true\n')
        keys.append(job.key(""))
        (deep / "slow" / "a25_v3.csv").write_text("changed\n")
        keys.append(job.key(""))
        assert len(set(keys)) == 3
        (deep / "notes.md").write_text("of no concern")
        assert job.key("") == keys[-1]
        before = single.key("")
        (two / "d1" / "campaign.toml").write_text('format = "dashpot campaign profile 1"\ngain = 2.0\n')
        assert single.key("") != before

    def test_records_in_subfolders_are_read_where_the_plan_says_so(self, two: Path) -> None:
        """The plan's option acts like the entry in campaign.toml, and a change of a file in a subfolder is detected."""
        deep = two / "d0"
        (deep / "slow").mkdir()
        (deep / "a25_v3.csv").rename(deep / "slow" / "a25_v3.csv")
        job, plan = find_jobs([deep])[0], Plan(family="fv", mapping={"subfolders": True})
        assert examine(job, "k", Plan(family="fv"))["tests"] == 1
        row = examine(job, "k", checked(plan))
        assert (row["status"], row["tests"]) == ("ok", 2)
        before = job.key(plan.said(), plan.subfolders)
        (deep / "slow" / "a25_v3.csv").write_text("changed\n")
        assert job.key(plan.said(), plan.subfolders) != before
        reference = replace(plan, reference=str(deep))
        before = reference.said()
        (deep / "slow" / "a25_v3.csv").write_text("changed again\n")
        assert reference.said() != before

    def test_a_folder_whose_records_lie_in_subfolders_is_one_damper(self, two: Path) -> None:
        assert [Path(j.campaign).name for j in find_jobs(two)] == ["d0", "d1"]
        (two / "campaign.toml").write_text('format = "dashpot campaign profile 1"\nsubfolders = true\n')
        assert [j.campaign for j in find_jobs([two])] == [str(two)]

    @pytest.mark.parametrize("ending", ["tra", "lvm", "mf4", "mdf", "tdms", "xlsm"])
    def test_every_format_of_the_reader_makes_a_campaign(self, tmp_path: Path, ending: str) -> None:
        (tmp_path / f"x.{ending}").write_text("")
        (tmp_path / "plots").mkdir()
        assert [j.campaign for j in find_jobs([tmp_path])] == [str(tmp_path)]

    def test_the_endings_are_those_of_the_reader(self) -> None:
        source = (Path(__file__).parents[2] / "records" / "src" / "file_extensions.rs").read_text(encoding="utf-8")
        listed = source.split("pub const EXTENSIONS")[1].split("];")[0].split("=")[1]
        assert {f".{e}" for e in listed.split('"')[1::2]} == RECORDS

    def test_lists_and_notes_beside_campaigns_do_not_make_one_of_them(self, two: Path) -> None:
        (two / "fleet.csv").write_text("campaign,serial\nd0,S0\n")
        (two / "notes.txt").write_text("measured on 2026-03-02\n12 34\n")
        assert [Path(j.campaign).name for j in find_jobs([two])] == ["d0", "d1"]
        # A folder with records of its own is a campaign, even if its subfolders also contain records.
        shutil.copy(two / "d0" / "a25_v3.csv", two)
        assert [j.campaign for j in find_jobs([two])] == [str(two)]

    def test_lists_are_read_as_spreadsheets_write_them(self, two: Path) -> None:
        plain = "campaign,serial\nd0,Dämpfer\n"
        for text, encoding in (
            (plain, "utf-8"),
            (plain, "utf-8-sig"),
            (plain, "utf-16"),
            (plain, "cp1252"),
            (plain.replace(",", ";"), "cp1252"),
            (plain.replace(",", "\t"), "utf-16"),
            ('"campaign","serial"\r\n"d0","Dämpfer"\r\n', "utf-8"),
        ):
            (two / "list.csv").write_bytes(text.encode(encoding))
            (job,) = find_jobs([two / "list.csv"])
            assert (Path(job.campaign).name, job.serial) == ("d0", "Dämpfer"), (text, encoding)

    def test_a_campaign_that_is_listed_twice_is_told(self, two: Path) -> None:
        (two / "list.csv").write_text("campaign,serial\nd0,S0\nd1,S1\n./d0,S2\n")
        with pytest.raises(dashpot.RecordError, match=r"list.csv, line 4: the campaign .*d0 is listed already \(.*line 2\)"):
            find_jobs([two / "list.csv"])
        (two / "list.csv").write_text("campaign,serial\nd0,S0\n")
        (two / "other.csv").write_text("campaign,serial\nd0,S9\n")
        with pytest.raises(dashpot.RecordError, match="listed already"):
            find_jobs([two / "list.csv", two / "other.csv"])
        # A folder has no serial number, so it cannot contradict a list.
        both: tuple[list[str | Path], ...] = ([two / "list.csv", two / "d0", f"{two}/d0/"], [two / "d0", two / "list.csv"])
        for paths in both:
            assert [j.serial for j in find_jobs(paths)] == ["S0"]


class TestRuns:
    """Tests of the arguments of a run, and of the results that it keeps."""

    @pytest.fixture(scope="class")
    def cheap(self, cluster: list[str], tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Place]:
        """Makes campaigns for quick fits of a plain FV curve. Returns their folder and the place of the workers."""
        folder = tmp_path_factory.mktemp("cheap")
        for k in range(3):
            measure(damper(1 + 0.1 * k), folder / f"d{k}", seed=k)
        return folder, Place(address=cluster[1])

    def test_a_table_of_pandas_makes_jobs(self, cheap: tuple[Path, Place], tmp_path: Path) -> None:
        folder, place = cheap
        days = datetime.date(2026, 3, 1), datetime.datetime(2026, 3, 1, 10, 0)
        jobs = [
            Job(folder / "d0", np.int64(17), None, days[0]),  # type: ignore[arg-type]
            Job(str(folder / "d1"), 18, float("nan"), days[1]),  # type: ignore[arg-type]
            Job(folder / "d0", "again"),  # type: ignore[arg-type]
        ]
        done = run_jobs(jobs, tmp_path / "o.parquet", Plan(family="fv"), place)
        table = rows(tmp_path / "o.parquet")
        assert (done.campaigns, done.failed) == (3, 0)
        assert [(r["serial"], r["batch"], r["date"]) for r in table] == [
            ("17", "", "2026-03-01T00:00:00"), ("18", "", "2026-03-01T10:00:00"), ("again", "", ""),
        ]  # fmt: skip
        assert table[0]["model"] == table[2]["model"] != table[1]["model"]

    def test_what_cannot_be_is_said_before_any_work(self, cheap: tuple[Path, Place], tmp_path: Path) -> None:
        folder, _ = cheap
        good = Job(str(folder / "d0"))
        nowhere = Place(address="tcp://127.0.0.1:1")
        for jobs, plan, words in [
            ([Job(3)], Plan(), "Job.campaign is a path"),  # type: ignore[arg-type]
            ([Job("d0", 1.5)], Plan(), "Job.serial of d0 is 1.5"),  # type: ignore[arg-type]
            ([Job("d0", date="01.03.2026")], Plan(), "Job.date of d0: '01.03.2026' is no date"),
            (["d0"], Plan(), "jobs are dashpot.fleet.Job, not str"),
            ([good], Plan(diagnose="fail"), "Plan.diagnose is 'fail'; it is all, failed, none"),
            ([good], Plan(limits="lim.csv"), "Plan.limits is 'lim.csv'; give what dashpot.fleet.read_limits"),  # type: ignore[arg-type]
            ([good], Plan(mapping={"unit": {"force": "N"}}), "has no 'unit'; did you mean 'units'?"),
            ([good], Plan(mapping={"units": {"force": "bananas"}}), "'bananas' is no unit known"),
            ([good], Plan(mapping={"gain": "x"}), "Plan.mapping"),
            ([good], Plan(family="thesi"), "there is no family"),
            ([good], Plan(elements=("foo",)), 'there is no element called "foo"'),
            ([good], Plan(candidates=("cavitationn",)), 'there is no effect called "cavitationn"'),
            ([good], Plan(reference="nowhere"), "the reference nowhere"),
            ([good], Plan(retries=-1), "Plan.retries"),
        ]:
            with pytest.raises(dashpot.DashpotError, match=re.escape(words)):
                run_jobs(jobs, tmp_path / "o.parquet", plan, nowhere)  # type: ignore[arg-type]
        with pytest.raises(dashpot.DashpotError, match="chunk is 0"):
            run_jobs([good], tmp_path / "o.parquet", chunk=0)
        assert not list(tmp_path.iterdir())
        checked(Plan(elements=("coulomb_friction",), candidates=("free_play",)))

    def test_other_limits_serials_and_dates_need_no_fit(self, cheap: tuple[Path, Place], tmp_path: Path) -> None:
        folder, place = cheap
        out = tmp_path / "o.parquet"
        jobs = [Job(str(folder / f"d{k}"), f"S{k}") for k in range(3)]

        def judgements(high: float, batch: str) -> tuple[int, list[Any]]:
            plan = Plan(family="fv", limits=(Limit("friction", None, 0, high), Limit("force", 0.52, 0, 1e4)))
            done = run_jobs([replace(job, batch=batch) for job in jobs], out, plan, place)
            assert [r["batch"] for r in rows(out)] == [batch] * 3
            return done.done_before, [r["judgement"] for r in rows(out)]

        assert judgements(1000, "B1") == (0, ["passed"] * 3)
        before = out.read_bytes()
        assert judgements(1, "B2") == (3, ["failed"] * 3)
        assert judgements(1000, "B1") == (3, ["passed"] * 3)
        assert out.read_bytes() == before and "measured" not in rows(out)[0]

    def test_campaigns_that_were_read_in_two_directions_are_told(self, cheap: tuple[Path, Place], tmp_path: Path) -> None:
        folder, place = cheap
        shutil.copytree(folder, tmp_path / "fleet")
        jobs, told = find_jobs(tmp_path / "fleet"), list[str]()
        run_jobs(jobs, tmp_path / "a.parquet", Plan(family="fv"), place, tell=told.append)
        assert [r["positive"] for r in rows(tmp_path / "a.parquet")] == ["rebound"] * 3 and not any("positive" in t for t in told)
        turn(tmp_path / "fleet" / "d1")
        run_jobs(jobs, tmp_path / "a.parquet", Plan(family="fv"), place, tell=told.append)
        assert [r["positive"] for r in rows(tmp_path / "a.parquet")] == ["rebound", "compression", "rebound"]
        words = "read 1 as counting compression positive and 2 as counting rebound positive"
        assert words in told[-1]
        pytest.importorskip("matplotlib")
        write_report(tmp_path / "a.parquet", tmp_path / "a.html")
        assert words in (tmp_path / "a.html").read_text()
        # If the plan states the direction, none is determined from the records, so there is no message.
        run_jobs(jobs, tmp_path / "b.parquet", Plan(family="fv", mapping={"positive": "rebound"}), place, tell=told.append)
        assert "read 1 as" not in told[-1]

    def test_a_damaged_part_is_set_aside_and_done_anew(self, cheap: tuple[Path, Place], tmp_path: Path) -> None:
        folder, place = cheap
        jobs = find_jobs(folder)
        out = tmp_path / "o.parquet"
        run_jobs(jobs, out, Plan(family="fv"), place, chunk=1)
        whole = out.read_bytes()
        part = max((tmp_path / "o.parquet.parts").glob("part-*"))
        part.write_bytes(part.read_bytes()[:100])
        told: list[str] = []
        assert run_jobs(jobs, out, Plan(family="fv"), place, tell=told.append).done_before == 2
        assert "is damaged and was set aside" in told[0] and out.read_bytes() == whole
        out.write_bytes(b"")
        assert run_jobs(jobs, out, Plan(family="fv"), place, tell=told.append).done_before == 3

    def test_again_redoes_what_failed_last(self, tmp_path: Path) -> None:
        store = Store(tmp_path / "o.parquet")
        common = {"campaign": "c", "serial": "", "batch": "", "date": ""}
        store.add([{**common, "key": "a", "status": "failed"}, {**common, "key": "b", "status": "failed"}])
        store.add([{**common, "key": "a", "status": "ok"}])
        assert store.failed() == ["b"]
        store.close()
        store = Store(tmp_path / "o.parquet")
        assert store.failed() == ["b"]
        store.close()

    def test_a_worker_elsewhere_finds_the_campaigns_and_what_it_does_not_see_is_tried_again(
        self, cheap: tuple[Path, Place], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        folder, place = cheap
        monkeypatch.chdir(folder)
        run_jobs([Job("d0")], tmp_path / "o.parquet", Plan(family="fv"), place)
        (row,) = rows(tmp_path / "o.parquet")
        assert (row["status"], row["campaign"]) == ("ok", "d0")
        (lost,) = examine_all([(Job(str(tmp_path / "nowhere")), "k")], Plan())
        assert lost["status"] == "failed" and "no such file" in lost["reason"]
        assert _kept(lost)["key"] == "k"
        (tmp_path / "nowhere").mkdir()
        store = Store(tmp_path / "p.parquet")
        store.add([_kept(lost)])
        assert "k" not in store.done and store.table(["k"]) == 1
        store.close()

    def test_a_cluster_without_workers_and_one_that_is_not_there_are_told(self, cheap: tuple[Path, Place], tmp_path: Path) -> None:
        class Late:
            """A client whose second wait finds a worker."""

            waits = 0

            def nthreads(self) -> dict[str, int]:
                return {"w": 1} if self.waits > 1 else {}

            def wait_for_workers(self, n: int, timeout: float) -> None:
                self.waits += 1
                if self.waits == 1:
                    raise distributed.TimeoutError

        told: list[str] = []
        wait_for_workers(Late(), told.append)
        assert len(told) == 1 and "no worker yet" in told[0]
        for address in ("foo", "nowhere://x:1"):
            process = start(cheap[0], "--family", "fv", "--out", tmp_path / "o.parquet", "--scheduler", address)
            _, err = process.communicate(timeout=30)
            assert process.returncode == 2 and f"no Dask scheduler at {address}" in err and "Traceback" not in err, err


class TestReport:
    """Tests of the report: files that it may replace, and unusual names in its content."""

    @pytest.fixture
    def table(self, tmp_path: Path) -> Path:
        """Makes a small table with names that matplotlib would format, and with digits that only Python accepts as digits."""
        pytest.importorskip("matplotlib")
        store = Store(tmp_path / "t.parquet")
        number = {"name": "spring_linear", "index": None, "unit": "N/m", "standing": "identified"}
        values = [0.0] * 13 + [12.0, 50000.0]
        store.add(
            [
                {
                    "key": f"k{k}", "campaign": f"c{k}", "serial": "12²" if k == 2 else f"D{k}", "batch": "$x^$" if k % 2 else "$", "date": "",
                    "status": "ok", "parameters": [{**number, "value": v, "low": v, "high": v}],
                }
                for k, v in enumerate(values)
            ]
        )  # fmt: skip
        store.table([f"k{k}" for k in range(len(values))])
        store.close()
        return tmp_path / "t.parquet"

    def test_any_serial_and_batch_may_stand_in_it(self, table: Path) -> None:
        write_report(table, table.with_name("r.html"))
        text = table.with_name("r.html").read_text(encoding="utf-8")
        outliers = text[text.index("<h2>Outliers") : text.index("<h2>Every")]
        assert "D14" in outliers and "D13" not in outliers
        write_report(table, table.with_name("r.html"))

    @pytest.mark.parametrize("count", [*range(3, 61)])
    def test_labels_of_ticks_neither_overlap_nor_repeat(self, count: int) -> None:
        from matplotlib.backends.backend_agg import FigureCanvasAgg

        noise = np.random.default_rng(count)
        dates = np.asarray(20000.0 + noise.integers(0, 400, count), dtype=np.float64)
        names = [f"supplier north, week {k % 17:02d} of 2026" if count % 2 else f"B{k // 2:03d}" for k in range(count)]
        scale = [3e-6, 1.0, 2.067e6, -1500.0][count % 4]
        spread = [1e-7, 1e-2, 3.0][count % 3]
        values = scale * (1 + spread * noise.normal(size=count))
        if count % 5 == 0:
            values[1] = 1e4 * scale
        quantity = Quantity("series_stiffness", "N/mm", values)
        order = np.arange(count)
        figure = figure_of(quantity, dates, order, control(values), batches(names, values))
        canvas: Any = FigureCanvasAgg(figure)
        canvas.draw()
        renderer = canvas.get_renderer()
        area = figure.bbox
        for axes in figure.axes:
            title = axes.xaxis.label.get_window_extent(renderer)
            assert title.y0 >= area.y0 and title.x0 >= area.x0 and title.x1 <= area.x1, axes.get_xlabel()
            for way in (axes.xaxis, axes.yaxis):
                low, high = sorted(axes.get_xlim() if way is axes.xaxis else axes.get_ylim())
                shown = [t.label1 for t in way.get_major_ticks() if low <= t.get_loc() <= high and t.label1.get_text()]
                texts = [label.get_text() for label in shown]
                assert texts and len(set(texts)) == len(texts), texts
                assert not way.get_offset_text().get_text()
                boxes = [label.get_window_extent(renderer) for label in shown]
                for label, box in zip(shown, boxes, strict=True):
                    # Labels of slanted names end at the bottom of the picture, all others at its sides.
                    assert box.x0 >= area.x0 and box.x1 <= area.x1 and box.y0 >= area.y0, (label.get_text(), box)
                for (one, a), (other, b) in zip(list(zip(shown, boxes, strict=True)), list(zip(shown, boxes, strict=True))[1:], strict=False):
                    if one.get_rotation():
                        # Parallel lines of text do not overlap if their distance exceeds the height of a line.
                        size = one.get_fontsize() * figure.dpi / 72
                        assert (other.get_position()[0] - one.get_position()[0]) * axes.bbox.width / (high - low) >= np.sqrt(2) * size
                    else:
                        assert not a.overlaps(b), (texts, scale, spread)

    def test_a_fleet_is_a_table_of_dampers_with_their_verdicts_and_no_absurd_distance(self, tmp_path: Path) -> None:
        pytest.importorskip("matplotlib")
        store = Store(tmp_path / "t.parquet")
        number = {"name": "gas_force", "index": None, "unit": "N", "standing": "identified", "low": None, "high": None}
        judged = ["passed"] * 5 + ["failed"] * 2 + ["incomplete"] * 3
        missed = {"failed": ["R3: 812 N, allowed 900 to 1000 N"], "incomplete": ["R3: not tested"]}
        # The fit took all values but one from a prior, so that they agree to twelve digits.
        values = [140.0 * (1 + 1e-12 * k) for k in range(10)]
        values[4] = 90.0
        store.add(
            [
                {
                    "key": f"k{k}", "campaign": f"c{k}", "serial": f"D{k}", "batch": "", "date": "", "status": "ok", "judgement": judged[k],
                    "missed": missed.get(judged[k], []), "parameters": [{**number, "value": value, "low": value, "high": value}],
                }
                for k, value in enumerate(values)
            ]
        )  # fmt: skip
        store.table([f"k{k}" for k in range(10)])
        store.close()
        write_report(tmp_path / "t.parquet", tmp_path / "r.html")
        text = (tmp_path / "r.html").read_text(encoding="utf-8")
        assert "Limits: 5 PASS, 2 FAIL, 3 INCOMPLETE" in text
        rows = text[text.index("<h2>Dampers</h2>") :].split("</table>")[0].split("<tr>")[2:]
        verdicts = [re.findall("<td>(.*?)</td>", row)[4] for row in rows]
        assert [verdict.split(":")[0] for verdict in verdicts] == ["PASS"] * 5 + ["FAIL"] * 2 + ["INCOMPLETE"] * 3
        distances = [float(d) for d in re.findall(r"\(([+-][0-9.e+-]+)\)", text)]
        assert all(abs(d) <= 99 for d in distances) and "e+1" not in "".join(rows)
        assert "gas_force (beyond -99)" in rows[4] and "gas_force" not in rows[5]

    def test_a_page_of_somebody_else_is_kept(self, table: Path) -> None:
        notes = table.with_name("notes.html")
        notes.write_text("<html><title>My notes on dashpot results</title>three weeks of work</html>")
        before = sorted(table.parent.iterdir())
        for path in (notes, table.parent, table.parent / "none" / "r.html"):
            with pytest.raises(dashpot.OutputError, match="cannot write"):
                write_report(table, path)
        assert "three weeks" in notes.read_text() and sorted(table.parent.iterdir()) == before

    def test_where_the_report_goes_is_looked_at_before_the_work(self, campaigns: Path, tmp_path: Path) -> None:
        from dashpot.fleet.__main__ import main

        assert main([str(campaigns), "--out", str(tmp_path / "o.parquet"), "--report", str(tmp_path / "none" / "r.html")]) == 2
        assert not list(tmp_path.iterdir())


def test_the_command_ends_with_one_where_nothing_could_be_identified(cluster: list[str], tmp_path: Path) -> None:
    from dashpot.fleet.__main__ import main

    (tmp_path / "fleet" / "empty").mkdir(parents=True)
    assert main([str(tmp_path / "fleet"), "--out", str(tmp_path / "o.parquet"), "--quiet", *cluster]) == 1
