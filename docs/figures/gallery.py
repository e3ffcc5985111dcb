"""Figures of the gallery, by the commands that the page names.

python docs/figures/gallery.py
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
EXAMPLES = HERE.parents[1] / "examples"
COMMANDS = [
    ["fly", f"{EXAMPLES}/own_vehicle.toml", "--out", "flight"],
    ["campaign", f"{EXAMPLES}/own_campaign.toml", "--out", "study"],
    ["summary", "study", "--out", "page", "--map", "stiffness,speed"],
]
#: Names on the page, and the files that the commands write.
PICTURES = {
    "gallery_flight.png": "flight/flight.png",
    "gallery_energy.png": "flight/energy.png",
    "gallery_map.png": "page/map-stiffness-speed.png",
    "gallery_marginals.png": "page/marginals.png",
}


def main() -> None:
    """Run the commands in an empty folder, and keep their pictures."""
    with tempfile.TemporaryDirectory() as folder:
        for words in COMMANDS:
            subprocess.run([sys.executable, "-m", "springback", *words], cwd=folder, check=True)
        for name, path in PICTURES.items():
            shutil.copy(Path(folder) / path, HERE / name)


if __name__ == "__main__":
    main()
