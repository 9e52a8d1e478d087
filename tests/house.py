#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts what makes the tree hard to live in, prints it, and fails where it has grown: files that know
a kind of operation or of spark-out, sources without a header of their name, links of the pages
that lead nowhere, and the size of docs/why."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What is there today, never more; what is aimed at stands beside it.
LIMITS = {
    "files that know a kind of operation": (8, 30),
    "files that know spark-out": (7, 10),
    "sources without a header of their name": (0, 0),
    "links that lead nowhere": (0, 0),
    "pages of docs/why, together beyond 25 KB": (0, 0),
    "files of the programs that print past the console": (0, 0),
    "files that take axes in the order of a hash": (0, 0),
    "helpers of a test that it does not call": (0, 0),
}


# A kind by its name: as a value, as a case of match(), as an alternative that is asked for.
KIND = r"\bOperation::(traverse|plunge)\b|\b(Traverse|Plunge)\b *[{>)&]|conditions::(traverse|plunge)\b"


def tracked(*folders):
    names = subprocess.run(["git", "ls-files", *folders], cwd=ROOT, check=True, text=True,
                           stdout=subprocess.PIPE).stdout.split("\n")
    return [name for name in names if re.search(r"\.(h|cpp)$", name)]


def knowing(files, pattern):
    return [f for f in files if re.search(pattern, (ROOT / f).read_text(encoding="utf-8"))]


def idle_helpers(names):
    """Functions outside the class of a test that stand in its source once: a namespace with a name
    hides them from the compiler's warning."""
    head = re.compile(r"^(?!using|namespace|return|else|struct|class|enum)"
                      r"[A-Za-z\[][\w:<>,&*\[\] ]*?[ &*](\w+)\([^;{}]*\)\s*\{", re.M)
    for name in names:
        text = re.sub(r"//.*", "", (ROOT / name).read_text(encoding="utf-8"))
        yield from (f"{name}: {function}" for function in head.findall(text)
                    if function != "main" and len(re.findall(rf"\b{function}\b", text)) == 1)


def dead_links():
    """Links and paths of the pages to what is not in the tree; NAME stands for any name."""
    folder = r"`((?:app|cmake|core|docs|packaging|python|resources|tests|translations|ui|words)/[\w./-]+)`"
    for page in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md")]:
        text = page.read_text(encoding="utf-8")
        leads = [(page.parent, link) for link in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", text)]
        leads += [(ROOT, path) for path in re.findall(folder, text) if "NAME" not in path]
        yield from (f"{page.relative_to(ROOT)}: {link}" for base, link in leads
                    if not (base / link).exists())


def main():
    files = tracked("core", "words", "ui", "app", "python")
    headers = set(files)
    alone = [f for f in files if f.startswith(("core/", "words/", "ui/")) and f.endswith(".cpp")
             and re.sub(r"(_posix|_windows)?\.cpp$", ".h", f) not in headers]
    why = list((ROOT / "docs/why").glob("*.md"))
    prints = r"\b(fputs|fwrite|printf|fprintf|puts|fputc|putchar|cout|cerr|clog)\b *[(<;]"
    found = {
        # Texts reach the terminal by printText() alone, which takes out what steers it.
        "files of the programs that print past the console": [
            f for f in knowing(files, prints) if f.startswith("app/")
            and not f.startswith(("app/console", "app/write_"))],
        "helpers of a test that it does not call": list(idle_helpers(
            name for name in tracked("tests") if pathlib.PurePath(name).match("test_*.cpp"))),
        "files that know a kind of operation": knowing(files, KIND),
        "files that know spark-out": knowing(files, r"\bSparkOut\b|\bspark_out\b"),
        # For those who compare: the same widely, by any name.
        "files that ask for anything of a spark-out": knowing(
            files, r"[sS]parkOut|\bspark_out\b|unfed_steps|waitsForSize|untilSize"),
        # Drawings are the same, byte by byte, at each start of the program: style::axesOf().
        "files that take axes in the order of a hash": knowing(files, r"\baxes\(\)"),
        "files that ask for traits of an operation": knowing(files, r"\boperation *->"),
        "sources without a header of their name": alone,
        "links that lead nowhere": list(dead_links()),
        "pages of docs/why, together beyond 25 KB":
            why if sum(page.stat().st_size for page in why) > 25_000 else [],
    }
    grown = False
    for name, (limit, aim) in LIMITS.items():
        count = len(found[name])
        print(f"HOUSE {count:3} {name} (at most {limit}, aim {aim})")
        if count > limit:
            grown = True
            print("\n".join(sorted(set(map(str, found[name])))))
    for name in found.keys() - LIMITS.keys():
        print(f"HOUSE {len(found[name]):3} {name}")
    return 1 if grown else 0


sys.exit(main())
