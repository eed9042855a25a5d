#!/usr/bin/env python3
"""Prints the table of compare_peers.sh from the figures of the kernel and of the scripts."""
# SPDX-License-Identifier: MIT
import json
import sys


def kernel_times(path):
    times = {}
    for run in json.load(open(path, encoding="utf-8"))["benchmarks"]:
        if run.get("run_type") == "aggregate":
            continue
        scale = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}[run["time_unit"]]
        times[int(run["name"].split("/")[1])] = run["cpu_time"] * scale
    return times


def ratio(theirs, ours):
    return "-" if theirs is None else f"{theirs / ours:.1f} x"


def text(value):
    return "-" if value is None else f"{value:.2f}"


def main():
    kernel = kernel_times(sys.argv[1])
    scripts = json.load(open(sys.argv[2], encoding="utf-8"))
    print("Halving a square, CPU ms of the whole sequence; ratio: theirs / ours")
    print("folds facets  KiriSim | bare script, fresh process | the same, warm      | rabbit-ear flatFold")
    for folds in sorted(kernel):
        bare = scripts["bare"].get(str(folds))
        peer = scripts["rabbit_ear"].get(str(folds))
        ours = kernel[folds]
        print(f"{folds:5d} {2 ** folds:6d} {ours:8.3f} |"
              f" {text(bare['fresh']):>9} {ratio(bare['fresh'], ours):>9}        |"
              f" {text(bare['warm']):>8} {ratio(bare['warm'], ours):>8}   |"
              f" {text(peer):>9} {ratio(peer, ours):>10}")


if __name__ == "__main__":
    main()
