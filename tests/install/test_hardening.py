#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the linker notes in the programs, and whether it is true.

    test_hardening.py BUILD PROGRAM…

Each program says that it keeps to a shadow stack and has marked what may be jumped to, is position
independent, resolves all symbols before it runs and has no executable stack. Linked again, with the
linker asked, no object says less but the start files of the C library, and the program is not entered
through these.
"""
import pathlib
import re
import subprocess
import sys

BUILD, PROGRAMS = pathlib.Path(sys.argv[1]), [pathlib.Path(name) for name in sys.argv[2:]]
START_FILES = {"Scrt1.o", "crti.o", "crtn.o"}  # of libc6-dev in Debian 12
MARK = bytes.fromhex("f30f1efa")  # endbr64


def output(*command):
    return subprocess.run([str(word) for word in command], check=True, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, cwd=BUILD).stdout


def bytes_at(program, address):
    """The first bytes of the program at an address of its memory."""
    for line in output("readelf", "-lW", program).splitlines():
        fields = line.split()
        if fields and fields[0] == "LOAD":
            offset, begin, size = int(fields[1], 16), int(fields[2], 16), int(fields[4], 16)
            if begin <= address < begin + size:
                return program.read_bytes()[offset + address - begin:][:len(MARK)]
    raise AssertionError(f"{program}: nothing at {address:#x}")


def entries(program):
    found = {"entry": re.search(r"Entry point address:\s+(0x[0-9a-f]+)", output("readelf", "-hW", program)).group(1)}
    for kind in ("INIT", "FINI"):
        found[kind] = re.search(rf"\({kind}\)\s+(0x[0-9a-f]+)", output("readelf", "-dW", program)).group(1)
    return {name: int(address, 16) for name, address in found.items()}


def noted(program):
    notes = output("readelf", "-nW", program)
    assert re.search(r"x86 feature: .*\bIBT\b.*\bSHSTK\b", notes), f"{program}: {notes}"
    for name, address in entries(program).items():
        assert bytes_at(program, address) == MARK, f"{program}: {name} at {address:#x} is not marked"
    dynamic = output("readelf", "-dW", program)
    assert "BIND_NOW" in dynamic or "Flags: NOW" in dynamic, program
    segments = output("readelf", "-lW", program)
    assert "GNU_RELRO" in segments, program
    assert re.search(r"GNU_STACK.* RW ", segments), program
    assert "DYN" in output("readelf", "-hW", program), program


def objects_without_marks(program):
    """As the linker names them when the program is linked again, into nothing."""
    name = program.relative_to(BUILD)
    last = output("ninja", "-t", "commands", name).splitlines()[-1]
    command = last.replace(f"-o {name}", "-o /dev/null -Wl,-z,cet-report=warning")
    assert command != last, last
    for forced in ("-Wl,-z,ibt", "-Wl,-z,shstk"):  # else nothing is reported
        assert forced in command, command
        command = command.replace(forced, "")
    said = subprocess.run(command, shell=True, cwd=BUILD, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT).stdout
    return {pathlib.PurePath(found).name for found in re.findall(r"(\S+): warning: missing ", said)}


for program in PROGRAMS:
    noted(program)
    if (BUILD / "build.ninja").exists():
        lacking = objects_without_marks(program)
        assert lacking <= START_FILES, f"{program}: compiled without -fcf-protection: {sorted(lacking - START_FILES)}"
        print(f"{program.name}: IBT and SHSTK; without marks are {', '.join(sorted(lacking))} alone")
