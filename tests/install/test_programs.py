# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs as they are installed: staged, run from there, with desktop entry, icons, manual pages
and completion that know every option the programs take, and no other.

Called with cmake, the build folder, sparkout-manual and an example project."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

cmake, build, manual, example, *_ = sys.argv[1:]
ICON_SIZES = (16, 22, 24, 32, 48, 64, 128, 256)


def ran(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, check=False, **more)


def run(*command, **more):
    done = ran(*command, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def installed(folder):
    """Two prefixes: below DESTDIR, and by itself with a space and Cyrillic in its name."""
    staged, other = folder / "staged", folder / "второй prefix"
    run(cmake, "--install", build, "--prefix", "/usr", "--component", "program",
        env={**os.environ, "DESTDIR": str(staged)})
    run(cmake, "--install", build, "--prefix", str(other), "--component", "program")
    lists = [sorted(str(file.relative_to(top)) for file in top.rglob("*") if file.is_file())
             for top in (staged / "usr", other)]
    assert lists[0] == lists[1] and len(lists[0]) > 30, lists
    return staged / "usr", other


def nothing_of_the_build(prefix):
    source = str(pathlib.Path(example).resolve().parents[2])
    for file in prefix.rglob("*"):
        if file.is_file():
            content = file.read_bytes()
            for path in (build, source):
                assert (path + "/").encode() not in content, f"{file} names {path}"


def runs(prefix, folder):
    home = folder / "home"
    home.mkdir(mode=0o700)
    environment = {"HOME": str(home), "XDG_RUNTIME_DIR": str(home), "PATH": os.environ["PATH"],
                   "LC_ALL": "C.UTF-8", "QT_QPA_PLATFORM": "offscreen"}
    said = run(str(prefix / "bin/sparkout-cli"), "simulate", example, cwd=home, env=environment)
    assert "double strokes" in said, said
    picture = home / "picture.png"
    run(str(prefix / "bin/sparkout"), "--picture", str(picture), example, cwd=home, env=environment)
    assert picture.stat().st_size > 20000
    return environment


def desktop(prefix):
    share = prefix / "share"
    entry = share / "applications/org.sparkout.sparkout.desktop"
    metainfo = share / "metainfo/org.sparkout.sparkout.metainfo.xml"
    mime = share / "mime/packages/org.sparkout.sparkout.xml"
    kind = xml.etree.ElementTree.parse(mime).getroot()[0].get("type")
    assert f"MimeType={kind};" in entry.read_text(encoding="utf-8")
    assert kind in metainfo.read_text(encoding="utf-8")
    for checker, arguments in (("desktop-file-validate", [entry]),
                               ("appstreamcli", ["validate", "--no-net", metainfo])):
        if shutil.which(checker):
            run(checker, *map(str, arguments))
    icons = share / "icons/hicolor"
    for name in ("apps/sparkout", "mimetypes/application-x-sparkout"):
        assert (icons / f"scalable/{name}.svg").is_file()
        for size in ICON_SIZES:
            header = (icons / f"{size}x{size}/{name}.png").read_bytes()[:24]
            assert header[16:24] == size.to_bytes(4, "big") * 2, (name, size)


def options():
    """(program, words of the command, option) of the table."""
    lines = [line.split() for line in run(manual, "--options").splitlines()]
    return [(program, words, option) for program, *words, option in lines]


def manuals(prefix, environment):
    rows = options()
    assert len(rows) > 60, rows
    share = prefix / "share"
    for program in ("sparkout", "sparkout-cli"):
        help_text = run(str(prefix / "bin" / program), "--help", env=environment)
        pages = [(share / f"man/{tongue}man1/{program}.1").read_text(encoding="utf-8")
                 for tongue in ("", "ru/")]
        shells = [(share / place).read_text(encoding="utf-8") for place in
                  (f"bash-completion/completions/{program}", f"zsh/vendor-completions/_{program}")]
        fish = (share / f"fish/vendor_completions.d/{program}.fish").read_text(encoding="utf-8")
        for _, command, option in (row for row in rows if row[0] == program):
            assert re.search(rf"^  {option}\b", help_text, re.M), option
            for page in pages:
                assert "\n\\fB" + option.replace("-", "\\-") + "\\fR" in page, (option, page)
            for text in shells:
                assert option in text, option
            flag = " -l " + option[2:] if option.startswith("--") else " -s " + option[1:]
            assert flag in fish, option
            if command:
                said = ran(str(prefix / "bin" / program), *command, option, env=environment)
                assert said.returncode == 2 and "unknown option" not in said.stderr, (command, option)
        # Each option that is named anywhere is one.
        known = {row[2] for row in rows if row[0] == program}
        named = set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", help_text.split("\n\n")[1]))
        assert named <= known, named - known
        for page in pages:
            assert re.search(r"^\.TH \S+ 1 ", page, re.M) and "�" not in page
        assert sum("А" <= letter <= "я" for letter in pages[1]) > 1000
    assert ran(str(prefix / "bin/sparkout-cli"), "simulate", "--ever").stderr.count("unknown option")


def choices(prefix, environment):
    """What the window says it takes is what the table says."""
    bash = (prefix / "share/bash-completion/completions/sparkout").read_text(encoding="utf-8")
    for option, wrong in (("--report", ["-o", "a.pdf", example]), ("--view", ["--picture", "a.png", example])):
        said = ran(str(prefix / "bin/sparkout"), option, "nothing", *wrong, env=environment).stderr
        there = re.search(r"known: ([^;\n]*)", said).group(1).split(", ")
        stated = re.search(rf'{option}\) kind="choice" words="(.*?)"', bash).group(1).split()
        assert there == stated, (option, there, stated)


def completed(prefix, *words):
    program = words[0]
    script = (f'source "{prefix}/share/bash-completion/completions/{program}"; '
              'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
              f'_{program.replace("-", "_")}; printf "%s\\n" "${{COMPREPLY[@]}}"')
    return run("bash", "-c", script, "bash", *words, cwd=pathlib.Path(example).parent).split()


def completion(prefix):
    assert completed(prefix, "sparkout-cli", "batch-") == ["batch-merge"]
    assert completed(prefix, "sparkout-cli", "batch", "--sc") == ["--scenarios"]
    assert completed(prefix, "sparkout-cli", "batch", "--scenarios", "l") == ["latin_hypercube"]
    assert completed(prefix, "sparkout-cli", "simulate", "wheel-d") == ["wheel-dull.sparkout"]
    assert completed(prefix, "sparkout-cli", "new", "--len") == ["--length"]
    assert completed(prefix, "sparkout-cli", "measured", "--he") == ["--help"]
    assert completed(prefix, "sparkout-cli", "course", "v") == ["variants"]
    assert completed(prefix, "sparkout-cli", "course", "grade", "--x") == ["--xlsx"]
    assert completed(prefix, "sparkout", "--lang", "") == ["en", "ru"]
    assert completed(prefix, "sparkout", "--theme", "con") == ["contrast"]
    assert "setups" in completed(prefix, "sparkout", "-d", "")
    share = prefix / "share"
    for shell, file in (("bash", "bash-completion/completions/sparkout-cli"),
                        ("zsh", "zsh/vendor-completions/_sparkout-cli"),
                        ("fish", "fish/vendor_completions.d/sparkout-cli.fish")):
        if shutil.which(shell):
            run(shell, "-n", str(share / file))


with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name)
    first, second = installed(work)
    nothing_of_the_build(first)
    variables = runs(second, work)
    desktop(first)
    manuals(first, variables)
    choices(first, variables)
    completion(first)
print(f"installed below two prefixes, run there; {len(options())} options in help, manuals and shells")
