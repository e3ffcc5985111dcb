"""Code in the pages that names something of springback leads to it."""

import re
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform
from sphinx.transforms.post_transforms import SphinxPostTransform

NAME = re.compile(r"springback(\.\w+)+")


class NamesToLinks(SphinxTransform):
    """`` `springback.contact.cage.support` `` becomes a reference; an unknown name is an error."""

    default_priority = 400

    def apply(self, **kwargs: Any) -> None:
        """Walk the page."""
        for node in list(self.document.findall(nodes.literal)):
            text = node.astext()
            if not NAME.fullmatch(text) or isinstance(node.parent, nodes.reference):
                continue
            if isinstance(node.parent, addnodes.pending_xref | nodes.title):
                continue
            short = text if text.count(".") == 1 else text.removeprefix("springback.")
            link = addnodes.pending_xref(
                "", nodes.literal(text, short, classes=["xref"]),
                refdomain="py", reftype="obj", reftarget=text, refexplicit=True,
                refdoc=self.env.docname, refwarn=True,
            )  # fmt: skip
            node.replace_self(link)


class BreaksInTables(SphinxPostTransform):
    """Dotted names and paths in the cells of a table may be broken behind a dot or a stroke."""

    default_priority = 900
    formats = ("html",)

    def run(self, **kwargs: Any) -> None:
        """Walk the page."""
        for entry in self.document.findall(nodes.entry):
            for node in list(entry.findall(nodes.literal)):
                parts = re.split(r"(?<=[./])(?=\w)", node.astext())
                if len(parts) < 2:
                    continue
                node.clear()
                for k, part in enumerate(parts):
                    if k:
                        node += nodes.raw("", "<wbr>", format="html")
                    node += nodes.Text(part)


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the transform."""
    app.add_transform(NamesToLinks)
    app.add_post_transform(BreaksInTables)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
