"""Untrusted text for terminals, without control characters."""

from __future__ import annotations

import unicodedata

#: Categories of control characters and surrogates; characters that change the direction of writing.
_STEERING = {"Cc", "Cs"}
_TURNING = "\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
_HARMLESS = "\n\t"


def plain_text(text: str) -> str:
    """A text with ``\ufffd`` for characters that control a terminal or cannot be written."""
    if text.isascii() and text.replace("\n", "").replace("\t", "").isprintable():
        return text
    return "".join(
        "\ufffd"
        if (unicodedata.category(sign) in _STEERING and sign not in _HARMLESS) or sign in _TURNING
        else sign
        for sign in text
    )
