#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds the program against published numbers and writes the pages that say how it stands.

    validation.py CLI             runs every row with this sparkout-cli, writes docs/validation.md and
                                  resources/help/*/validation.html
    validation.py CLI --check     fails where a row moved away from its published number by more than it
                                  may, and where a page is not what would be written
    validation.py CLI --table     prints the rows with the moves that they may have

The numbers are those of tests/validation/*.json, one file a source, and of the program. A source has
"runs" (a project, changes by JSON pointer, a command) and "cases"; a value of a case is an expression of
numbers, of the functions below and of "given", what the source prints, and "let", values of these.
`page.json` has the sentences.
Of a case, `move` is how far the ratio of program to published may be from 1; with `recorded`, a ratio
that is known to disagree, how much farther from 1 than that one.
"""
import argparse
import ast
import collections
import concurrent.futures
import csv
import html
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HERE = ROOT / "tests/validation"
PAGES = {("en", "md"): ROOT / "docs/validation.md",
         ("en", "html"): ROOT / "resources/help/en/validation.html",
         ("ru", "html"): ROOT / "resources/help/ru/validation.html"}
MOST_DIFFERENCES = 5  # lines of a page that a check shows


# ---- numbers ------------------------------------------------------------------------------------

def at(document, pointer):
    for key in filter(None, pointer.split("/")):
        document = document[int(key)] if isinstance(document, list) else document[key]
    return document


def spearman(xs, ys):
    """Rank correlation; equal values share the mean of their ranks."""
    def ranks(values):
        return [statistics.mean(i for i, other in enumerate(sorted(values), 1) if other == value)
                for value in values]
    return statistics.correlation(ranks(xs), ranks(ys))


def local_constants(depths, seconds):
    """Time in which the depth of cut would fall to 1/e, from each pass to the next."""
    return [seconds / math.log(a / b) for a, b in zip(depths, depths[1:])]


def first_constant(depths, seconds):
    """Time in which the depth of cut falls to 1/e of the first one."""
    return seconds * falls_to(depths, 1 / math.e)


def falls_to(depths, share):
    """Passes after which the depth has fallen to a share of the first, between passes as an exponential."""
    wanted = depths[0] * share
    index = next(i for i, depth in enumerate(depths) if depth <= wanted)
    return index - math.log(wanted / depths[index]) / math.log(depths[index - 1] / depths[index])


def after(depths, passes):
    """Share of the first depth that is left after some passes, between passes as an exponential."""
    index = int(passes)
    part = passes - index
    return (depths[index] / depths[0]) * (depths[index + 1] / depths[index]) ** part


def stops_and_travel(rows_a, minutes_a, rows_b, minutes_b):
    """Stops a double stroke in s and travel in mm by which two cycles of stages (feed, stock, axial feed)
    take their times: T = Σ N·(stops + 2·travel/v)."""
    def sums(rows, minutes):
        return (sum(stock / feed for feed, stock, _ in rows),
                sum(120 * stock / feed / axial for feed, stock, axial in rows), 60 * minutes)

    (n_a, m_a, t_a), (n_b, m_b, t_b) = sums(rows_a, minutes_a), sums(rows_b, minutes_b)
    determinant = n_a * m_b - n_b * m_a
    return [(t_a * m_b - t_b * m_a) / determinant, (n_a * t_b - n_b * t_a) / determinant]


FUNCTIONS = {"sqrt": math.sqrt, "log": math.log, "exp": math.exp, "pi": math.pi, "sum": sum, "len": len, "mean": statistics.mean, "s": statistics.stdev,
             "spearman": spearman, "local_constants": local_constants, "first_constant": first_constant,
             "after": after, "tan": math.tan, "stops_and_travel": stops_and_travel}
NODES = (ast.Expression, ast.Constant, ast.Name, ast.Load, ast.Store, ast.BinOp, ast.UnaryOp, ast.Add,
         ast.Sub, ast.Mult, ast.Div, ast.Pow, ast.USub, ast.Call, ast.List, ast.Subscript,
         ast.Slice, ast.GeneratorExp, ast.ListComp, ast.comprehension, ast.Compare, ast.Lt, ast.Gt,
         ast.LtE, ast.GtE, ast.BoolOp, ast.Or, ast.And)


def value_of(expression, names):
    if not isinstance(expression, str):
        return expression
    tree = ast.parse(expression, mode="eval")
    for node in ast.walk(tree):
        if not isinstance(node, NODES):
            raise ValueError(f"{type(node).__name__} is no operation of these files: {expression}")
    return eval(compile(tree, expression, "eval"), {"__builtins__": {}, **FUNCTIONS, **names})


# ---- the program --------------------------------------------------------------------------------

def changed(project, changes):
    for pointer, value in changes.items():
        *way, last = filter(None, pointer.split("/"))
        owner = at(project, "/".join(way))
        owner[int(last) if isinstance(owner, list) else last] = value
    return project


class Runs:
    """Results of the program by the name of a run; each is made once."""

    def __init__(self, cli, sources, folder):
        self.cli = cli
        self.folder = folder
        self.runs = {name: run for source in sources for name, run in source.get("runs", {}).items()}
        if len(self.runs) < sum(len(source.get("runs", {})) for source in sources):
            sys.exit("validation: two runs have one name")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            self.results = dict(zip(self.runs, pool.map(self.made, self.runs)))

    def made(self, name):
        run = self.runs[name]
        project = json.loads((ROOT / run["project"]).read_text(encoding="utf-8"))
        project["runs"] = []
        changed(project, run.get("set", {}))
        file = self.folder / f"{name}.sparkout"
        file.write_text(json.dumps(project), encoding="utf-8")
        command, *options = run.get("command", "simulate").split()
        trace = self.folder / f"{name}.csv"
        if run.get("trace"):
            options += ["--trace", str(trace)]
        done = subprocess.run([self.cli, command, str(file), "--json", *options], cwd=self.folder,
                              capture_output=True, text=True, encoding="utf-8", check=False)
        try:
            result = json.loads(done.stdout)
        except ValueError:
            sys.exit(f"validation: {name}: {command} ended with {done.returncode}: {done.stderr}")
        return {"result": result, "project": project,
                "trace": list(csv.DictReader(trace.open(encoding="utf-8"))) if run.get("trace") else []}

    def result(self, name, pointer):
        return at(self.results[name]["result"], pointer)

    def project(self, name, pointer):
        return at(self.results[name]["project"], pointer)

    def requirement(self, name, what, value):
        return next(row[value] for row in self.result(name, "/constraints") if row["name"] == what)

    def batch(self, name, what, where, value):
        return next(row[value] for row in self.result(name, "/characteristics")
                    if row["name"] == what and row["where"] == where)

    def depths(self, name, stage, section):
        """Mean depth of cut in µm of each revolution of a stage, the stages counted from 1."""
        passes = {}
        for row in self.results[name]["trace"]:
            if int(row["stage"]) == stage and int(row["section"]) == section:
                passes.setdefault(int(row["revolution"]), []).append(1000 * float(row["actual_mm"]))
        return [statistics.mean(passes[revolution]) for revolution in sorted(passes)]

    def steps(self, name, zone):
        """How many steps of a double stroke a zone has."""
        return len({row["step"] for row in self.results[name]["trace"] if row["zone"] == zone})

    def width(self, name, zone):
        """From the smallest to the largest diameter of a zone, over the stocks of one infeed."""
        place = ["rz1", "nz", "rz2"].index(zone)
        ends = [value for piece in self.result(name, "/pieces")
                for end in ("deviations_um_from", "deviations_um_to") for value in piece[end][place]]
        return max(ends) - min(ends)

    def spread(self, name):
        """From the smallest to the largest diameter of all zones."""
        ends = [value for zone in self.result(name, "/zones").values()
                for value in zone["diameter_deviation_um"]]
        return max(ends) - min(ends)

    def heat_share(self, name, film_w_m2k):
        """Share of the heat that enters the part at the deepest cut of the first stage, by a film of such
        a coefficient in the contact: h_w/(h_w + h_f), h_w = 0.886·λ/√Ω·√(V_d/L)."""
        part, wheel, work_rpm, conductivity, diffusivity = (self.project(name, pointer) for pointer in (
            "/part/diameter_mm", "/wheel/diameter_mm", "/machine/work_speed_rpm",
            "/material/conductivity_w_mk", "/material/diffusivity_mm2_s"))
        depth = self.result(name, "/shop/stages/0/largest_depth_um") / 1000
        contact = math.sqrt(depth * part * wheel / (part + wheel))
        into_part = (0.886 * conductivity * 1000 / math.sqrt(diffusivity)
                     * math.sqrt(math.pi * part * work_rpm / 60 / contact))
        return into_part / (into_part + film_w_m2k)

    def names(self):
        return {name: getattr(self, name) for name in (
            "result", "project", "requirement", "batch", "depths", "steps", "width",
            "spread", "heat_share")}


class Case:
    def __init__(self, source, entry):
        self.source, self.entry, self.id = source, entry, entry["id"]
        try:
            self.published, self.program, *self.also = (
                value_of(one, source["names"])
                for one in (entry["published"], entry["program"], *entry.get("also", [])))
        except Exception as error:  # whatever an expression may do
            sys.exit(f"validation: {self.id} has no value: {error!r}")
        self.recorded, self.move = entry.get("recorded"), entry["move"]
        low, high = self.published if isinstance(self.published, list) else [self.published] * 2
        self.ratio = 1.0 if low <= self.program <= high else min(
            (self.program / low, self.program / high), key=lambda ratio: abs(ratio - 1))
        self.inside = isinstance(self.published, list) and self.ratio == 1.0

    def agrees(self):
        return self.recorded is None

    def kind(self):
        """Of its standing: calibrated, formula, assumed or predicted."""
        standing = self.entry["standing"]
        if isinstance(standing, list):
            return "predicted" if len(standing) > 2 else "calibrated"
        return standing if standing in ("formula", "assumed") else "predicted"

    def holds(self):
        known = 1.0 if self.agrees() else self.recorded
        return abs(self.ratio - 1) <= abs(known - 1) + self.move

    def fault(self):
        allowed = (f"{self.move:g}" if self.agrees() else
                   f"the recorded {self.recorded:g} is, and {self.move:g}")
        unit = Words({}, "en").of(self.entry.get("unit", ""))
        return (f"{self.id}: program {self.program:.6g} {unit}, published {self.published} {unit}: the ratio "
                f"{self.ratio:.4f} is farther from 1 than {allowed}")


# ---- pages --------------------------------------------------------------------------------------

class Words:
    """The sentences of page.json in one language, with figures set as this language sets them."""

    def __init__(self, page, language):
        self.language, self.page = language, page

    def of(self, text):
        return text[self.language] if isinstance(text, dict) else text

    def number(self, value, digits=3, strip=False):
        """To so many significant digits; a whole number of the files or the program as it is."""
        if isinstance(value, list):
            return "…".join(self.number(one, digits, strip) for one in value)
        places = 0 if isinstance(value, int) or not value else max(
            0, digits - 1 - math.floor(math.log10(abs(value))))
        text = f"{value:,.{places}f}" if abs(value) >= 10000 else f"{value:.{places}f}"
        if strip and "." in text:
            text = text.rstrip("0").rstrip(".")
        if self.language == "ru":
            text = text.replace(",", "\u00a0").replace(".", ",")
        return text.replace("-", "−")

    def ratio(self, value):
        near = abs(value - 1) < 0.1
        return self.number(value, 4 if near and value >= 1 else 3 if near or abs(value) >= 10 else 2
                           if abs(value) < 1 else 3)

    def say(self, key, **values):
        return self.of(self.page["words"][key]).format(**values)

    def figure(self, case, value, published=False):
        """What is printed has up to four digits, what is computed three, unless the case says otherwise."""
        unit = self.of(case.entry.get("unit", ""))
        digits = case.entry.get("digits", 4 if published else 3)
        return self.number(value, digits, published) + (f"\u00a0{unit}" if unit else "")

    def standing(self, case):
        standing = case.entry["standing"]
        if isinstance(standing, list):
            return self.say("after" if len(standing) > 2 else "calibrated", chosen=standing[0],
                            printed=standing[1])
        return self.say(standing)

    def reading(self, case):
        share = case.move * 100
        if not case.agrees():
            held = self.say("disagrees", recorded=self.number(case.recorded, 3, True),
                            move=self.number(case.move, 2, True))
        elif case.inside:
            held = self.say("inside")
        else:
            held = self.say("within", move=self.number(share, 2, True)) if share > 1e-6 else self.say("equal")
        note = self.of(case.entry.get("reading", "")).format(*map(self.number, case.also))
        return " ".join(filter(None, (self.standing(case), held, note)))


class Figures(dict):
    """Figures of cases and counts for the sentences: {id} is the program's, {id.published} the source's."""

    def __init__(self, words, cases, counts):
        super().__init__({name: str(count) for name, count in counts.items()})
        self.words, self.cases = words, {case.id: case for case in cases}

    def __missing__(self, key):
        name, _, what = key.partition(".")
        case = self.cases[name]
        if what == "ratio":
            return self.words.ratio(case.ratio)
        printed = what == "published"
        return self.words.figure(case, case.published if printed else case.program, printed)

    def set(self, text):
        return re.sub(r"\{([\w.-]+)\}", lambda found: self[found[1]], text)


def blocks(words, sources, cases, page):
    """What stands on a page: ("h1", text), ("h2", anchor, text), ("p", text), ("list", texts) and
    ("table", rows)."""
    counts = collections.Counter(case.kind() for case in cases if case.agrees())
    counts.update(sources=len(sources), rows=len(cases), agreeing=sum(case.agrees() for case in cases),
                  disagreeing=sum(not case.agrees() for case in cases))
    figures = Figures(words, cases, counts)

    def text(entry):
        return figures.set(words.of(entry))

    yield "h1", text(page["title"])
    yield "p", text(page["wrong"]["lead"])
    yield "list", [text(entry) for entry in page["wrong"]["items"]]
    for entry in page["introduction"]:
        yield "p", text(entry)
    for topic in page["topics"]:
        yield "h2", topic["id"], text(topic["title"])
        yield "p", text(topic["text"])
        rows = [[words.of(heading) for heading in page["columns"]]]
        rows += [[words.of(case.entry["what"]), words.figure(case, case.published, True),
                  words.figure(case, case.program), words.ratio(case.ratio), words.reading(case)]
                 for case in cases if case.entry["topic"] == topic["id"]]
        yield "table", rows
    yield "h2", "contradictions", text(page["contradictions"]["title"])
    yield "p", text(page["contradictions"]["text"])
    yield "list", [words.of(entry["text"]).format(*(words.number(value_of(one, source["names"]), 3, True)
                                                    for one in entry["values"]))
                   for source in sources for entry in source.get("contradictions", [])]
    yield "h2", "works", text(page["works"])
    yield "list", [" ".join((f"*{words.of(source['work'])}*.", words.of(source["licence"]), words.of(source["read"])))
                   for source in sources]


def marked(text, code, name):
    """Sets `code` and *names of works*."""
    text = re.sub(r"`([^`]+)`", code, text)
    return re.sub(r"\*([^*]+)\*", name, text)


def as_markdown(page):
    lines = ["<!-- Written by tests/validation/validation.py. -->"]
    for kind, *content in page:
        if kind == "h1":
            lines += [f"# {content[0]}", ""]
        elif kind == "h2":
            lines += [f"## {content[1]}", ""]
        elif kind == "p":
            lines += [content[0], ""]
        elif kind == "list":
            lines += [f"* {entry}" for entry in content[0]] + [""]
        else:
            head, *rows = content[0]
            lines += ["| " + " | ".join(row) + " |" for row in [head, ["---"] * len(head), *rows]] + [""]
    return "\n".join(lines[:-1]) + "\n"


def as_html(page):
    def inline(text):
        return marked(html.escape(text, quote=False), r"<code>\1</code>", r"<cite>\1</cite>")

    lines = []
    for kind, *content in page:
        if kind == "h1":
            lines.append(f"<h1>{inline(content[0])}</h1>")
        elif kind == "h2":
            lines.append(f'<h2 id="{content[0]}">{inline(content[1])}</h2>')
        elif kind == "p":
            lines.append(f"<p>{inline(content[0])}</p>")
        elif kind == "list":
            lines += ["<ul>", *(f"<li>{inline(entry)}</li>" for entry in content[0]), "</ul>"]
        else:
            head, *rows = content[0]
            lines.append('<table width="99%">')  # at 100 % it is a pixel wider than the window
            lines.append("<tr>" + "".join(f'<th align="left">{inline(cell)}</th>' for cell in head)
                         + "</tr>")
            lines += ["<tr>" + "".join(f"<td>{inline(cell)}</td>" for cell in row) + "</tr>"
                      for row in rows]
            lines.append("</table>")
    return "\n".join(lines) + "\n"


def differences(path, wanted):
    present = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    wanted = wanted.splitlines()
    lines = [f"  line {number}: {new}" for number, (old, new) in enumerate(zip(present, wanted), 1)
             if old != new]
    if len(present) != len(wanted):
        lines.append(f"  {len(present)} lines, {len(wanted)} wanted")
    return lines[:MOST_DIFFERENCES]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("cli", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    cli = options.cli.resolve()
    sys.stderr.reconfigure(errors="backslashreplace")  # whatever the terminal can show
    here = cli.parent if os.access(cli.parent, os.W_OK) else None
    page = json.loads((HERE / "page.json").read_text(encoding="utf-8"))
    sources = [json.loads((HERE / f"{name}.json").read_text(encoding="utf-8")) for name in page["sources"]]
    with tempfile.TemporaryDirectory(prefix="validation-", dir=here) as folder:
        runs = Runs(cli, sources, pathlib.Path(folder))
    for source in sources:
        names = source["names"] = {**runs.names(), **source.get("given", {})}
        for name, expression in source.get("let", {}).items():
            names[name] = value_of(expression, names)
    cases = [Case(source, entry) for source in sources for entry in source["cases"]]
    faults = [case.fault() for case in cases if not case.holds()]
    if options.table:
        for case in cases:
            print(f"{case.id:30} published {case.published} program {case.program:.6g} ratio "
                  f"{case.ratio:.4f} recorded {case.recorded} move {case.move}")
    for (language, form), path in PAGES.items():
        wanted = (as_markdown if form == "md" else as_html)(
            list(blocks(Words(page, language), sources, cases, page)))
        if options.check:
            lines = differences(path, wanted)
            if lines:
                faults.append(f"{path.relative_to(ROOT)} is not what tests/validation/validation.py "
                              "writes; run it on this build:\n" + "\n".join(lines))
        elif not options.table:
            path.write_text(wanted, encoding="utf-8")
    for fault in faults:
        print(f"validation: {fault}", file=sys.stderr)
    print(f"validation: {len(sources)} sources, {len(cases)} rows, "
          f"{sum(case.agrees() for case in cases)} agree, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
