"""Self-contained pages: script, style and data in one file.

The script is built from ``web/src`` of the repository by ``make web`` (docs/decisions/0015).
"""

from __future__ import annotations

import base64
import functools
import hashlib
import html
import json
import re
from importlib import resources
from typing import Any, Literal, NamedTuple

from springback.version import __version__

App = Literal["replay", "lab"]
SELF, NONE = "'self'", "'none'"


class Page(NamedTuple):
    """A page and its content security policy."""

    text: str
    policy: str  # Content-Security-Policy, also in the text


@functools.cache
def part(name: str) -> str:
    """Text of a file of the bundle: ``springback.js``, ``springback.css`` or ``page.html``."""
    return (resources.files("springback.interfaces") / "web" / name).read_text(encoding="utf-8")


def page_of(title: str, app: App, data: Any, *, asks: bool = False) -> Page:
    """A self-contained page.

    Args:
        title: Title of the window.
        app: ``replay``, with data ``{"flights": [scene, ...]}``, or ``lab``.
        data: Plain data for it, without NaN.
        asks: Let the page query the server it came from; else it may contact no server.
    """
    script = part("springback.js")
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    policy = (
        f"default-src 'none'; script-src 'sha256-{digest}'; style-src 'unsafe-inline'; "
        f"img-src data: blob:; connect-src {SELF if asks else NONE}; "
        "base-uri 'none'; form-action 'none'"
    )
    filled = {
        "policy": html.escape(policy),
        "version": html.escape(__version__),
        "title": html.escape(title),
        "style": part("springback.css"),
        "app": app,
        "data": in_script(data),
        "script": script,
    }
    text = re.sub(r"\{\{(\w+)\}\}", lambda m: filled[m[1]], part("page.html"))
    return Page(text, policy)


def in_script(data: Any) -> str:
    """Plain data as JSON, escaped so that it can neither end nor begin a script element."""
    text = json.dumps(data, allow_nan=False, ensure_ascii=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
