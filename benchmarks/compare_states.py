#!/usr/bin/env python3
# Folded states counted by kiri and by rabbit-ear, file by file, in one run: CPU time, memory, ratios.
# SPDX-License-Identifier: MIT
"""Usage: benchmarks/compare_states.py PATH_OF_kiri FOLDER_OF_PATTERNS [--limit SECONDS] [--runs N]

Needs node, npm and a network: rabbit-ear goes to a temporary folder outside the tree, which is removed again.
The folder holds the patterns of Flat-Folder (github.com/origamimagiro/flat-folder, examples), found by name."""

import argparse
import json
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
PEER = "rabbit-ear@0.9.32"

# Name in the table, file, CPU seconds of other programs for all states (measured once elsewhere, whole process).
COUNTED = [
    ("Sailboat", "001_*Sailboat.fold", {"Flat-Folder": 0.168, "ORIPA": 0.9}),
    ("Kabuto", "kabuto.fold", {"Flat-Folder": 0.189, "ORIPA": 0.94}),
    ("Triangle Bird", "003_*Triangle_Bird.fold", {"Flat-Folder": 4.962, "ORIPA": 18.41}),
    ("Dalmatian", "353_*Dalmatian.fold", {"Flat-Folder": 3.072}),
    ("Checkerboard 26 x 26", "036_*Checkerboard*.fold", {"Flat-Folder": 4.698}),
    ("Chalcosoma Chiron", "252_*Chiron.fold", {"Flat-Folder": 26.758}),
    ("Dragon HP", "057_*Dragon*.fold", {}),
]
# The same for the first state: CPU seconds and MB of the best of the others.
FIRST = [
    ("Prosopocoilus", "046_*Prosopocoilus*.fold", {"Oriedita": (11.5, 305)}),
    ("Shrimp", "037_*Shrimp*.fold", {"Oriedita": (9.4, 251)}),
    ("Dragon HP", "057_*Dragon*.fold", {}),
    ("Sierpinski-Penrose Triangle", "284_*Sierpinski*.fold", {}),
]


def timed(command, limit):
    """CPU seconds, peak MB and output of a program; none where it did not end in time or failed."""
    with tempfile.TemporaryFile() as out:
        start = time.monotonic()
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.DEVNULL,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        text = out.read().decode()
    if process.returncode != 0:
        return None, f"> {limit} s" if used.ru_utime + used.ru_stime > 0.95 * limit else "failed", time.monotonic() - start
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, text


def median(command, limit, runs):
    """The run with the median CPU time."""
    done = [timed(command, limit) for _ in range(runs)]
    if any(run[0] is None for run in done):
        return next(run for run in done if run[0] is None)
    return sorted(done, key=lambda run: run[0])[len(done) // 2]


def ratio(theirs, ours):
    return f"{theirs:.2f} s ({theirs / ours:,.0f} x)"


def file_for(folder, pattern):
    found = sorted(folder.rglob(pattern))
    return found[0] if found else None


def as_fold(kiri, file, work):
    """The same pattern as FOLD, for the peer reads nothing else."""
    if file.suffix == ".fold":
        return file
    out = work / (file.stem + ".fold")
    subprocess.run([kiri, "convert", str(file), str(out)], check=True, capture_output=True)
    return out


def count_table(kiri, folder, work, limit, runs):
    print("All states, exactly. CPU of the whole process; ratio: theirs / ours.")
    print("| pattern | facets | pairs | states | KiriSim | rabbit-ear, this run | others, measured elsewhere |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for name, pattern, others in COUNTED:
        file = file_for(folder, pattern)
        if file is None:
            print(f"| {name} | not found | | | | | |")
            continue
        ours, megabytes, text = median([kiri, "states", str(file), "--json"], limit, runs)
        if ours is None:
            print(f"| {name} | | | {megabytes} | | | |")
            continue
        answer = json.loads(text)
        peer, peer_megabytes, peer_text = timed(
            ["node", "--max-old-space-size=4096", HERE / "states_in_rabbit_ear.mjs", work, as_fold(kiri, file, work)], limit)
        if peer is None:
            peer_cell = peer_megabytes
        else:
            theirs = json.loads(peer_text)["states"]
            same = "" if theirs == answer["states"] else f", counts {theirs}"
            peer_cell = f"{ratio(peer, ours)}, {peer_megabytes:.0f} MB{same}"
        listed = ", ".join(f"{other} {ratio(seconds, ours)}" for other, seconds in others.items())
        print(f"| {name} | {answer['faces']} | {answer['pairs']:,} | {answer['states']} | {ours:.3f} s, {megabytes:.0f} MB | "
              f"{peer_cell} | {listed} |", flush=True)


def first_table(kiri, folder, work, limit, runs):
    print("\nThe first state, written as FOLD. CPU of the whole process.")
    print("| pattern | facets | pairs | KiriSim | others, measured elsewhere |")
    print("| --- | --- | --- | --- | --- |")
    for name, pattern, others in FIRST:
        file = file_for(folder, pattern)
        if file is None:
            print(f"| {name} | not found | | | |")
            continue
        command = [kiri, "states", str(file), "--state", "0", "--json", "-o", str(work / "first.fold")]
        ours, megabytes, text = median(command, limit, runs)
        if ours is None:
            print(f"| {name} | | | {megabytes} | |")
            continue
        answer = json.loads(text)
        listed = ", ".join(f"{other} {ratio(seconds, ours)}, {mb} MB" for other, (seconds, mb) in others.items())
        print(f"| {name} | {answer['faces']:,} | {answer['pairs']:,} | {ours:.2f} s, {megabytes:.0f} MB | {listed} |",
              flush=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("kiri")
    arguments.add_argument("patterns", type=Path)
    arguments.add_argument("--limit", type=int, default=120, help="CPU seconds for one file")
    arguments.add_argument("--runs", type=int, default=3, help="runs of kiri; the median counts")
    options = arguments.parse_args()
    for tool in ("node", "npm"):
        if not shutil.which(tool):
            sys.exit(f"compare_states: {tool} is missing; install it and try again")
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        install = subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", folder, PEER],
                                 capture_output=True, text=True)
        if install.returncode != 0:
            sys.exit("compare_states: npm could not install rabbit-ear; is there a network?\n" + install.stderr)
        count_table(options.kiri, options.patterns, work, options.limit, options.runs)
        first_table(options.kiri, options.patterns, work, options.limit, options.runs)


if __name__ == "__main__":
    main()
