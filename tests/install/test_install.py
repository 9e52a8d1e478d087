# SPDX-License-Identifier: GPL-3.0-or-later
"""The core as a library: installed into an empty folder, found there by CMake, built against from
outside the tree, with the numbers of the command line.

Called with cmake, the build folder, sparkout-cli and the folder of the examples. After --shared, with
the source folder in place of the build folder, the libraries are built as shared ones first, which
takes minutes: with SPARKOUT_LONG alone, else status 77."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

shared = sys.argv[1] == "--shared"
cmake, build, cli, examples = sys.argv[1 + shared:]
if shared and "SPARKOUT_LONG" not in os.environ:
    print("with SPARKOUT_LONG alone")
    sys.exit(77)
here = pathlib.Path(__file__).parent
files = sorted(str(file) for file in pathlib.Path(examples).glob("*.sparkout"))


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def stated(*arguments):
    done = subprocess.run([cli, *arguments, "--json"], capture_output=True, text=True, check=False)
    return json.loads(done.stdout)


with tempfile.TemporaryDirectory() as folder:
    if shared:
        source, build = build, str(pathlib.Path(folder) / "build")
        run(cmake, "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
            "-DBUILD_SHARED_LIBS=ON", "-DBUILD_TESTING=OFF")
        run(cmake, "--build", build, "--target", "sparkout_engine", "sparkout_search",
            "sparkout-cli")
        cli = str(pathlib.Path(build) / "app" / "sparkout-cli")
    prefix, outside = pathlib.Path(folder) / "local usr", pathlib.Path(folder) / "out side"
    run(cmake, "--install", build, "--prefix", str(prefix), "--component", "library")
    outside.mkdir()
    shutil.copy(here / "consumer.cmake", outside / "CMakeLists.txt")
    for source in ("main.cpp", "search.cpp"):
        shutil.copy(here / source, outside)
    run(cmake, "-S", str(outside), "-B", str(outside / "build"), f"-DCMAKE_PREFIX_PATH={prefix}",
        "-DCMAKE_BUILD_TYPE=Release", "-G", "Ninja")
    run(cmake, "--build", str(outside / "build"))

    lines = run(str(outside / "build" / "simulate"), *files).splitlines()
    assert len(lines) == len(files) > 5, lines
    for file, line in zip(files, lines):
        minutes, holds = line.removeprefix(file).split()
        cycle = stated("simulate", file)
        assert float(minutes) == cycle["cycle_time_min"], (line, cycle["cycle_time_min"])
        assert (holds == "1") == all(each["ok"] for each in cycle["constraints"]), line

    linked = run("ldd", str(outside / "build" / "simulate"))
    assert "nlopt" not in linked, linked
    assert ("libsparkout_engine.so" in linked) == shared, linked

    optimal = str(pathlib.Path(examples) / "shaft-30h6-optimal.sparkout")
    found = float(run(str(outside / "build" / "search"), optimal))
    assert found == stated("optimize", optimal)["cycle_time_min"], found
print(f"installed, found, built against; {len(files)} cycles and a search as the command line has them")
