#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/reliability.md of what the long tests measured.

    reliability_table.py LOGS OUT     LOGS: build/logs of `./workbench test --long`

Every figure is of a line `CHECK nn value limit PASS|FAIL  note`, printed by the test that performs
the check; a check without a line is said to have none. What is asked and what is weaker is written
down here, by hand.
"""
import datetime
import os
import pathlib
import platform
import re
import subprocess
import sys

# As the workbench gathers them, or as ctest -V shows them.
LINE = re.compile(r"^(?:\d+: )?(?:QINFO *: \S+\([^)]*\) )?CHECK (\d\d)\w* (\S+) (\S+) (PASS|FAIL|SKIP)\s*(.*)$")
MANY = 5  # lines of a check from which on the worst stands for them

# number: (check, what is asked, how the program is weaker than that; None: it is not)
CHECKS = {
    "01": ("Every system call on files fails",
           "at least 120 injected errors that hit; the file exactly old or new, the report true, "
           "nothing left over", None),
    "02": ("kill -9", "at each call and at 1,000 random moments: no torn file; what is left over is "
           "removed by the next save",
           "only the writer is killed, in a process of its own; for the window see 9"),
    "03": ("Full disk, odd targets", "2,000 saves on a disk nearly full without a silent loss; 12 kinds "
           "of targets as documented",
           "all outputs go through the one writer, which is tested; each kind of output is not"),
    "04": ("Round trip", "1,000 random projects and every leaf away from its default: the same bytes; "
           "also after 1,000 random sequences of edits and runs, failed ones among them", None),
    "05": ("Cut and flipped files", "cut at every byte, every bit flipped: no crash, none above 1 s",
           "the sample has 3 KB; the file has no checksum, so a flip that leaves a valid project "
           "is not noticed"),
    "06": ("Fuzzing", "libFuzzer with sanitizers, 3,000,000 runs for each reader",
           "not done: no fuzzer is in the tree"),
    "07": ("Hostile files", "at least 150, each below 2 s and 512 MB with a message", None),
    "08": ("Versions", "a project of every released version opens",
           "there is one version so far; check 7 includes the refusal of a newer one"),
    "09": ("Recovery", "50 windows killed at random moments, 10 damaged recovery files: work offered, "
           "start succeeds", None),
    "10": ("Two windows, one file", "6 scenes, 20 repeats, no lost update", None),
    "11": ("Exact cases", "at least 15 closed forms with their source",
           "the tolerance stands beside each, 1e-9 to 1e-12, where 1e-10 is asked"),
    "12": ("Order of convergence", "within 0.1 of theory",
           "not done: a cycle is summed pass by pass; there is no integrator to refine"),
    "13": ("Conservation", "10,000 random cycles: volume and power balance to rounding", None),
    "14": ("Properties", "at least 40 laws on 1,000 random cycles each",
           "only the laws of cycles and of the best cycle are counted, fewer than 40; the tests "
           "of single quantities have others"),
    "15": ("Second opinion", "1,000 random projects against a second implementation to 1e-9",
           "the second implementation is also C++ in double precision, not quadruple; check 17 "
           "uses a program in another language"),
    "16": ("Out of the domain", "10,000 random inputs outside the limits: no NaN, a reason for each",
           "values at and beyond each limit, not random ones"),
    "17": ("Golden numbers, processors", "30 projects, also without AVX and FMA",
           "the cycles of a separate program; without AVX only the kernel of a pass "
           "(test_pass_kernel), one compiler"),
    "18": ("Determinism, floating-point traps", "the same bits for any number of threads, no trap",
           "no run with floating-point traps"),
    "19": ("Honest optimiser, mutants", "claims re-checked on 1,000 problems; 80 % of 100 mutants killed",
           "100 problems are run again, not 1,000"),
    "20": ("The window never stands still", "no gap above 100 ms, 99 of 100 below 30 ms: largest "
           "project, 100,000 parts, report of 200 pages, views, resizing",
           "a gap counts only when three tries show it; 6 MB are saved instead of 20"),
    "21": ("Stop and close", "within 200 ms at 200 random moments of runs, batches, searches, reports "
           "and loading; 100 closed windows; nothing changed",
           "in a release build, not under the sanitizers"),
    "22": ("Monkeys", "10 seeds × 10,000 events under the sanitizers, 90 % of the widgets reached, no "
           "crash, report or warning of Qt", "two of the ten seeds a run, by the day"),
    "23": ("Leaks", "2,000 rounds: at most 2 MB more, no object more",
           "the sanitizers look for leaks in the tests of the engine, not when the window closes"),
    "24": ("Races", "thread sanitizer on the engine: no warning",
           "not done; batches are compared bit by bit instead, see 18"),
    "25": ("Undo", "100 sequences of 100 commands undone and redone, equal both ways", None),
    "26": ("Injection", "40 hostile texts in every field and output",
           "no line of its own: single texts are tested in reports, tables and labels "
           "(test_passport_pages, test_csv_table, test_xlsx_book, test_plot_export), in printed "
           "output (test_cli_terminal) and in opened files (traced_opening)"),
    "27": ("Locale and surroundings", "engine and files under foreign locales, no HOME, no display",
           "one foreign locale (ru_RU, as a stage of its own), no sandbox; environments of the "
           "command line in test_cli_surroundings"),
    "28": ("Command line, binary", "1,000 random command lines end in a documented status; hardened "
           "binaries, equal builds",
           "the hardening is checked by programs_hardening, the equality of two builds is not"),
}
LEAST_IS_WORST = {"22"}


def lines_of(log):
    try:
        text = pathlib.Path(log).read_text(encoding="utf-8", errors="replace")
    except OSError:
        return []
    return [match.groups() for match in map(LINE.match, text.splitlines()) if match]


def collected(logs):
    """Of the sanitizers' tests the monkeys alone: the others repeat release tests with less."""
    found = {}
    release = lines_of(logs / "release-tests.log")
    foreign = "tests-under-ru_RU.UTF-8.log"
    monkeys = [line for line in lines_of(logs / f"sanitizer-{foreign}") if line[0] == "22"]
    for number, *line in release + monkeys:
        if line not in found.setdefault(number, []):
            found[number].append(line)
    failed = count = 0
    for russian in sorted(logs.glob(f"*-{foreign}")):
        match = re.search(r"(\d+) tests failed out of (\d+)", russian.read_text(errors="replace"))
        if match:
            failed += int(match[1])
            count += int(match[2])
    if count:
        found.setdefault("27", []).append(
            [str(count - failed), str(count), "FAIL" if failed else "PASS",
             "tests hold under ru_RU.UTF-8"])
    mutants = logs / "mutants.log"
    if mutants.exists():
        match = re.search(r"^MUTATION (\d+) of (\d+) killed \(([\d.]+) %",
                          mutants.read_text(errors="replace"), re.M)
        if match:
            killed, count, share = match.groups()
            found.setdefault("19", []).append(
                [share, "80", "PASS" if float(share) >= 80 and int(count) >= 100 else "FAIL",
                 f"% of the mutants killed, {killed} of {count}"])
    return found


