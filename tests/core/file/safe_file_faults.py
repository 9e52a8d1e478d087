#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks the safe writer from outside: failing system calls, kill -9, a full disk.

    safe_file_faults.py PROBE [--long | --calls]

PROBE is the program of safe_file_probe.cpp. One line a check: CHECK nn value limit PASS|FAIL|SKIP.
--calls looks at the calls of single saves alone: what is synced and closed, and a second save.
As root everything happens on a private tmpfs and as the user nobody; the full disk needs the right
to mount a tmpfs (root, or user namespaces) and is skipped without it.
"""
import collections
import ctypes
import errno
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

QUICK = os.environ.get("SPARKOUT_QUICK") == "1"  # the sanitizers see nothing of a kill
LONG = "--long" in sys.argv or os.environ.get("SPARKOUT_LONG") == "1"
ERRORS = (["EIO", "ENOSPC", "EDQUOT", "EROFS", "EACCES", "EINTR"] if LONG else
          ["EIO"] if QUICK else ["EIO", "ENOSPC", "EINTR"])
LEAST_HITS = 60 if QUICK else 120
# A failure of these is a failure of the save. (renameat2 is the exchange, which may be refused.)
TELLING = {"write", "fsync", "fchmod", "rename", "renameat", "pread64"}
TMP = re.compile(r"\.sparkout-[0-9a-f]{16}-[0-9a-f]{16}\.tmp$")
# LeakSanitizer cannot run under strace.
ENV = dict(os.environ, ASAN_OPTIONS="detect_leaks=0", LC_ALL="C")
failures = 0


def content(size, seed):
    """The same bytes as content() in safe_file_probe.cpp."""
    head, unit = f"{seed} {size}\n".encode(), f"{seed},".encode()
    return (head + unit * (size // len(unit) + 1))[:size]


started = time.monotonic()


def check(number, value, limit, passed, note):
    global failures, started
    failures += not passed
    print(f"CHECK {number} {value} {limit} {'PASS' if passed else 'FAIL'}  {note}, "
          f"{time.monotonic() - started:.0f} s", flush=True)
    started = time.monotonic()


def run(*command, text=None):
    return subprocess.run([str(c) for c in command], env=ENV, text=True, input=text,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60)


def leftovers(folder):
    return [name for name in os.listdir(folder) if TMP.match(name)]


def leftover_name(target):
    """A temporary name as safe_file.cpp makes it: FNV-1a of the target's name."""
    value = 0xcbf29ce484222325
    for byte in target.encode():
        value = (value ^ byte) * 0x100000001b3 % 2**64
    return f".sparkout-{value:016x}-{1:016x}.tmp"


LEFTOVER = leftover_name("part.sparkout")


