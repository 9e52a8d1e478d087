#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Asks whether the tests notice one plausible slip of a programmer at a time.

    mutation.py [--build DIR] [--jobs N] [--check] [PATTERN...]

The slips are in mutants.txt, whose head says how they are written. All are compiled in at once behind
a switch, into copies: neither the sources nor the objects of the build are touched. Then the tests
run without any, and for each mutant those that shall notice it, until the first fails, crashes or
hangs. --check compares the list with the sources alone; a PATTERN takes the mutants whose number is
it or whose file or description holds it. Status 1 when fewer than 95 % of those not proved
equivalent are killed, or the tests fail without a mutant.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIST = pathlib.Path(__file__).resolve().with_name("mutants.txt")
LEAST_KILLED = 0.95
SWITCH = """// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdlib>
/// The number of the mutant that is at work, 0: none.
inline int sparkoutMutant() {
    static const int number = [] {
        const char* given = std::getenv("SPARKOUT_MUTANT");
        return given ? std::atoi(given) : 0;
    }();
    return number;
}
"""


def fail(text):
    print(f"mutation: {text}", file=sys.stderr)
    sys.exit(2)


class Mutant:
    def __init__(self, number, file, tests, note, line):
        self.number, self.file, self.tests, self.note, self.line = number, file, tests, note, line
        self.original, self.mutated, self.equivalent = [], [], []
        self.begin = self.end = 0  # of the original in its file
        self.result, self.by, self.seconds = "", "", 0.0

    def locate(self, text):
        """Finds the original, any run of white space as good as another; gives what is wrong."""
        snippet = " ".join(self.original)
        marked = "«" in snippet
        before, inner, after = (re.fullmatch("(.*?)«(.*)»(.*)", snippet).groups() if marked
                                else ("", snippet, ""))
        self.inner = inner

        def pattern(part):
            return r"\s+".join(re.escape(word) for word in re.split(r"\s+", part))

        found = list(re.finditer(f"({pattern(before)})({pattern(inner)})({pattern(after)})", text))
        if len(found) != 1:
            return f"stands {len(found)} times in {self.file}: {snippet}"
        self.begin, self.end = found[0].span(2)
        line = text[text.rfind("\n", 0, self.begin) + 1:self.begin]
        if re.sub(r"\\.", "", line).count('"') % 2:
            return f"stands within a text of {self.file}: {inner}"
        return ""

    def is_statement(self):
        return self.inner.endswith((";", "}"))


def read_list():
    """The mutants of mutants.txt; a blank line ends one."""
    mutants, file, tests, current, others = [], "", [], None, []
    for at, line in enumerate(LIST.read_text(encoding="utf-8").splitlines(), 1):
        mark, rest = line[:1], line[2:].strip()
        if not line.strip():
            current = None
        elif mark == "#":
            continue
        elif mark == "!":
            others.append(rest.split())
        elif mark == "=":
            if any(mutant.file == rest for mutant in mutants):
                fail(f"mutants.txt:{at}: {rest} has a heading above")
            file, current = rest, None
        elif mark == "@" and current is None:
            tests = rest.split()
        elif mark == "*":
            current = Mutant(len(mutants) + 1, file, tests, rest, at)
            mutants.append(current)
        elif current is None:
            fail(f"mutants.txt:{at}: outside of a mutant: {line}")
        elif mark == "@":
            current.tests = rest.split()
        elif mark == "-":
            current.original.append(rest)
        elif mark == "+":
            current.mutated.append(rest)
        elif mark == "~":
            current.equivalent.append(rest)
        else:
            fail(f"mutants.txt:{at}: cannot be read: {line}")
    for mutant in mutants:
        for prefix, *last in others:
            if mutant.file.startswith(prefix):
                mutant.tests = [*mutant.tests, *(t for t in last if t not in mutant.tests)]
    return mutants


