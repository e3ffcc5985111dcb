"""Running a campaign: the same rows however it is cut up, and nothing lost when workers die."""

from __future__ import annotations

import os
import signal
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from builders.missing import needs
from builders.plans import plan
from springback.campaign import workers
from springback.campaign.access import Campaign
from springback.campaign.cost_estimate import CostEstimate, cost_estimate
from springback.campaign.design.layout import lay_out
from springback.campaign.errors import CampaignError
from springback.campaign.flying import Chunk, ChunkRows, fly_chunk
from springback.campaign.running import CampaignProgress, run_campaign
from springback.campaign.store import source
from springback.campaign.workers import STRIKES, GivenUp, fly_locally
from springback.errors import InputError

ROWS = "FROM flights ORDER BY flight"


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Campaign:
    """All flights of the usual plan, in one chunk, by one worker."""
    folder = tmp_path_factory.mktemp("whole")
    return run_campaign(plan(), folder, workers=1, chunk=1000)


def test_rows_are_the_same_for_any_chunk_and_number_of_workers(
    whole: Campaign, tmp_path: Path
) -> None:
    assert (len(whole.parts), whole.done, whole.complete) == (1, 24, True)
    told: list[CampaignProgress] = []
    other = run_campaign(plan(), tmp_path, workers=3, chunk=5, progress=told.append)
    assert [(part.first, part.last) for part in other.parts] == [
        (0, 5), (5, 10), (10, 15), (15, 20), (20, 24)
    ]  # fmt: skip
    assert other.query(ROWS) == whole.query(ROWS)
    assert [now.done for now in told] == sorted(now.done for now in told)
    assert (told[-1].done, told[-1].parts, told[-1].flights) == (24, 5, 24)
    assert len({row[0] for row in whole.query("SELECT outcome FROM flights").rows}) > 1