def figure(line):
    value, limit, verdict, note = line
    limit = "" if limit == value else f" (limit {limit})"
    return f"{'**beyond:** ' if verdict != 'PASS' else ''}{value}{limit} {note}".replace("|", "\\|")


def figures(number, lines):
    if len(lines) < MANY:
        return "<br>".join(map(figure, lines))
    order = (lambda line: float(line[0])) if number in LEAST_IS_WORST else (
        lambda line: -float(line[0]))
    worst = min(lines, key=order)
    shown = [f"worst of {len(lines)}: {figure(worst)}"]
    shown += [figure(line) for line in lines if line[2] != "PASS" and line is not worst]
    return "<br>".join(shown)


def result(number, lines):
    if not lines:
        weaker = CHECKS[number][2] or ""
        return "not done" if weaker.startswith("not done") else "no figure"
    if all(line[2] == "PASS" for line in lines):
        return "weaker" if CHECKS[number][2] else "held"
    return "**beyond**"


def git(*arguments):
    folder = pathlib.Path(__file__).parent
    try:
        run = subprocess.run(["git", "-C", folder, *arguments], capture_output=True, text=True)
    except FileNotFoundError:  # a machine that only builds and tests needs no git
        return ""
    return run.stdout.strip() if run.returncode == 0 else ""


def processor():
    try:
        text = pathlib.Path("/proc/cpuinfo").read_text()
    except OSError:
        text = ""
    names = re.findall(r"^model name\s*: (.*)$", text, re.M)
    return f"{os.cpu_count()} × {names[0] if names else platform.machine()}"


def page(found):
    changed = [line for line in git("status", "--porcelain").splitlines()
               if not line.endswith("docs/reliability.md")]
    commit = (git("rev-parse", "--short=10", "HEAD") or "unknown") + (
        " with changes" if changed else "")
    counts = {}
    rows = []
    for number, (name, wanted, _) in CHECKS.items():
        lines = found.get(number, [])
        what = result(number, lines)
        counts[what.strip("*")] = counts.get(what.strip("*"), 0) + 1
        rows.append(f"| {int(number)} | {name} | {wanted} | {figures(number, lines) or '–'} | {what} |")
    told = ", ".join(f"{count} {what}" for what, count in counts.items())
    weaker = [f"* {int(number)}, {name[0].lower() + name[1:]}: {text}."
              for number, (name, _, text) in CHECKS.items() if text]
    return f"""# Reliability: 28 checks and today's figures

Made by `./workbench test --long` on {datetime.date.today().isoformat()}, commit {commit},
{processor()}, {platform.platform()}.

Every figure was printed by the test that performs the check. *Held*: as asked. *Weaker*: the check passes but
asks less, as listed below. *Beyond*: a figure is beyond its limit. Of the 28: {told}.

| # | check | asked | today | |
| --- | --- | --- | --- | --- |
{chr(10).join(rows)}

## Weaker than asked

{chr(10).join(weaker)}
"""


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 2
    found = collected(pathlib.Path(sys.argv[1]))
    if not found:
        print("no figures of any check in", sys.argv[1], file=sys.stderr)
        return 1
    out = pathlib.Path(sys.argv[2])
    out.parent.mkdir(exist_ok=True)
    out.write_text(page(found), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
