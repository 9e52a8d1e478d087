#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens hostile files in the real window under strace: nothing they name is opened, and no socket made.

    traced_opening.py SPARKOUT SPARKOUT-CLI EXAMPLES LESSONS [FILE…]

Packs, lessons, works, projects and settings are made here; each FILE, a pack, is opened besides. Before
each scene stand a file, a FIFO, a drawing that names itself and a server beside it, which the texts
and pictures name in every way there is. One line a scene: TRACE scene, what was opened, PASS or FAIL.
"""
import base64
import collections
import gzip
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import zlib

SPARKOUT, CLI, EXAMPLES, LESSONS = map(os.path.abspath, sys.argv[1:5])
GIVEN = [os.path.abspath(name) for name in sys.argv[5:]]
# The system, the program's own folder and what the scene gives it; the rest is nobody's business.
SYSTEM = ("/usr/", "/lib/", "/lib64/", "/etc/", "/proc/", "/sys/devices/system/", "/dev/null/",
          "/dev/urandom/", "/dev/shm/", "/var/cache/fontconfig/", "/var/lib/dbus/machine-id/")
PATIENCE_S = 60
LOOKS, IDLE_LOOKS = 14, 5  # every 50 ms; computing has none idle, a cursor that blinks beside load has some
failures = 0


def drawing(inside):
    return ('<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
            f'width="400" height="100" viewBox="0 0 400 100">{inside}</svg>').encode()


class Scene:
    """A folder with what nobody should touch, and a home of its own."""

    def __init__(self, work, name):
        self.name = name
        self.folder = work / re.sub(r"\W+", "-", name)
        self.home = self.folder / "home"
        self.canary = self.folder / "canary"
        for folder in (self.home, self.canary, self.home / "config/sparkout"):
            folder.mkdir(parents=True)
        (self.canary / "secret.png").write_bytes(PNG)
        (self.canary / "secret.css").write_text("p { color: red }")
        (self.canary / "self.svg").write_bytes(drawing('<image xlink:href="canary/self.svg" width="40" height="40"/>'))
        os.mkfifo(self.canary / "fifo")
        self.home.chmod(0o700)  # else Qt asks the system for the user's name, by a socket

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else json.dumps(content).encode())
        return path

    def environment(self):
        kept = {key: value for key, value in os.environ.items()
                if key in ("PATH", "LD_LIBRARY_PATH", "LC_ALL", "LANG", "LOCPATH")}
        return dict(kept, HOME=str(self.home), XDG_CONFIG_HOME=str(self.home / "config"),
                    XDG_STATE_HOME=str(self.home / "state"), XDG_CACHE_HOME=str(self.home / "cache"),
                    XDG_DATA_HOME=str(self.home / "data"), XDG_RUNTIME_DIR=str(self.home),
                    QT_QPA_PLATFORM="offscreen", TMPDIR=str(self.home))


def is_idle(pid):
    """Whether all threads of a process wait for something."""
    try:
        return all(task.joinpath("stat").read_text().rsplit(")", 1)[1].split()[0] == "S"
                   for task in pathlib.Path(f"/proc/{pid}/task").iterdir())
    except (OSError, IndexError):
        return False


def traced_child(pid):
    children = pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    return int(children[0]) if children else None


def wait_until_quiet(tracer, log, path):
    """Until the file was opened and the program has had nothing to do for a while, or, without a file,
    until it has ended; what went wrong else."""
    begin = time.monotonic()
    opens = re.compile(rb'open(at)?\([^"]*"' + re.escape(str(path).encode()) + rb'"')
    child, opened, looks = None, False, collections.deque(maxlen=LOOKS)
    while time.monotonic() - begin < PATIENCE_S:
        time.sleep(0.05)
        if tracer.poll() is not None:
            return f"it ended by itself with {tracer.returncode}" if path else None
        child = child or traced_child(tracer.pid)
        opened = opened or opens.search(log.read_bytes()) is not None
        if opened and child:
            looks.append(is_idle(child))
        if len(looks) == looks.maxlen and sum(looks) >= IDLE_LOOKS:
            return None
    return "it is still busy" if opened or not path else "it did not open the file"


def peak_memory_mb(pid):
    try:
        status = pathlib.Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return 0
    found = re.search(r"VmHWM:\s+(\d+)", status)
    return int(found.group(1)) // 1024 if found else 0


def trace(scene, arguments, path):
    """Runs the program until it has opened a file, or, without one, to its end."""
    global failures
    log = scene.folder / "strace.log"
    log.touch()
    begin = time.monotonic()
    tracer = subprocess.Popen(
        ["strace", "-f", "-qq", "-y", "-s", "300", "-o", str(log), "-e", "signal=none", "-e",
         "trace=open,openat,openat2,creat,socket,connect,bind,sendto,sendmsg,execve", SPARKOUT, *map(str, arguments)],
        cwd=scene.folder, env=scene.environment(), stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    fault = wait_until_quiet(tracer, log, path)
    child = traced_child(tracer.pid) if tracer.poll() is None else None
    memory_mb = peak_memory_mb(child) if child else 0
    if child:
        os.kill(child, signal.SIGKILL)
    said = tracer.communicate(timeout=30)[1].decode(errors="replace")
    faults = [fault] if fault else []
    if path is None and tracer.returncode != 0:
        faults.append(f"it ended with {tracer.returncode}: {said.strip()[:200]}")
    if memory_mb > 600:
        faults.append(f"{memory_mb} MB of memory")
    own = (str(scene.home) + "/", os.path.dirname(SPARKOUT) + "/")
    given = {str(value) for value in (path, *arguments)}
    if path:
        given.add(str(path.with_name(f".~{path.name}.lock")))
    opened, outside, sockets = set(), set(), set()
    for line in log.read_text(errors="replace").splitlines():
        call = re.match(r"\d+\s+(\w+)\(", line)
        if not call:
            continue
        if call.group(1) in ("socket", "connect", "bind", "sendto", "sendmsg"):
            sockets.add(line.split(None, 1)[1][:120])
            continue
        below = re.match(r"\d+\s+\w+\((?:AT_FDCWD|\d+)<([^>]*)>", line)
        name = re.search(r'"((?:[^"\\]|\\.)*)"', line)
        name = os.path.normpath(os.path.join(below.group(1) if below else scene.folder, name.group(1)))
        if call.group(1) == "execve" and name != SPARKOUT:
            outside.add("execve " + name)
        opened.add(name)
        if name in given or (name + "/").startswith(own + SYSTEM):
            continue
        if line.rstrip().endswith("ENOENT (No such file or directory)") \
                and not name.startswith(str(scene.canary)):
            continue
        outside.add(name)
    faults += [f"opened {name}" for name in sorted(outside)] + sorted(sockets)
    failures += bool(faults)
    print(f"TRACE {scene.name}: {len(opened)} files opened, {len(outside)} that are not the program's own, "
          f"{len(sockets)} socket calls, {memory_mb} MB, {time.monotonic() - begin:.1f} s: "
          f"{'FAIL' if faults else 'PASS'}", flush=True)
    for text in faults:
        print("  " + text, flush=True)
    return said


def png_chunk(kind, content):
    return len(content).to_bytes(4, "big") + kind + content + zlib.crc32(kind + content).to_bytes(4, "big")


PNG = (b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", (8).to_bytes(4, "big") * 2 + b"\x08\x02\0\0\0")
       + png_chunk(b"IDAT", zlib.compress((b"\0" + b"\x20\x60\xa0" * 8) * 8)) + png_chunk(b"IEND", b""))


def pack(logo, **more):
    text = base64.b64encode(logo).decode()
    lines = [text[at:at + 4096] for at in range(0, len(text), 4096)]
    return {"format": "sparkout-pack", "version": 1, "title": "hostile", **more,
            "company": {"name": "ACME", "logo": lines}}


def markups(port):
    """Every way in which a text with markup names a file."""
    there = ["canary/secret.png", "{folder}/canary/secret.png", "file://{folder}/canary/secret.png",
             "canary/fifo", "file://{folder}/canary/fifo", f"http://127.0.0.1:{port}/a.png",
             f"//127.0.0.1:{port}/a.png"]
    ways = ['<img src="{0}">', '<a href="{0}">a</a>', '<link rel="stylesheet" href="{0}">',
            '<style>@import url("{0}"); p {{ background-image: url("{0}") }}</style><p>x</p>',
            '<p style="background-image: url({0})">x</p>', '<table background="{0}"><tr><td background="{0}">x</td></tr></table>',
            '<body background="{0}">x</body>', '<ul style="list-style-image: url({0})"><li>x</li></ul>',
            '<object data="{0}"></object>', '<qt><img src="{0}"/></qt>']
    return "".join(way.format(name) for way in ways for name in there)


def short(scene, most=190):
    """For texts that are bounded: one way."""
    return f'<qt><img src="canary/secret.png"><img src="{scene.canary}/fifo">'[:most]


def project_with(text):
    project = json.loads(pathlib.Path(EXAMPLES, "wheel-sharp.sparkout").read_text(encoding="utf-8"))
    for key in ("title", "author", "notes"):
        project[key] = text
    project["machine"]["name"] = text
    return project


def run_scenes(work, port):
    logos = {"drawing that names a picture": drawing('<image xlink:href="canary/secret.png" width="40" height="40"/>'),
             "drawing that names a FIFO": drawing('<image xlink:href="canary/fifo" width="40" height="40"/>'),
             "drawing that names itself": drawing('<image xlink:href="canary/self.svg" width="40" height="40"/>'),
             "drawing that takes a minute": drawing(
                 '<path fill="none" stroke="black" stroke-width="5" stroke-dasharray="0.01 0.01" d="M0 0'
                 + "".join(f" L{400 * (x % 2)} {x % 100}" for x in range(30_000)) + '"/>'),
             "packed drawing": gzip.compress(drawing('<image xlink:href="canary/fifo" width="40" height="40"/>')),
             "PNG of terabytes": PNG.replace((8).to_bytes(4, "big") * 2, b"\x7f\xff\xff\xff" * 2)}
    for name, logo in logos.items():
        scene = Scene(work, "pack, logo: " + name)
        path = scene.file("hostile.sparkout-pack", pack(logo))
        trace(scene, [path], path)
    for given in GIVEN:
        scene = Scene(work, "pack " + os.path.basename(given))
        path = scene.folder / os.path.basename(given)
        shutil.copy(given, path)
        trace(scene, [path], path)

    lesson = json.loads(pathlib.Path(LESSONS, "02-actual-feed.sparkout-lesson").read_text(encoding="utf-8"))
    scene = Scene(work, "pack, texts")
    text = short(scene)
    poisoned = dict(lesson, title={"en": text, "ru": text})
    path = scene.file("texts.sparkout-pack", dict(
        pack(PNG, note=markups(port).replace("{folder}", str(scene.folder))[:3900],
             lessons={"a.sparkout-lesson": poisoned}), title=text))
    trace(scene, [path], path)

    scene = Scene(work, "lesson, all markup in its texts")
    whole = markups(port).replace("{folder}", str(scene.folder))
    path = scene.file("texts.sparkout-lesson", dict(lesson, aim={"en": whole, "ru": whole},
                                                    theory={"en": whole, "ru": whole}))
    trace(scene, [path], path)

    scene = Scene(work, "work, names and answers")
    text = short(scene, 90)
    group = scene.file("group.csv", "name;group\nA;B\n".encode())
    subprocess.run([CLI, "course", "variants", f"{LESSONS}/02-actual-feed.sparkout-lesson", "--group", group, "--seed", "1", "-d",
                    scene.folder / "works"], check=True, stdout=subprocess.DEVNULL)
    made = next((scene.folder / "works").glob("*.sparkout-work"))
    student = json.loads(made.read_text(encoding="utf-8"))
    student.update(name=text, group=text)
    path = scene.file("hostile.sparkout-work", student)
    trace(scene, [path], path)

    scene = Scene(work, "project, title, author, notes and names")
    path = scene.file("hostile.sparkout", project_with(short(scene)))
    trace(scene, [path], path)

    for name, logo in (("names a FIFO", logos["drawing that names a FIFO"]),
                       ("names itself", logos["drawing that names itself"])):
        scene = Scene(work, "settings, logo: drawing that " + name)
        settings = {"company": {"name": "ACME", "logo": base64.b64encode(logo).decode()}}
        scene.file("home/config/sparkout/settings.json", settings)
        project = scene.file("part.sparkout", project_with(short(scene)))
        said = trace(scene, ["--report", "operation-card", project, "-o", scene.home / "written.pdf"], None)
        if "rsvg-convert" not in said:
            check_failed("the refused logo of the settings was not reported: " + said)


def check_failed(text):
    global failures
    failures += 1
    print("  FAIL " + text, flush=True)


def main():
    if shutil.which("strace") is None:
        print("strace is not installed (see packages.txt, test)")
        return 1
    with tempfile.TemporaryDirectory(prefix="sparkout-trace-") as name, socket.socket() as server:
        server.bind(("127.0.0.1", 0))
        server.listen()
        server.setblocking(False)
        run_scenes(pathlib.Path(name).resolve(), server.getsockname()[1])
        try:
            server.accept()
            check_failed("the server beside was called")
        except BlockingIOError:
            pass
    return 1 if failures else 0


sys.exit(main())
