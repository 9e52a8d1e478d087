# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python module and its type stubs, installed into an empty folder, where the example runs.

Called with cmake, the build folder and the example."""
import ast
import os
import pathlib
import subprocess
import sys
import tempfile

cmake, build, example = sys.argv[1:]


def run(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


with tempfile.TemporaryDirectory() as folder:
    run(cmake, "--install", build, "--prefix", folder, "--component", "python")
    files = sorted(path for path in pathlib.Path(folder).rglob("*") if path.is_file())
    assert len(files) == 2 and len({path.parent for path in files}) == 1, files
    module, stubs = sorted(files, key=lambda path: path.suffix == ".pyi")
    assert module.suffix == ".so" and module.name.split(".")[0] == "sparkout", module
    assert stubs.name == "sparkout.pyi", stubs

    environment = {**os.environ, "PYTHONPATH": str(module.parent), "PYTHONIOENCODING": "utf-8"}
    said = run(sys.executable, example, env=environment)
    assert said.startswith("completed: "), said

    # What the stubs have is there, and what is there they have.
    names = {node.name: {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
             for node in ast.parse(stubs.read_text(encoding="utf-8")).body
             if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    script = ("import sparkout, json; print(json.dumps({name: sorted(x for x in "
              "vars(getattr(sparkout, name)) if not x.startswith('_')) if isinstance("
              "getattr(sparkout, name), type) else [] for name in dir(sparkout) "
              "if not name.startswith('_')}))")
    found = ast.literal_eval(run(sys.executable, "-c", script, env=environment))
    typed = {"Section", "SectionForm", "Requirement"}  # of dictionaries
    assert set(found) == set(names) - typed, (sorted(found), sorted(names))
    for name, members in found.items():
        stated = {each for each in names[name] if not each.startswith("_")}
        assert stated == set(members), (name, sorted(stated), members)
print(f"installed with its stubs; the example runs: {said.splitlines()[0]}")
