# The npm packages of package.json, installed once into the build folder.
# SPDX-License-Identifier: MIT
"""For tests that let programs by others judge what KiriSim writes."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
BUILD = Path(os.environ.get("KIRI_BINARY_DIR", ROOT / "build/release"))
PROGRAM = os.environ.get("KIRI_PROGRAM", str(BUILD / "kiri"))
SKIPPED = 77


def install():
    """The folder that holds the packages, or a sentence that says why they cannot be had."""
    folder = BUILD / "foreign"
    wanted = (HERE / "package.json").read_bytes()
    stamp = folder / "installed.json"
    if stamp.is_file() and stamp.read_bytes() == wanted:
        return folder, None
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.json").write_bytes(wanted)
    try:
        run = subprocess.run(["npm", "install", "--no-package-lock", "--no-audit", "--no-fund"], cwd=folder,
                             capture_output=True, text=True, timeout=300)
    except (OSError, subprocess.TimeoutExpired) as problem:
        return None, f"npm could not be run: {problem}"
    if run.returncode != 0:
        return None, "npm could not install what tests/foreign/package.json names: " + run.stderr.strip()[-1000:]
    stamp.write_bytes(wanted)
    return folder, None


def installed_or_exit():
    """The folder, or the end of the program: skipped with a reason, failed where CI is set."""
    folder, reason = install()
    if folder is not None:
        return folder
    if os.environ.get("CI"):
        sys.exit(reason)
    print("skipped: " + reason)
    sys.exit(SKIPPED)
