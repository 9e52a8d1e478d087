#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/layers.txt into docs/architecture.md: an arrow where a folder includes another one and
no third one leads there. --check: only asks whether the drawing is that of the rules."""
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
BEGIN, END = "<!-- drawn by draw_layers.py -->", "<!-- end of the drawing -->"


def rules():
    folders, last = {}, None
    for line in (HERE / "layers.txt").read_text(encoding="utf-8").splitlines():
        if not line or line.startswith("#"):
            continue
        if not line.startswith(" "):
            last, _, line = line.partition(":")
            folders[last] = []
        folders[last] += line.split()
    return folders


def merged(folders):
    """The views as one room: none includes another."""
    room = lambda name: "ui/views/…" if name.startswith("ui/views/") else name
    out = {}
    for name, others in folders.items():
        out.setdefault(room(name), set()).update(room(other) for other in others)
    return {name: others - {name} for name, others in out.items()}


def reached(folders, name, known):
    """All that a folder includes, directly or by others; known: of each folder asked before."""
    if name not in known:
        known[name] = set(folders[name])
        for other in folders[name]:
            known[name] |= reached(folders, other, known)
    return known[name]


def direct(folders):
    """Arrows to what no other arrow leads to."""
    known = {}
    for name, others in folders.items():
        for other in sorted(others):
            if not any(other in reached(folders, third, known) for third in others - {other}):
                yield name, other


def drawing():
    folders = merged(rules())
    names = {name: f"n{i}" for i, name in enumerate(folders)}
    lines = ["```mermaid", "graph TD"]
    for title in ("app", "python", "ui", "words", "core"):
        lines.append(f"  subgraph {title}_ [{title}]")
        for name, key in names.items():
            if name.split("/")[0] == title:
                lines.append(f'    {key}["{name}"]')
        lines.append("  end")
    lines += [f"  {names[a]} --> {names[b]}" for a, b in direct(folders)]
    return "\n".join(lines + ["```"])


def main():
    page = HERE / "architecture.md"
    text = page.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    drawn = f"{before}{BEGIN}\n{drawing()}\n{END}{after}"
    if "--check" in sys.argv:
        sys.exit(0 if drawn == text else "docs/architecture.md: run docs/draw_layers.py")
    page.write_text(drawn, encoding="utf-8")


main()
