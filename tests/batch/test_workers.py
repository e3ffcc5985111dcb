"""Worker processes end with the process that started them, even where that one was killed."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time

import pytest

#: Starts a pool of one worker, prints the worker's number, and waits.
PARENT = """
import os, time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from springback.batch.workers import end_with_parent
from springback.campaign.common_flights import _report_to

if __name__ == "__main__":
    context = get_context("spawn")
    first, args = {starts}
    pool = ProcessPoolExecutor(1, context, first, args)
    print(pool.submit(os.getpid).result(), flush=True)
    time.sleep(600)
"""


def is_running(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    with open(f"/proc/{process}/stat") as status:  # a zombie has ended
        return status.read().rpartition(")")[2].split()[0] != "Z"


@pytest.mark.skipif(not os.path.exists("/proc/self/stat"), reason="needs Linux's /proc")
@pytest.mark.parametrize("starts", ["(end_with_parent, ())", "(_report_to, (context.Queue(),))"])
@pytest.mark.parametrize("kill", [signal.SIGTERM, signal.SIGKILL])
def test_workers_end_with_a_killed_parent(tmp_path, starts, kill):
    script = tmp_path / "parent.py"
    script.write_text(PARENT.format(starts=starts), encoding="utf-8")
    with subprocess.Popen([sys.executable, str(script)], stdout=subprocess.PIPE) as parent:
        worker = int(parent.stdout.readline())
        assert is_running(worker)
        parent.send_signal(kill)
    until = time.monotonic() + 30.0
    while is_running(worker) and time.monotonic() < until:
        time.sleep(0.05)
    ended = not is_running(worker)
    if not ended:
        os.kill(worker, signal.SIGKILL)
    assert ended
