#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what docs/layers.txt states into two pages: the drawing of architecture.md, a box for each
title and an arrow where a box includes another one and no third one leads there, and the map of
folders of README.md. --check: only fails where a page is not what it writes."""
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
BEGIN, END = "<!-- written by docs/draw_layers.py -->", "<!-- end of what it writes -->"


def boxes():
    """Title: {folder: (what it holds, folders it includes)}."""
    found, holds, folder = {}, "", ""
    for line in (HERE / "layers.txt").read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            title = line[3:]
            found[title] = {}
        elif not found or not line:
            continue
        elif line.startswith("# "):
            holds = line[2:]
        else:
            if not line.startswith(" "):
                folder, _, line = line.partition(":")
                if not holds and folder not in found[title]:
                    sys.exit(f"docs/layers.txt does not say what {folder} holds")
                found[title].setdefault(folder, (holds, set()))
                holds = ""
            found[title][folder][1].update(line.split())
    return found


def arrows(found):
    """From each box to those it includes, but to none that another arrow leads to."""
    box_of = {folder: title for title, folders in found.items() for folder in folders}
    reached = {}
    for title, folders in found.items():  # a row names only rows above it
        others = {box_of[other] for _, row in folders.values() for other in row} - {title}
        below = set().union(*(reached[other] for other in others))
        reached[title] = others | below
        yield from ((title, other) for other in found if other in others - below)


def drawing(found):
    names = {title: f"n{i}" for i, title in enumerate(found)}
    lines = ["```mermaid", "graph TD"]
    for title, folders in found.items():
        rows = list(folders)
        listed = "<br/>".join(", ".join(rows[i:i + 3]) for i in range(0, len(rows), 3))
        lines.append(f'  {names[title]}["<b>{title}</b><br/>{listed}"]')
    lines += [f"  {names[a]} --> {names[b]}" for a, b in arrows(found)]
    return "\n".join(lines + ["```"])


def table(found):
    lines = ["| folder | what it holds |", "| --- | --- |"]
    for title, folders in found.items():
        lines.append(f"| **{title}** | |")
        lines += [f"| `{name}{'' if name.endswith(('.h', '…')) else '/'}` | {holds} |"
                  for name, (holds, _) in folders.items()]
    return "\n".join(lines)


def main():
    found = boxes()
    for page, part in ((HERE / "architecture.md", drawing), (HERE.parent / "README.md", table)):
        text = page.read_text(encoding="utf-8")
        before, rest = text.split(BEGIN)
        written = f"{before}{BEGIN}\n{part(found)}\n{END}{rest.split(END)[1]}"
        if "--check" not in sys.argv:
            page.write_text(written, encoding="utf-8")
        elif written != text:
            sys.exit(f"{page.name}: run docs/draw_layers.py")


main()
