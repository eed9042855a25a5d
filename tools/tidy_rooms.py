#!/usr/bin/env python3
# Runs clang-tidy on all sources of the product, several sources of a room at once.
# SPDX-License-Identifier: MIT
"""Usage: tidy_rooms.py BUILD_FOLDER. Prints what clang-tidy finds; exit code 1 when it finds something.

Nearly all of clang-tidy's time goes into headers that every source includes. A file that includes the sources of a
room, as the sanitized build compiles them too, reads those headers once."""

import json
import os
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TOPS = ("core", "io", "render", "editor", "apps")
AT_ONCE = 24
NOISE = (" warnings generated", " warning generated", "Suppressed ", "Use -header-filter", " warnings treated",
         " warning treated")


def commands_of(build, root):
    """The compiler's flags of each source of the product, by path."""
    flags = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        path = Path(entry["directory"], entry["file"]).resolve()
        if path.is_relative_to(root) and path.relative_to(root).parts[0] in TOPS:
            words = shlex.split(entry["command"])
            flags[path] = [word for word, before in zip(words, [""] + words)
                           if word.startswith(("-I", "-D", "-std", "-isystem", "-W", "-f")) or before == "-isystem"]
    return flags


def batches_of(flags):
    """Sources of one room with the same flags, at most AT_ONCE each."""
    rooms = {}
    for path in sorted(flags):
        rooms.setdefault((path.parent, tuple(flags[path])), []).append(path)
    for (_, words), paths in rooms.items():
        for start in range(0, len(paths), AT_ONCE):
            yield paths[start:start + AT_ONCE], words


def tidy(root, folder, number, paths, words):
    source = folder / f"room_{number}.cpp"
    source.write_text("".join(f'#include "{path}"\n' for path in paths), encoding="utf-8")
    done = subprocess.run(
        ["clang-tidy", "--quiet", "--checks=-bugprone-suspicious-include", f"--config-file={root / '.clang-tidy'}",
         f"--header-filter=^{root}/({'|'.join(TOPS)})/", str(source), "--", *words, "-Wno-unknown-warning-option"],
        cwd=root, capture_output=True, text=True)
    lines = [line for line in (done.stdout + done.stderr).splitlines() if not any(word in line for word in NOISE)]
    return done.returncode, lines


def main():
    build = Path(sys.argv[1]).resolve()
    root = Path(__file__).resolve().parent.parent
    status = 0
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = [pool.submit(tidy, root, Path(folder), number, *batch)
                for number, batch in enumerate(batches_of(commands_of(build, root)))]
        for job in jobs:
            code, lines = job.result()
            status = status or code
            if lines:
                print("\n".join(lines))
    return 1 if status else 0


if __name__ == "__main__":
    sys.exit(main())
