"""HTTP with a time limit for the head of a request.

A connection left open, or fed one character a minute, would hold a file descriptor forever; a few
hundred of them would lock out everyone else.
"""

from __future__ import annotations

import asyncio
from typing import Any

from uvicorn.protocols.http.h11_impl import H11Protocol

#: Time limit from the opening of a connection, or the first byte of a later request, to the end of
#: the request's head [s] (chosen: a browser sends it at once).
HEAD_PATIENCE = 10.0


class PatientProtocol(H11Protocol):
    """Protocol that closes connections on which no complete request head has arrived in time."""

    patience = HEAD_PATIENCE
    _deadline: asyncio.TimerHandle | None = None

    def connection_made(self, transport: Any) -> None:
        """Start the time limit of the first request."""
        super().connection_made(transport)
        self._begin()

    def data_received(self, data: bytes) -> None:
        """Start the time limit of a later request at its first byte, and stop it after its head."""
        self._begin()
        super().data_received(data)
        if self._is_answering():
            self._end()

    def connection_lost(self, exc: Exception | None) -> None:
        """Stop the time limit."""
        self._end()
        super().connection_lost(exc)

    def _is_answering(self) -> bool:
        """True while a request whose head has arrived has not been answered."""
        return self.cycle is not None and not self.cycle.response_complete

    def _begin(self) -> None:
        if self._deadline is None and not self._is_answering():
            self._deadline = self.loop.call_later(self.patience, self._give_up)

    def _end(self) -> None:
        if self._deadline is not None:
            self._deadline.cancel()
            self._deadline = None

    def _give_up(self) -> None:
        self._deadline = None
        if not self._is_answering():
            self.transport.close()
