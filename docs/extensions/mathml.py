r"""Mathematics as MathML, rendered when the pages are built: no network and no script needed.

`\tag{5}` puts the paper's number of an equation beside it.
"""

import re
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError

TAG = re.compile(r"\\tag\{(.+?)\}")
#: What the converter knows by another name.
SYNONYMS = {"{aligned}": "{split}"}
#: What it puts out where it does not know a command.
UNKNOWN = re.compile(r"<m[io]>(&(?!#)|\\)")


def mathml(latex: str, display: str) -> str:
    """A formula as a ``<math>`` element.

    Raises:
        ExtensionError: If something in it is not known to the converter.
    """
    for ours, theirs in SYNONYMS.items():
        latex = latex.replace(ours, theirs)
    try:
        made = convert(latex, display=display)
    except Exception as error:
        raise ExtensionError(f"cannot be set as MathML: {latex!r} ({error!r})") from error
    if UNKNOWN.search(made):
        raise ExtensionError(f"cannot be set as MathML: {latex!r}")
    return made


def inline(writer: Any, node: nodes.math) -> None:
    """A formula in a line."""
    writer.body.append(mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def block(writer: Any, node: nodes.math_block) -> None:
    """A formula of its own, its number at the right."""
    latex = node.astext().strip()
    tag = TAG.search(latex)
    number = f'<span class="eqno">({tag[1]})</span>' if tag else ""
    made = mathml(TAG.sub("", latex), "block")
    anchors = "".join(f'<span id="{name}"></span>' for name in node.get("ids", []))
    writer.body.append(f'<div class="math">{anchors}<div>{made}</div>{number}</div>\n')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the renderer."""
    app.add_html_math_renderer("mathml", (inline, None), (block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