def test_resuming_costs_nothing_for_what_is_done(
    whole: Campaign, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(workers, "_Worker", None)  # would not start
    again = run_campaign(plan(), whole.folder, resume=True)
    assert again.query(ROWS) == whole.query(ROWS)
    with pytest.raises(InputError, match="--resume"):
        run_campaign(plan(), whole.folder)


def test_every_flight_flown_alone_is_its_row(whole: Campaign) -> None:
    for number in (0, 7, 23):
        again = whole.refly(number)
        assert again.differences == ()
        assert len(again.flight.columns["t"]) > 100
    with pytest.raises(InputError, match="from 0 to 23"):
        whole.row(24)


def test_a_row_is_flown_and_viewed_from_python(whole: Campaign, tmp_path: Path) -> None:
    flight = whole.flight(7)
    assert flight.touch_speed == whole.row(7)["touch_speed"]
    page = whole.view(7, 8, export=tmp_path / "rows.html")
    assert page.text == flight.view(whole.flight(8), export=tmp_path / "same.html").text
    assert (tmp_path / "rows.html").is_file()


def test_a_row_that_is_not_its_flight_is_told(
    whole: Campaign, monkeypatch: pytest.MonkeyPatch
) -> None:
    row = whole.row(3)
    wrong = row | {"touch_speed": row["touch_speed"] * (1.0 + 3e-16), "contacts": None, "seed": 1}
    monkeypatch.setattr(Campaign, "row", lambda *_: wrong)
    told = whole.refly(3).differences
    assert [line.partition(":")[0] for line in told] == ["seed", "touch_speed", "contacts"]


def test_refused_flights_are_rows_that_say_why(tmp_path: Path) -> None:
    vary = [{"field": "start.position.0", "name": "x", "normal": {"mean": "0.6 m", "deviation": "0.2 m"}}]  # fmt: skip
    campaign = run_campaign(plan(samples=8, vary=vary), tmp_path, workers=1)
    counted = "SELECT count(*), count(success), count(touch_time), min(problem) FROM flights WHERE x > 0.8"
    [(count, judged, touched, problem)] = campaign.query(counted).rows
    assert count > 0
    assert (judged, touched) == (0, 0)
    assert problem.startswith("start.position: puts the cage of arm")
    [(refused,)] = campaign.query("SELECT min(flight) FROM flights WHERE outcome = 'refused'").rows
    with pytest.raises(InputError, match=r"could not be flown: start\.position"):
        campaign.refly(refused)


def test_trajectories_that_were_asked_for_are_kept(tmp_path: Path) -> None:
    kept = {"where": "speed > 1.5 AND robot = 'quad'", "most": 2}
    campaign = run_campaign(plan(keep=kept), tmp_path, workers=1)
    sql = "SELECT flight FROM flights WHERE speed > 1.5 AND robot = 'quad' ORDER BY flight LIMIT 2"
    numbers = [number for (number,) in campaign.query(sql).rows]
    names = {path.name for path in (tmp_path / "kept").iterdir()}
    assert names == {
        f"flight-{number:010d}{tail}" for number in numbers for tail in (".json", "-trajectory.parquet")
    }  # fmt: skip
    alone = campaign.refly(numbers[0]).flight
    path = tmp_path / f"kept/flight-{numbers[0]:010d}-trajectory.parquet"
    import duckdb

    kept_x = [x for (x,) in duckdb.execute("SELECT x FROM read_parquet(?)", [str(path)]).fetchall()]
    assert kept_x == alone.columns["x"].tolist()
    with pytest.raises(InputError, match=r"keep.where: .*speeed"):
        run_campaign(plan(keep={"where": "speeed > 1"}), tmp_path / "b", workers=1)
    assert not (tmp_path / "b").exists()


def test_success_is_what_the_plan_says(tmp_path: Path) -> None:
    campaign = run_campaign(plan(samples=4, success="touch_speed < 2"), tmp_path, workers=1)
    told = campaign.query("SELECT success = (touch_speed < 2)::TINYINT FROM flights").rows
    assert set(told) <= {(True,), (None,)}
    with pytest.raises(InputError, match=r"success: .*touch_sped"):
        run_campaign(plan(success="touch_sped < 2"), tmp_path / "b", workers=1)


# -- workers that die -----------------------------------------------------------------------------


def killed(text: str, chunk: Chunk, device: Any = "cpu") -> ChunkRows:
    """Fly, but be killed over flight 10: once, or always if the plan is called poison."""
    once = Path(os.environ["KILLED_ONCE"])
    if chunk[0] <= 10 < chunk[1] and ('"poison"' in text or not once.exists()):
        once.touch()
        os.kill(os.getpid(), signal.SIGKILL)
    if chunk[0] <= 20 < chunk[1] and '"broken"' in text:
        raise ZeroDivisionError("a mistake of ours")
    return fly_chunk(text, chunk)


def serve_killed(*given: Any) -> None:
    """A worker that flies so; in a module of its own process nothing is patched."""
    workers.fly_chunk = killed
    workers.serve(*given)


@pytest.fixture
def deadly(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("KILLED_ONCE", str(tmp_path / "once"))
    monkeypatch.setattr(workers, "SERVED", serve_killed)


@pytest.mark.usefixtures("deadly")
def test_a_killed_workers_chunk_is_flown_again(whole: Campaign, tmp_path: Path) -> None:
    said: list[str] = []
    campaign = run_campaign(plan(), tmp_path / "a", workers=2, chunk=4, remark=said.append)
    assert campaign.query(ROWS) == whole.query(ROWS)
    [line] = said
    assert "SIGKILL" in line
    assert "flights 8 to 11 are flown again" in line


@pytest.mark.usefixtures("deadly")
def test_a_chunk_that_kills_every_worker_is_given_up_and_the_rest_kept(
    whole: Campaign, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    said: list[str] = []
    with pytest.raises(
        CampaignError, match=r"4 flights were given up: 3 workers in a row .* 20 of 24"
    ):
        run_campaign(
            plan(name="poison"), tmp_path / "a", workers=2, chunk=4, remark=said.append
        )  # fmt: skip
    assert len(said) == STRIKES
    assert said[-1].startswith("flights 8 to 11 are given up")
    monkeypatch.undo()
    again = run_campaign(plan(name="poison"), tmp_path / "a", resume=True, workers=1)
    assert again.query(ROWS) == whole.query(ROWS)


@pytest.mark.usefixtures("deadly")
def test_a_mistake_in_the_program_is_noted_and_the_rest_kept(tmp_path: Path) -> None:
    (tmp_path / "once").touch()
    with pytest.raises(
        CampaignError, match=r"ZeroDivisionError: a mistake of ours; 20 of 24 are kept"
    ):
        run_campaign(plan(name="broken"), tmp_path / "a", workers=1, chunk=4)
    assert "Traceback" in (tmp_path / "a/problems.log").read_text()
    assert Campaign(tmp_path / "a").done == 20


def leave(*_: Any) -> None:
    os._exit(3)


def test_workers_that_cannot_start_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "SERVED", leave)
    with pytest.raises(CampaignError, match=r"could not start \(exit code 3\).*__main__"):
        list(fly_locally(plan().canonical(), [(0, 2)], 1, print))


def serve_another_source(*given: Any) -> None:
    """A worker that was started after the source had been edited."""
    workers.source = lambda: "another"
    workers.serve(*given)


def test_a_worker_of_another_source_stops_the_campaign(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "SERVED", serve_another_source)
    with pytest.raises(CampaignError, match="source was changed during the flights"):
        list(fly_locally(plan().canonical(), [(0, 2)], 1, print))


def test_leaving_early_leaves_no_process(whole: Campaign) -> None:
    coming = fly_locally(whole.design.plan.canonical(), [(0, 2), (2, 4), (4, 6)], 2, print)
    assert isinstance(next(coming), ChunkRows | GivenUp)
    coming.close()
    import multiprocessing

    assert not [p for p in multiprocessing.active_children() if p.name == "springback worker"]


# -- before it is flown ---------------------------------------------------------------------------


def test_an_outlook_counts_and_measures(tmp_path: Path) -> None:
    vary = [{"field": "model.arms", "values": ["hybrid", "always-free"]},
            {"field": "start.position.0", "values": ["0.6 m", "0.5 m"]}]  # fmt: skip
    told = cost_estimate(
        lay_out(plan(method="grid", samples=None, repeats=8, vary=vary)), workers=4
    )
    assert (told.flights, told.samples, told.repeats, told.tried) == (64, 4, 8, 64)
    assert told.robots == ("arq", "quad")
    flying, start = 64 / (min(4, told.cores) * told.rate), 0.0 if told.compiled else told.setup
    assert told.time == pytest.approx(start + flying)
    slower = max(1.0, (told.load + 4) / told.cores)
    assert told.loaded_time == pytest.approx(start + flying * slower)
    assert (told.cores, told.cached) == (os.cpu_count(), True)
    assert "kernels: " in told.sentence()
    assert 64 * 100 < told.bytes < 64 * 5000
    assert "64 flights: 4 samples of 2 dimensions, 8 repeats, arq and quad" in told.sentence()
    assert told.refused == 0


def test_an_estimate_says_what_compiling_and_other_work_cost() -> None:
    known = CostEstimate(
        1000, 500, 1, ("arq", "quad"), 2, 64, 0, "", 1, False, True, 3.0, 62.0, True, 10.0, 2, 2,
        4.0, 53.0, 153.0, 1000,
    )  # fmt: skip
    before = "kernels: compiled before, in 1 min 02 s of processor time; each worker loads them, in"
    assert f"{before} about 3 s" in known.sentence()
    assert "compiled before; each worker" in replace(known, recorded=False).sentence()
    assert "about 53 s with 2 workers on an idle machine of 2 cores" in known.sentence()
    assert "load: 4.0 other processes now; if they go on, about 2 min 33 s" in known.sentence()
    new = replace(known, compiled=True, setup=70.0, loaded_time=54.0, load=0.2)
    said = (
        "have just been compiled in 1 min 10 s (1 min 02 s of processor time); they are cached now"
    )
    assert said in new.sentence()
    assert "load: 0.2 other processes now, which hardly matters" in new.sentence()
    assert "each worker compiles them" in replace(new, cached=False).sentence()


def test_numbers_of_workers_and_chunks_are_checked(tmp_path: Path) -> None:
    for name in ("workers", "chunk"):
        with pytest.raises(InputError, match=f"--{name}: must be at least 1"):
            run_campaign(plan(), tmp_path / "a", **{name: 0})
    assert not (tmp_path / "a").exists()


@needs("POSIX")
def test_a_worker_that_is_starting_hears_no_ctrl_c(capfd: pytest.CaptureFixture[str]) -> None:
    """Was: a traceback of each, of what it was just importing."""
    worker = workers._Worker("", "cpu")
    try:
        for _ in range(100):
            os.kill(worker.process.pid or 0, signal.SIGINT)
            if worker.line.poll(0.05):
                break
        assert worker.line.recv() == source()
    finally:
        worker.end()
    assert capfd.readouterr().err == ""
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ())