class Scene:
    """A folder with the state before a save; the same for every injection."""

    def __init__(self, name, size, old=None, backup=False, link=False, leftover=False):
        self.name, self.size, self.old = name, size, old
        self.backup, self.link, self.leftover = backup, link, leftover
        self.folder = WORK / "scene"
        self.file = self.folder / "part.sparkout"
        self.path = self.folder / "link" if link else self.file

    def prepare(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        if self.old is not None:
            self.file.write_bytes(content(self.old, "old"))
            self.file.chmod(0o640)
        if self.backup:
            (self.folder / "part.sparkout.bak").write_bytes(content(50, "older"))
        if self.link:
            self.path.symlink_to("part.sparkout")
        if self.leftover:
            (self.folder / LEFTOVER).write_bytes(b"half")

    def command(self):
        return [PROBE, "save", self.path, self.size, "new"] + ["--backup"] * self.backup

    def state(self):
        """What stands at the name: old, new, or a description of the damage."""
        if not self.file.exists():
            return "old" if self.old is None else "gone"
        data = self.file.read_bytes()
        if self.old is not None and data == content(self.old, "old"):
            return "old"
        return "new" if data == content(self.size, "new") else f"torn, {len(data)} bytes"

    def backup_state(self):
        """The backup is never torn either: the one before or the old file."""
        if not self.backup:
            return "whole"
        bak = self.folder / "part.sparkout.bak"
        data = bak.read_bytes() if bak.exists() else b""
        return "whole" if data in (content(50, "older"), content(self.old, "old")) else "torn"

    def fault(self, reported):
        """Empty when the file and the reported result agree."""
        state = self.state()
        if reported.startswith("ok"):
            expected = "new"
        elif reported.startswith("error"):
            expected = "new" if "replaced=1" in reported else "old"
        else:
            return f"no result: {reported!r}"
        if "error backup" in reported and "replaced=1" in reported:
            return "the failed backup was not undone"
        if state != expected:
            return f"reported {reported!r}, the file is {state}"
        if self.backup_state() != "whole":
            return "the backup is torn"
        if self.link and not self.path.is_symlink():
            return "the link was replaced"
        if state == "new" and self.old is not None and self.file.stat().st_mode & 0o777 != 0o640:
            return "the mode was not kept"
        return ""


def scenes():
    return [
        Scene("new file", 300),
        Scene("old file", 300, old=200),
        Scene("large file", 200_000, old=150_000),
        Scene("backup", 300, old=200, backup=True),
        Scene("link", 300, old=200, link=True),
        Scene("leftover", 300, old=200, leftover=True),
    ]


def calls_of_save(scene):
    """System calls of one save: name -> (calls before it, calls in it)."""
    scene.prepare()
    log = WORK / "strace.log"
    done = run("strace", "-f", "-o", log, "-e", "trace=%file,%desc,getrandom", *scene.command())
    if done.returncode != 0:
        raise RuntimeError(f"strace does not work here: {done.stderr.strip()}")
    before, inside, where = collections.Counter(), collections.Counter(), "before"
    for line in log.read_text(errors="replace").splitlines():
        name = re.match(r"\d+ +(\w+)\(", line)
        if "/sparkout-probe-end" in line:
            break
        if "/sparkout-probe-begin" in line:
            where = "inside"
        elif name and name[1] not in ("mmap", "mmap2", "brk"):
            (before if where == "before" else inside)[name[1]] += 1
    return {name: (before[name], count) for name, count in inside.items()}


def injected(scene, *actions):
    """Runs the save with faults; gives its output and whether the faults hit."""
    scene.prepare()
    log = WORK / "strace.log"
    rules = [word for action in actions for word in ("-e", "inject=" + action)]
    traced = ",".join(action.split(":")[0] for action in actions)
    done = run("strace", "-f", "-o", log, "-e", "trace=" + traced, *rules, *scene.command())
    trace = log.read_text(errors="replace")
    return done.stdout, trace.count("(INJECTED)") + trace.count("(DELAYED)"), trace


def note_faults(faults):
    for fault in faults[:10]:
        print("  " + fault)


def check_errors():
    hits, faults, steps = 0, [], collections.Counter()
    for scene in scenes():
        for call, (before, count) in calls_of_save(scene).items():
            plan = [(k, f"error={e}") for k in range(1, count + 1) for e in ERRORS]
            if call == "write":  # the disk swallows bytes: written short, and a lie about it
                plan += [(k, f"retval={n}") for k in range(1, count + 1) for n in (0, 1, scene.size)]
            for k, action in plan:
                output, hit, _ = injected(scene, f"{call}:{action}:when={before + k}")
                hits += hit
                fault = scene.fault(output) or ("leftover" if leftovers(scene.folder) and not
                                                scene.leftover else "")
                if call in TELLING and not action.endswith("EINTR") and output.startswith("ok"):
                    fault = "reported ok"
                if not hit:
                    fault = "the injection did not hit"
                steps[output.split()[1] if output.startswith("error") else "ok"] += 1
                if fault:
                    faults.append(f"{scene.name}, {call} {k} {action}: {fault}")
    note_faults(faults)
    told = ", ".join(f"{step} {count}" for step, count in sorted(steps.items()))
    check("01", hits, LEAST_HITS, hits >= LEAST_HITS and not faults,
          f"injected faults that hit; {len(faults)} violations, reported: {told}")


class Call:
    """A system call of a save: its name, its number among those of its name, and what it is about."""

    def __init__(self, name, number, text):
        self.name, self.number, self.text = name, number, text

    def is_of(self, name, path):
        """Whether it is this call of a descriptor of the path, which strace -y names."""
        return self.name == name and re.match(rf"\d+<{path}>\)", self.text) is not None


def calls_in_order(scene):
    """The calls of one save that succeed, in their order."""
    scene.prepare()
    log = WORK / "strace.log"
    run("strace", "-y", "-f", "-o", log, "-e", "trace=%file,%desc", *scene.command())
    counts, calls, inside = collections.Counter(), [], False
    for line in log.read_text(errors="replace").splitlines():
        found = re.match(r"\d+ +(\w+)\((.*)", line)
        if "/sparkout-probe-end" in line:
            break
        if "/sparkout-probe-begin" in line:
            inside = True
        elif found:
            counts[found[1]] += 1
            if inside and not re.search(r"= -1 ", line):
                calls.append(Call(found[1], counts[found[1]], found[2]))
    return calls


def check_syncs_and_closes():
    """The bytes are on the disk and their file is closed before the name is theirs, and the folder is
    on the disk behind it. A close that fails, as a network file system reports a write, is told."""
    faults, found = [], 0
    temporary, folder = r"[^>]*/\.sparkout-[^>]*\.tmp", re.escape(str(WORK / "scene"))
    for scene in scenes():
        calls = calls_in_order(scene)
        places = {"write": [], "fsync": [], "close": [], "folder": [], "rename": []}
        for at, call in enumerate(calls):
            for name in ("write", "fsync", "close"):
                if call.is_of(name, temporary) or name == "write" and re.match(
                        rf"\d+<{temporary}>, ", call.text) and call.name == name:
                    places[name].append(at)
            if call.is_of("fsync", folder):
                places["folder"].append(at)
            if call.name.startswith("rename"):
                places["rename"].append(at)
        first, last = min(places["rename"]), max(places["rename"])
        syncs = [at for at in places["fsync"] if max(places["write"]) < at < first]
        closes = [at for at in places["close"] if max(places["write"]) < at < first]
        found += len(syncs) + len(closes) + len(places["folder"])
        if not syncs:
            faults.append(f"{scene.name}: the file is not synced before it gets its name")
        if not any(at > last for at in places["folder"]):
            faults.append(f"{scene.name}: the folder is not synced behind the rename")
        if not closes:
            faults.append(f"{scene.name}: no close before the file gets its name")
        for at in closes:
            output, hit, _ = injected(scene, f"close:error=EIO:when={calls[at].number}")
            if not hit or not output.startswith(f"error close {errno.EIO}"):
                faults.append(f"{scene.name}, failed close: reported {output!r}")
            elif scene.fault(output):
                faults.append(f"{scene.name}, failed close: {scene.fault(output)}")
    note_faults(faults)
    check("01a", found, 3 * len(scenes()), found >= 3 * len(scenes()) and not faults,
          f"syncs of file and folder and closes in {len(scenes())} saves; {len(faults)} violations")


def check_exchange_beside_another_save():
    """While a save has the new file in place and the old one still under a temporary name, another
    save begins, and clears up: the old file shall be the backup all the same."""
    scene = Scene("exchange", 300, old=200, backup=True)
    fault = "the saves never met"
    for seconds in (0.5, 2, 8):  # on a busy machine the second save starts late
        scene.prepare()
        rule = f"inject=renameat:delay_enter={int(seconds * 1e6)}:when=1"
        with subprocess.Popen(["strace", "-f", "-o", "/dev/null", "-e", "trace=renameat", "-e", rule,
                               *[str(c) for c in scene.command()]], env=ENV, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as first:
            while scene.state() != "new" and first.poll() is None:
                time.sleep(0.005)
            second = run(PROBE, "save", scene.path, 400, "newer").stdout
            met = first.poll() is None
            told = first.communicate(timeout=60)[0]
        if not met:
            continue
        backup = (scene.folder / "part.sparkout.bak").read_bytes()
        fault = ("" if told.startswith("ok") and second.startswith("ok")
                 and scene.file.read_bytes() == content(400, "newer")
                 and backup == content(200, "old") and not leftovers(scene.folder)
                 else f"reported {told!r} and {second!r}, the backup is {backup[:12]!r}, "
                      f"leftovers {leftovers(scene.folder)}")
        break
    note_faults([fault] if fault else [])
    check("01b", int(not fault), 1, not fault, "a save during the exchange of another one")


def check_kill_at_each_call():
    hits, faults = 0, []
    for scene in scenes():
        for call, (before, count) in calls_of_save(scene).items():
            for k in range(1, count + 1):
                _, _, trace = injected(scene, f"{call}:signal=KILL:when={before + k}")
                hits += "killed by SIGKILL" in trace
                state, left = scene.state(), leftovers(scene.folder)
                if state not in ("old", "new"):
                    faults.append(f"{scene.name}, killed at {call} {k}: {state}")
                if scene.backup_state() != "whole":
                    faults.append(f"{scene.name}, killed at {call} {k}: the backup is torn")
                if len(left) > 1 + scene.leftover:
                    faults.append(f"{scene.name}, killed at {call} {k}: {len(left)} leftovers")
                if not run(*scene.command()).stdout.startswith("ok") or leftovers(scene.folder):
                    faults.append(f"{scene.name}, killed at {call} {k}: not tidied by the next save")
    note_faults(faults)
    check("02a", hits, 60, hits >= 60 and not faults,
          f"kills, one at each system call of a save; {len(faults)} violations")


def check_random_kills(kills):
    folder = WORK / "kills"
    folder.mkdir()
    file, faults, saves, most = folder / "part.sparkout", [], 0, 0
    chance = random.Random(1)
    for turn in range(kills):
        size = (300, 20_000, 200_000)[turn % 3]
        command = [str(PROBE), "loop", str(file), str(size)] + ["--backup"] * (turn % 2)
        file.write_bytes(content(size, "0"))
        # The first kills come while the program still starts, the others while it saves.
        with subprocess.Popen(command, env=ENV, text=True, stdout=subprocess.PIPE) as loop:
            if turn % 10:
                loop.stdout.readline()
            time.sleep(chance.uniform(0, 0.01))
            loop.kill()
            told = loop.stdout.read().split()
        last = int(told[-1]) if told else int(turn % 10 > 0)
        data = file.read_bytes() if file.exists() else b""
        seed = data.split(b" ")[0].decode(errors="replace")
        # The pipe may lose the line of a save that was already done.
        if data != content(size, seed) or int(seed) not in (last, last + 1):
            faults.append(f"kill {turn}: told {last}, the file holds {seed[:20]!r}, {len(data)} bytes")
        bak = folder / "part.sparkout.bak"
        if turn % 2 and bak.exists() and bak.read_bytes() != content(
                size, bak.read_bytes().split(b" ")[0].decode(errors="replace")):
            faults.append(f"kill {turn}: the backup is torn")
        saves += last
        most = max(most, len(leftovers(folder)))
        if most > 1:
            faults.append(f"kill {turn}: {leftovers(folder)}")
            break
        if turn % 2:
            bak.unlink(missing_ok=True)
    run(PROBE, "save", file, 300, "end")
    if leftovers(folder):
        faults.append("leftovers after the next save")
    note_faults(faults)
    check("02b", kills, kills, not faults and 2 * saves > kills,
          f"kills at random times during {saves} saves; {len(faults)} violations, "
          f"at most {most} leftover, 0 after the next save")


SIZES = [1, 100, 4095, 4096, 4097, 8192, 12288, 16383, 16384, 16385, 20000, 28672, 32768, 40960,
         45056, 53248, 61440, 65536, 65537, 1 << 20]


def check_full_disk(disk):
    """Every free space from nothing to the whole disk, in pages, times every size and scene."""
    if disk is None:
        print("CHECK 03 0 2000 SKIP  no right to mount a tmpfs of 64 KB here")
        return
    page, cases, faults, refused = 4096, 0, [], 0
    kinds = [dict(), dict(old=100), dict(old=5000), dict(old=100, backup=True),
             dict(old=100, link=True), dict(leftover=True)]
    # One process for all cases; it answers each line before the next scene is set.
    with subprocess.Popen([str(PROBE), "cases"], env=ENV, text=True, bufsize=1,
                          stdin=subprocess.PIPE, stdout=subprocess.PIPE) as probe:
        for kind in kinds:
            for size in SIZES:
                for free_pages in range(17):
                    scene = Scene("disk", size, **kind)
                    scene.folder = disk / "scene"
                    scene.file = scene.folder / "part.sparkout"
                    scene.path = scene.folder / "link" if scene.link else scene.file
                    (disk / "filler").unlink(missing_ok=True)
                    scene.prepare()
                    space = os.statvfs(disk).f_bavail  # in pages
                    with open(disk / "filler", "wb") as filler:
                        os.posix_fallocate(filler.fileno(), 0, max(1, space - free_pages) * page)
                    left = os.statvfs(disk).f_bavail * page
                    probe.stdin.write(f"{scene.path} {size} new{' --backup' * scene.backup}\n")
                    told = probe.stdout.readline()
                    cases += 1
                    refused += told.startswith("error")
                    fault = scene.fault(told)
                    if not fault and told.startswith("error"):
                        if told.split()[2] != str(errno.ENOSPC) or "free=-" in told:
                            fault = f"the cause is not named: {told!r}"
                        elif size + 2 * page <= left:
                            fault = f"refused with {left} bytes free: {told!r}"
                    if not fault and leftovers(scene.folder):
                        fault = "leftover"
                    if fault:
                        faults.append(f"{kind}, {size} bytes, {left} free: {fault}")
    note_faults(faults)
    check("03", cases, 2000, cases >= 2000 and not faults and 0 < refused < cases,
          f"saves on a full or nearly full disk, {refused} refused; {len(faults)} silent losses "
          "or wrong messages")


def become_nobody():
    os.setgroups([])
    os.setresgid(65534, 65534, 65534)
    os.setresuid(65534, 65534, 65534)


def mount_tmpfs(folder, options):
    libc = ctypes.CDLL(None, use_errno=True)
    return libc.mount(b"sparkout", str(folder).encode(), b"tmpfs", 0, options.encode()) == 0


def start():
    """Runs this script again in a mount namespace of its own, if that is allowed."""
    work = tempfile.mkdtemp(prefix="sparkout-faults-")
    os.chmod(work, 0o777)
    stage = [sys.executable, os.path.abspath(__file__), *sys.argv[1:], "--work", work]
    spaces = ["unshare", "-m"] if os.geteuid() == 0 else ["unshare", "-rm"]
    try:
        if subprocess.run([*spaces, "true"], stderr=subprocess.DEVNULL).returncode != 0:
            spaces = []
        else:
            stage.append("--mounts")
        return subprocess.run([*spaces, *stage]).returncode
    finally:
        shutil.rmtree(work, ignore_errors=True)


def checks(disk):
    if shutil.which("strace") is None:
        for number in ("01", "02a"):
            check(number, 0, 60, False, "strace is not installed (see packages.txt, test)")
    else:
        try:
            check_syncs_and_closes()
            check_exchange_beside_another_save()
            if "--calls" in sys.argv:
                return
            check_errors()
            check_kill_at_each_call()
        except RuntimeError as error:
            check("01", 0, LEAST_HITS, False, error)
    check_random_kills(20 if QUICK else 1000 if LONG else 200)
    check_full_disk(disk)


def main():
    global WORK, PROBE
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__)
        return 2
    if "--work" not in sys.argv:
        return start()
    work = pathlib.Path(sys.argv[sys.argv.index("--work") + 1])
    namespace_root = os.geteuid() == 0
    mounted = "--mounts" in sys.argv and mount_tmpfs(work, "size=64m,mode=1777")
    disk = None
    if mounted:
        disk = work / "disk"
        disk.mkdir()
        if not mount_tmpfs(disk, "size=64k,mode=1777"):
            disk = None
    PROBE = work / "probe"
    shutil.copy(sys.argv[1], PROBE)
    PROBE.chmod(0o755)
    if namespace_root:
        try:
            become_nobody()
        except OSError:  # a user namespace knows one user: this is no real root
            pass
    # Without a tmpfs of our own the shared one: syncing a disk thousands of times is slow.
    shared = "/dev/shm" if not mounted and os.access("/dev/shm", os.W_OK) else work
    with tempfile.TemporaryDirectory(prefix="sparkout-faults-", dir=shared) as files:
        WORK = pathlib.Path(files)
        checks(disk)
    return 1 if failures else 0


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    sys.exit(main())
