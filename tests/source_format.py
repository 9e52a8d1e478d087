#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether every source is set as clang-format sets it: source_format.py CLANG_FORMAT."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
names = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, text=True,
                       stdout=subprocess.PIPE).stdout.split("\0")
sources = [name for name in names if re.search(r"\.(h|cpp)$", name)]
if len(sources) < 500:
    sys.exit(f"git lists {len(sources)} sources")
sys.exit(subprocess.run([sys.argv[1], "--dry-run", "-Werror", *sources], cwd=ROOT,
                        check=False).returncode)
