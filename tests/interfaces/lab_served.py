"""The impact lab as it is served, for tests that ask it things."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

from springback.interfaces.lab import lab_app
from springback.interfaces.lab_desk import Desk
from springback.interfaces.lab_settings import DEFAULTS
from springback.interfaces.serving import bound, server_of


@contextmanager
def served_lab() -> Iterator[int]:
    """A lab on this machine whose default kind is ready; its port."""
    desk = Desk(prepared=(DEFAULTS,))
    desk.open()
    server = server_of(lab_app(desk))
    with bound("127.0.0.1", 0) as listening:
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]}, daemon=True)
        thread.start()
        assert desk.wait(DEFAULTS, 400.0)
        while not server.started:
            time.sleep(0.01)
        yield listening.getsockname()[1]
        server.should_exit = True
        thread.join(10.0)