def check_list(mutants):
    """Each original stands once in its file, and none inside another."""
    faults, texts = [], {}
    for mutant in mutants:
        path = ROOT / mutant.file
        if not path.is_file():
            faults.append(f"mutants.txt:{mutant.line}: there is no {mutant.file}")
            continue
        text = texts.setdefault(mutant.file, path.read_text(encoding="utf-8"))
        wrong = mutant.locate(text) if mutant.original else "without an original"
        if not wrong and not mutant.tests:
            wrong = "without a test"
        if wrong:
            faults.append(f"mutants.txt:{mutant.line}: {wrong}")
    located = sorted((m for m in mutants if m.end), key=lambda m: (m.file, m.begin, -m.end))
    for one, two in zip(located, located[1:]):
        same = (one.begin, one.end) == (two.begin, two.end)
        if one.file == two.file and two.begin < one.end and not same:
            faults.append(f"mutants.txt:{two.line}: overlaps with the mutant of line {one.line}")
    for fault in faults:
        print(fault, file=sys.stderr)
    return texts, not faults


def mutated_text(text, mutants, header):
    """The source with all its mutants behind the switch."""
    places = {}
    for mutant in mutants:
        places.setdefault((mutant.begin, mutant.end), []).append(mutant)
    for (begin, end), group in sorted(places.items(), reverse=True):
        original = text[begin:end]
        if group[0].is_statement():
            changed = "".join(f"if (sparkoutMutant() == {m.number}) {{ {' '.join(m.mutated)} }} else "
                              for m in group) + f"{{ {original} }}"
        else:
            changed = "".join(f"sparkoutMutant() == {m.number} ? ({' '.join(m.mutated)}) : "
                              for m in group) + f"({original})"
            changed = f"({changed})"
        text = text[:begin] + changed + text[end:]
    return f'#include "{header}"\n{text}'


class Build:
    """The build that is there, and beside it the same programs with the mutants in them."""

    def __init__(self, folder, scratch=ROOT / "build" / "mutation"):
        self.folder, self.scratch = folder, scratch
        if not (folder / "build.ninja").is_file():
            fail(f"{folder} is no build made with Ninja: ./workbench mutants makes one")

    def tests(self):
        """Command and surroundings of each test by its name."""
        shown = subprocess.run(["ctest", "--show-only=json-v1"], cwd=self.folder, text=True,
                               stdout=subprocess.PIPE, check=True).stdout
        found = {}
        for test in json.loads(shown)["tests"]:
            given = {p["name"]: p["value"] for p in test.get("properties", [])}
            surroundings = dict(e.split("=", 1) for e in given.get("ENVIRONMENT", []))
            found[test["name"]] = (test.get("command", []), surroundings,
                                   given.get("WORKING_DIRECTORY", str(self.folder)))
        return found

    def program_in(self, command):
        """The program of the build that a test's command runs, relative to the build."""
        for word in command:
            path = pathlib.Path(word)
            if path.is_absolute() and self.folder in path.parents:
                return str(path.relative_to(self.folder))
        return ""

    def put(self, name, text):
        """Writes a file of the scratch folder if it has changed."""
        path = self.scratch / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
        return path

    def make(self, programs, sources, jobs):
        """`programs` with the mutated `sources`; what has not changed since the last time stays."""
        ninja = ["ninja", "-C", str(self.folder)]
        if subprocess.run([*ninja, f"-j{jobs}", "--quiet", *programs]).returncode:
            fail("the build without mutants failed")
        shown = subprocess.run([*ninja, "-t", "commands", *programs], text=True, check=True,
                               stdout=subprocess.PIPE).stdout
        needed = set(shown.split())
        header = self.put("sparkout_mutant.h", SWITCH)
        copies = {}
        for file, (text, mutants) in sources.items():
            copies[str(ROOT / file)] = self.put(f"source/{file}", mutated_text(text, mutants, header))
        including = self.including([file for file in sources if file.endswith(".h")])
        commands = json.loads((self.folder / "compile_commands.json").read_text())
        compiles, objects = [], set()
        for entry in commands:
            source = pathlib.Path(entry["file"])
            unit, text = copies.get(str(source)), ""
            if source.suffix == ".cxx":  # several sources compiled as one
                text = source.read_text(encoding="utf-8")
                changed = re.sub(r'#include "([^"]+)"',
                                 lambda m: f'#include "{copies.get(m[1], m[1])}"', text)
                if changed != text:
                    unit = self.put(f"unity/{source.relative_to(self.folder)}", changed)
            words = shlex.split(entry["command"])
            out = words[words.index("-o") + 1]
            headers = including.get(out, [])
            if unit is None and headers:
                unit = source
            if unit is None or out not in needed:
                continue
            # A mutated header is found before the one it is a copy of.
            words[1:1] = [f"-I{self.scratch / 'source'}"] if headers else []
            words[words.index("-o") + 1] = str(self.scratch / out)
            words[words.index("-c") + 1] = str(unit)
            words.append("-w")
            objects.add(out)
            inputs = [unit, *(c for f, c in copies.items() if f in text or f in headers),
                      self.folder / out]
            if self.is_older(self.scratch / out, inputs):
                (self.scratch / out).parent.mkdir(parents=True, exist_ok=True)
                compiles.append(words)
        if not objects:
            fail("no object holds a mutated source")
        print(f"MUTATION {len(compiles)} of {len(objects)} objects compiled with mutants", flush=True)
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            if any(pool.map(lambda w: subprocess.run(w, cwd=self.folder).returncode, compiles)):
                fail("a mutant does not compile")
        # Archives and programs in the order of the build, with what was made anew in its place.
        for line in shown.splitlines():
            made = re.search(r"ar qc (\S+)", line) or re.search(r" -o (\S+)", line)
            if not made or " -c " in line or not ("/ar qc" in line or " -Wl," in line):
                continue
            words = line.split(" ")
            used = objects.intersection(words)
            if not used:
                continue
            line = " ".join(shlex.quote(str(self.scratch / w))
                            if w in objects or w == made[1] else w for w in words)
            objects.add(made[1])
            target = self.scratch / made[1]
            if not self.is_older(target, [self.scratch / w for w in used]
                                 + [self.folder / made[1]]):
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            if subprocess.run(line, shell=True, cwd=self.folder).returncode:
                fail(f"{made[1]} could not be linked")
        for program in programs:
            if program not in objects:
                fail(f"{program} holds none of the mutants")

    def including(self, headers):
        """The given headers that each object includes, by ninja's log of what it was made from."""
        found, wanted = {}, {str(ROOT / header) for header in headers}
        if not wanted:
            return found
        listed = subprocess.run(["ninja", "-C", str(self.folder), "-t", "deps"], text=True,
                                check=True, stdout=subprocess.PIPE).stdout
        for line in listed.splitlines():
            if line.startswith(" "):
                path = str((self.folder / line.strip()).resolve())
                if path in wanted:
                    found.setdefault(made, []).append(path)
            else:
                made = line.partition(":")[0]
        return found

    @staticmethod
    def is_older(target, inputs):
        return not target.exists() or any(
            i.exists() and i.stat().st_mtime > target.stat().st_mtime for i in inputs)


