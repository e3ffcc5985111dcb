"""Hooks: methods of results that the interfaces carry out, and what these return in notebooks.

A `Flight` can be saved, drawn and replayed, but `results` knows neither figures nor pages.  The
package names the functions that do it (docs/decisions/0026); they are loaded on first use.  This
module is loaded with the package, so it imports nothing.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

_PLACES: dict[str, tuple[str, str]] = {}


def provide(places: Mapping[str, tuple[str, str]]) -> None:
    """Name the functions that carry out methods.

    Args:
        places: Module and function by class and method, such as ``Flight.save``.
    """
    _PLACES.update(places)


def hook(name: str) -> Any:
    """Function that carries out a method such as ``Flight.save``; it takes the object first."""
    import importlib

    module, function = _PLACES[name]
    return getattr(importlib.import_module(module), function)


class NotebookPage:
    """A self-contained page, which a notebook shows in a frame."""

    def __init__(self, text: str, height: int = 720) -> None:
        """Page of HTML with all that it needs, in a frame of some height [px]."""
        self.text = text
        self.height = height

    def __repr__(self) -> str:
        return f"<page of {len(self.text) / 1e6:.1f} MB; a notebook shows it>"

    def _repr_html_(self) -> str:
        import html

        return (
            f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="{self.height}" '
            'style="border:0" allow="fullscreen"></iframe>'
        )


def in_notebook() -> bool:
    """True in a notebook, whose output may be HTML."""
    import sys

    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return getattr(shell, "kernel", None) is not None
