# SPDX-License-Identifier: GPL-3.0-or-later
"""How long the installed program takes from its start to the first painted window, warm: the quickest of
some starts, for whatever else the machine does only adds to it. With SPARKOUT_LONG alone, on a machine
that does nothing else; without it status 77. Called with cmake, the build folder and an example
project."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

cmake, build, example, *_ = sys.argv[1:]
ALLOWED_MS = 300
STARTS = 20
if "SPARKOUT_LONG" not in os.environ:
    print("with SPARKOUT_LONG alone")
    sys.exit(77)

with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name)
    subprocess.run([cmake, "--install", build, "--prefix", str(work / "usr"), "--component", "program"],
                   check=True, capture_output=True)
    home = work / "home"
    home.mkdir(mode=0o700)
    environment = {"HOME": str(home), "XDG_RUNTIME_DIR": str(home), "PATH": os.environ["PATH"],
                   "LC_ALL": "C.UTF-8", "QT_QPA_PLATFORM": "offscreen"}

    def start():
        begin = time.monotonic()
        with subprocess.Popen([str(work / "usr/bin/sparkout"), "--time-start", example], text=True,
                              stdout=subprocess.PIPE, env=environment, cwd=home) as program:
            said = program.stdout.readline()
            taken = 1000 * (time.monotonic() - begin)
        assert said == "painted\n" and program.returncode == 0, (said, program.returncode)
        return taken

    first = start()
    times = []
    while len(times) < 5 or (min(times) > ALLOWED_MS and len(times) < STARTS):
        times.append(start())
print(f"SPEED start to first painted window {min(times):.0f} ms, quickest of {len(times)}; "
      f"first after the installation {first:.0f} ms")
assert min(times) <= ALLOWED_MS, f"{min(times):.0f} ms, allowed: {ALLOWED_MS} ms"