class Runner:
    def __init__(self, build, jobs):
        self.build, self.jobs, self.known = build, jobs, build.tests()
        self.limits = {}

    def unknown(self, mutants):
        return sorted({t for m in mutants for t in m.tests if t.split("::")[0] not in self.known})

    def programs(self, mutants):
        commands = [self.known[t.split("::")[0]][0] for m in mutants for t in m.tests]
        return sorted({self.build.program_in(c) for c in commands} - {""})

    def run(self, test, number, limit):
        """Whether the test passes, and how long it takes."""
        name, _, function = test.partition("::")
        command, surroundings, folder = self.known[name]
        program = self.build.program_in(command)
        at, instead = str(self.build.folder / program), str(self.build.scratch / program)
        words = [instead if word == at else word for word in command]
        words += [function] if function else []
        with tempfile.TemporaryDirectory(prefix="sparkout-mutant-") as home:
            env = {k: v for k, v in os.environ.items() if not k.startswith("XDG_")}
            env |= {"QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"} | surroundings
            env |= {"SPARKOUT_MUTANT": str(number), "HOME": home, "TMPDIR": home}
            os.chmod(home, 0o777)  # test_safe_file becomes another user
            begin = time.monotonic()
            log = pathlib.Path(home) / "log"
            with open(log, "wb") as out, subprocess.Popen(
                    words, cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=out,
                    stderr=subprocess.STDOUT, start_new_session=True) as process:
                try:
                    status = process.wait(limit)
                except subprocess.TimeoutExpired:
                    status = "hangs"
                try:
                    os.killpg(process.pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            seconds = time.monotonic() - begin
            failed = re.findall(rb"^FAIL!\s*:\s*[\w:]+::(\w+)\(|^CHECK (\w+) .* FAIL", log.read_bytes(),
                                re.MULTILINE)
            if status and not number:
                sys.stdout.write(log.read_text(errors="replace")[-4000:])
        how = ", ".join(sorted({(a or b).decode() for a, b in failed})[:2])
        return status == 0, seconds, how or (status if status == "hangs" else "crashes")

    def without_mutants(self, mutants):
        """All tests, to see that they pass, and how long each takes."""
        tests = sorted({t for m in mutants for t in m.tests})
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            results = list(pool.map(lambda t: self.run(t, 0, 1800), tests))
        for test, (passed, seconds, how) in zip(tests, results):
            self.limits[test] = 20 + 5 * seconds
            if not passed:
                print(f"MUTATION without a mutant {test} fails: {how}")
        print(f"MUTATION {len(tests)} tests without a mutant, {sum(r[1] for r in results):.0f} s",
              flush=True)
        return all(passed for passed, _, _ in results)

    def judge(self, mutant):
        mutant.result = "survived"
        for test in mutant.tests:
            passed, seconds, how = self.run(test, mutant.number, self.limits[test])
            mutant.seconds += seconds
            if not passed:
                mutant.result, mutant.by = "killed", f"{test.split('::')[0]}: {how}"
                break
        if mutant.equivalent:
            mutant.result = "equivalent" if mutant.result == "survived" else "DIFFERS"
        print(f"MUTANT {mutant.number:3} {mutant.result:10} {mutant.seconds:6.1f} s  {mutant.file}: "
              f"{mutant.note}{'  [' + mutant.by + ']' if mutant.by else ''}", flush=True)


def part(text):
    """(K, N) of "K/N": which of N parts."""
    first, of = (int(word) for word in text.split("/"))
    if not 0 <= first < of:
        raise ValueError(text)
    return first, of


def main():
    options = argparse.ArgumentParser(description="Asks whether the tests notice single slips.")
    options.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    options.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options.add_argument("--check", action="store_true", help="compare the list with the sources only")
    options.add_argument("--fresh", action="store_true", help="compile everything anew")
    options.add_argument("--part", metavar="K/N", type=part, default=(0, 1),
                         help="every Nth mutant alone, from the one numbered K on")
    options.add_argument("patterns", nargs="*", metavar="PATTERN")
    given = options.parse_args()
    mutants = read_list()
    texts, right = check_list(mutants)
    print(f"MUTATION {len(mutants)} mutants in {len(texts)} files, "
          f"{sum(bool(m.equivalent) for m in mutants)} of them proved equivalent", flush=True)
    if not right:
        return 2
    if given.check:
        return 0
    first, step = given.part
    chosen = [m for m in mutants if m.number % step == first and (not given.patterns
              or any(p == str(m.number) or not p.isdigit() and p in f"{m.file} {m.note}"
                     for p in given.patterns))]
    if not chosen:
        fail(f"no mutant matches {' '.join(given.patterns)}")
    build = Build(given.build.resolve())
    if given.fresh:
        shutil.rmtree(build.scratch, ignore_errors=True)
    runner = Runner(build, given.jobs)
    if runner.unknown(mutants):
        fail(f"no such tests: {' '.join(runner.unknown(mutants))}")
    sources = {f: (t, [m for m in mutants if m.file == f]) for f, t in texts.items()}
    build.make(runner.programs(chosen), sources, given.jobs)
    begin = time.monotonic()
    if not runner.without_mutants(chosen):
        return 1
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        list(pool.map(runner.judge, chosen))
    count = {r: sum(m.result == r for m in chosen)
             for r in ("killed", "survived", "equivalent", "DIFFERS")}
    judged = count["killed"] + count["survived"]
    share = count["killed"] / judged if judged else 1.0
    for mutant in chosen:
        if mutant.result == "survived":
            print(f"SURVIVED {mutant.number} {mutant.file}: {mutant.note}")
        elif mutant.result == "DIFFERS":
            print(f"NOT EQUIVALENT {mutant.number} {mutant.file}: {mutant.note}  [{mutant.by}]")
    print(f"MUTATION {count['killed']} of {judged} killed ({100 * share:.1f} %, at least "
          f"{100 * LEAST_KILLED:.0f} % asked), {count['survived']} survived, "
          f"{count['equivalent']} equivalent, {time.monotonic() - begin:.0f} s")
    return 0 if share >= LEAST_KILLED and not count["DIFFERS"] else 1


if __name__ == "__main__":
    sys.exit(main())
