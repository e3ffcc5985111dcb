"""Test whether preload, free play or a one-sided damper explains ARQ's numbers on the slider.

    python studies/arm_laws.py

Each is added to readings B and D with one number, fitted to all eight numbers of ARQ in Table III.
Prints the table in studies/README.md.
"""

from __future__ import annotations

from springback.paper.arm_laws import BASES, VARIANTS, deviations, fit


def row(name: str, number: str, off: list[float]) -> str:
    """A line of the table: deviations of the eight numbers, and counts of the small ones."""
    near = (sum(abs(one) <= share for one in off) for share in (0.05, 0.10))
    words = [name, number, *(f"{100 * one:+.0f} %" for one in off), *map(str, near)]
    return f"| {' | '.join(words)} |"


def main() -> None:
    """Fit all of them."""
    heads = [f"{what}, {surface}" for surface in ("wall", "mat")
             for what in ("COR", "peak", "travel", "time")]  # fmt: skip
    print(f"| | fitted | {' | '.join(heads)} | within 5 % | within 10 % |")
    print("|:---|:---|" + "---:|" * 10)
    for base, law in BASES.items():
        print(row(f"reading {base}", "–", deviations(law)))
        for variant in VARIANTS:
            best = fit(base, variant)
            number = f"{variant.scale * best.value:.2g} {variant.unit}".strip()
            print(row(f"{base}, {variant.name}", number, list(best.deviations)))


if __name__ == "__main__":
    main()
