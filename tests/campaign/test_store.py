"""The folder of a campaign: nothing lost, nothing doubled, nothing half-written."""

from __future__ import annotations

import errno
import json
import math
import multiprocessing
import os
from pathlib import Path
from typing import Any

import pytest

from builders.campaign_folders import filled, rows
from builders.missing import needs
from builders.plans import plan
from springback.campaign import manifest, store
from springback.campaign.access import Campaign
from springback.campaign.design.layout import lay_out
from springback.campaign.errors import CampaignError
from springback.campaign.manifest import Part, missing
from springback.campaign.store import open_store
from springback.errors import InputError
from springback.results.sealed_json import with_digest


def names(folder: Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def test_rows_come_back_as_they_were_with_units(tmp_path: Path) -> None:
    design = filled(tmp_path / "a")
    campaign = Campaign(tmp_path / "a")
    told = campaign.query("FROM flights ORDER BY flight").as_dicts()
    want = rows(design, 0, 30)
    assert (campaign.done, campaign.complete, len(told)) == (30, False, 30)
    for k, row in enumerate(told):
        refused = want["outcome"][k] == "refused"
        assert row["success"] == (None if refused else want["outcome"][k] != "hit_ground")
        for name, values in want.items():
            value = values[k]
            assert row[name] == (None if isinstance(value, float) and math.isnan(value) else value)
    import duckdb

    sql = "SELECT decode(value) FROM parquet_kv_metadata(?) WHERE decode(key) = 'units'"
    path = str(tmp_path / "a/parts/part-0000000000.parquet")
    units = json.loads(duckdb.execute(sql, [path]).fetchall()[0][0])
    assert (units["speed"], units["pitch"], units["peak_acceleration"]) == ("m/s", "rad", "m/s^2")


def test_missing_stretches_are_cut_into_chunks() -> None:
    parts = [Part(0, 10, "a", 1, ""), Part(25, 30, "b", 1, "")]
    assert missing(parts, 40, 6) == [(10, 16), (16, 22), (22, 25), (30, 36), (36, 40)]
    assert missing([], 5, 10) == [(0, 5)]
    assert missing([Part(0, 5, "a", 1, "")], 5, 2) == []


@pytest.mark.parametrize("cut", [1, 20, 100])
def test_a_torn_last_line_of_the_ledger_does_not_count(tmp_path: Path, cut: int) -> None:
    design = filled(tmp_path)
    path = tmp_path / manifest.NAME
    path.write_bytes(path.read_bytes()[:-cut])
    assert [part.first for part in manifest.read(path)] == [0, 10]
    with open_store(tmp_path, design, resume=True) as again:
        [said] = again.checked_parts()
        assert "part-0000000020.parquet is not in the manifest" in said
        assert again.missing(100) == [(20, 60)]
        again.add(20, 40, rows(design, 20, 40))
    assert [(part.first, part.last) for part in manifest.read(path)] == [
        (0, 10),
        (10, 20),
        (20, 40),
    ]
    assert "aside/part-0000000020.parquet.0" in names(tmp_path)


@pytest.mark.parametrize("harm", ["cut", "flipped", "gone"])
def test_a_damaged_part_is_set_aside_and_flown_again(tmp_path: Path, harm: str) -> None:
    design = filled(tmp_path)
    path = tmp_path / "parts/part-0000000010.parquet"
    data = bytearray(path.read_bytes())
    if harm == "gone":
        path.unlink()
    else:
        data[200] ^= 1
        path.write_bytes(data[:-1] if harm == "cut" else data)
    with pytest.raises(InputError, match=r"part-0000000010.*--resume"):
        Campaign(tmp_path)
    with open_store(tmp_path, design, resume=True) as again:
        [said] = again.checked_parts()
        assert ("missing" if harm == "gone" else "damaged; it is now aside/part") in said
        assert again.missing(100) == [(10, 20), (30, 60)]
    assert Campaign(tmp_path).done == 20
    with open_store(tmp_path, design, resume=True) as again:
        assert again.checked_parts() == []
        again.add(10, 20, rows(design, 10, 20))
    campaign = Campaign(tmp_path)
    assert campaign.query("SELECT count(DISTINCT flight), count(*) FROM flights").rows == [(30, 30)]


def full_disk(*_: Any, **__: Any) -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


@pytest.mark.parametrize("where", ["rows", "rename", "ledger"])
def test_a_full_disk_stops_and_leaves_nothing_torn(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    design = filled(tmp_path, parts=2)
    before = names(tmp_path)
    with open_store(tmp_path, design, resume=True) as again, monkeypatch.context() as patch:
        if where == "rows":
            patch.setattr(store, "write_rows", full_disk)
        elif where == "rename":
            patch.setattr(os, "replace", full_disk)
        else:
            real = os.fsync
            patch.setattr(
                manifest.os, "fsync", lambda fd: full_disk() if is_ledger(fd) else real(fd)
            )
        with pytest.raises(CampaignError, match="no space is left on the disk"):
            again.add(20, 30, rows(design, 20, 30))
        assert again.done == 20
    assert Campaign(tmp_path).done == 20
    left = names(tmp_path) - before - {".lock"}
    assert left <= ({"parts/part-0000000020.parquet"} if where == "ledger" else set())
    with open_store(tmp_path, design, resume=True) as again:
        again.checked_parts()
        again.add(20, 30, rows(design, 20, 30))
    assert Campaign(tmp_path).query("SELECT count(*) FROM flights").rows == [(30,)]


def is_ledger(fd: int) -> bool:
    return os.readlink(f"/proc/self/fd/{fd}").endswith(manifest.NAME)


@needs("/dev/full")
def test_a_disk_that_is_really_full(tmp_path: Path) -> None:
    """/dev/full says what a full disk says."""
    design = lay_out(plan(samples=30))
    with pytest.raises(OSError, match="No space left") as caught:
        manifest.append(Path("/dev/full"), Part(0, 1, "a", 1, ""))
    assert caught.value.errno == errno.ENOSPC
    with pytest.raises(Exception, match="No space left") as told:
        store.write_rows(Path("/dev/full"), rows(design, 0, 30), design)
    assert store.is_disk(told.value)


def hold(folder: Path, ready: Any, done: Any) -> None:
    with open_store(folder, lay_out(plan()), resume=True):
        ready.set()
        done.wait(60)


def test_a_second_process_is_told_who_is_at_work_and_the_lock_dies_with_it(tmp_path: Path) -> None:
    context = multiprocessing.get_context("spawn")
    ready, done = context.Event(), context.Event()
    other = context.Process(target=hold, args=(tmp_path, ready, done), daemon=True)
    other.start()
    assert ready.wait(60)
    design = lay_out(plan())
    with pytest.raises(InputError, match=rf"in use by process {other.pid} on .* since "):  # noqa: SIM117
        with open_store(tmp_path, design, resume=True):
            pass
    other.kill()
    other.join()
    with open_store(tmp_path, design, resume=True) as mine:
        assert mine.missing(100) == [(0, 24)]


def test_another_campaign_is_refused_and_named(tmp_path: Path) -> None:
    design = filled(tmp_path)

    def refused(resume: bool, told: str, **given: Any) -> None:
        other = lay_out(plan(**{"samples": 30, **given}))
        with pytest.raises(InputError, match=told), open_store(tmp_path, other, resume=resume):
            pass

    refused(False, "contains a campaign with 30 flights; continue it with --resume")
    refused(True, "its seed is 3, not 4", seed=4)
    refused(True, "its plan differs in repeats, samples", samples=31, repeats=2)
    rewrite(tmp_path, versions={"springback": "0.0.9"})
    refused(True, "its springback's version is 0.0.9, not ")
    rewrite(tmp_path, versions={"springback": store.__version__, "numba": "0.1"}, cpu="Intel 386")
    with open_store(tmp_path, design, resume=True):
        numba, cpu = store.changed_versions(tmp_path)
    assert numba.startswith("numba was 0.1 and is ")
    assert cpu.startswith("the processor was Intel 386 and is ")


def rewrite(folder: Path, versions: dict[str, str] | None = None, **changes: Any) -> None:
    """Have campaign.json say something else, as if it had been begun so."""
    about = json.loads((folder / store.METADATA).read_text()) | changes
    about["versions"] |= versions or {}
    (folder / store.METADATA).write_text(json.dumps(with_digest(about)))


def test_another_source_or_preset_under_the_same_version_is_refused(tmp_path: Path) -> None:
    """Was let in: rows of two states of the physics in one campaign."""
    design = filled(tmp_path)

    def refused(told: str) -> None:
        with pytest.raises(InputError, match=told), open_store(tmp_path, design, resume=True):
            pass

    rewrite(tmp_path, versions={"source": "0123456789abcdef"})
    refused(r"source \([0-9a-f]{16}\) differs from that at its start \(0123456789abcdef\)")
    rewrite(tmp_path, versions={"source": store.source()}, scenarios_sha256="0")
    refused("a preset or a default that its plan uses has changed")


def test_every_part_says_which_source_and_numbers_flew(tmp_path: Path) -> None:
    import duckdb

    design = filled(tmp_path)
    sql = "SELECT decode(key), decode(value) FROM parquet_kv_metadata(?)"
    told = dict(duckdb.execute(sql, [str(tmp_path / "parts/part-0000000010.parquet")]).fetchall())
    assert told["source"] == store.source() == store.versions()["source"]
    assert told["scenarios"] == design.digest
    about = json.loads((tmp_path / store.METADATA).read_text())
    assert about["scenarios"]["arq"]["vehicle"]["arms"]["stiffness"] == 5000.0
    assert about["scenarios"]["arq"]["world"]["obstacles"][0]["surface"]["friction"] > 0.0


def test_a_folder_with_other_things_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("years of work")
    design = lay_out(plan())
    with (
        pytest.raises(InputError, match="has no campaign"),
        open_store(tmp_path, design, resume=True),
    ):
        pass
    assert names(tmp_path) == {"thesis.tex"}
    with pytest.raises(InputError, match="is a file"):  # noqa: SIM117
        with open_store(tmp_path / "thesis.tex", design, resume=False):
            pass


def test_a_campaign_that_died_before_it_began_can_be_gone_on_with(tmp_path: Path) -> None:
    (tmp_path / ".lock").touch()
    (tmp_path / store.PLAN).write_text("{")
    design = lay_out(plan())
    with open_store(tmp_path, design, resume=True) as begun:
        assert begun.done == 0
    about = json.loads((tmp_path / store.METADATA).read_text())
    assert about["plan_sha256"] == design.plan.digest()
    assert about["versions"].keys() == {
        "springback", "source", "python", "numpy", "scipy", "numba"
    }  # fmt: skip
    assert {"host", "cpu", "started", "seed", "flights"} <= about.keys()
