"""The impact lab as it is served, for tests that ask it things."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

from springback.interfaces.lab.app import lab_app
from springback.interfaces.lab.queue import RequestQueue
from springback.interfaces.lab.settings import LabSettings
from springback.interfaces.web.server import bound, server_of

#: Settings in a link that cannot be, and how what is said of them begins.
WRONG = {
    "speed=nan": "speed: must be finite (got nan m/s); 0.5 to 6 m/s",
    "speed=inf": "speed: must be finite",
    "speed=1e999": "speed: must be finite",
    "speed=-1e308": "speed: must be at least 0.5 m/s (got -1e+308 m/s)",
    "stiffness=50.001": "stiffness: must be at most 50 N/mm (got 50.001 N/mm); 0.5 to 50 N/mm",
    "stiffness=5+kg": "stiffness: has the wrong unit (got '5 kg'); expected N/mm",
    "pitch=9**9**9**9": "pitch: is not a number: it is more than one number (got '9**9**9**9')",
    "pitch=../x": "pitch: is not a number (got '../x'); expected deg; -60 to 60 deg",
    "pitch=": "pitch: is not a number (got '')",
    "pitch=__import__('os').getcwd()": "pitch: is not a number (got",
    "surface=../../etc/passwd": "surface: must be wall, mat or own (got '../../etc/passwd')",
    "speeed=2": "speeed: unknown key; did you mean speed?",
    "foo=1": "foo: unknown key; known keys: mode, robot",
    "speed=1&speed=2": "speed: is given twice; give it once",
    "recovery=%3Cscript%3E": "recovery: must be none, ",
    "yaw=%00": "yaw: is not a number",
    "arm_mass=" + "9" * 400: "arm_mass: is not a number",
}  # fmt: skip


@contextmanager
def served_lab(table: type[LabSettings] = LabSettings) -> Iterator[int]:
    """A lab on this machine whose default kind is ready; its port."""
    queue = RequestQueue(prepared=(table(),))
    queue.start()
    server = server_of(lab_app(queue, table))
    with bound("127.0.0.1", 0) as listening:
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]}, daemon=True)
        thread.start()
        assert queue.wait(table(), 400.0)
        while not server.started:
            time.sleep(0.01)
        yield listening.getsockname()[1]
        server.should_exit = True
        thread.join(10.0)
