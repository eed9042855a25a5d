#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the halving sequence here, in a bare script and in rabbit-ear (npm), one after the other, and prints ratios.
# Usage: benchmarks/compare_peers.sh PATH_OF_kiri_bench_core [MOST_FOLDS_OF_RABBIT_EAR]
# The npm package goes to a temporary folder outside the tree, which is removed again.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
bench=${1:?give the path of kiri_bench_core (build preset release)}
most=${2:-10}
for tool in node npm python3; do
  command -v "$tool" >/dev/null || { echo "compare_peers: $tool is missing; install it and try again" >&2; exit 1; }
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT INT TERM
echo "installing rabbit-ear 0.9.32 into a temporary folder ..." >&2
(cd "$work" && npm init -y && npm install --no-audit --no-fund rabbit-ear@0.9.32) >"$work/npm.log" 2>&1 || {
  cat "$work/npm.log" >&2
  echo "compare_peers: npm could not install rabbit-ear; is there a network?" >&2
  exit 1
}
echo "timing the scripts (up to $most folds for rabbit-ear) ..." >&2
node "$here/compare_peers.mjs" "$work" "$most" >"$work/scripts.json"
echo "timing the kernel ..." >&2
"$bench" --benchmark_filter='^Halving' --benchmark_format=json >"$work/kernel.json" 2>/dev/null
python3 "$here/compare_peers.py" "$work/kernel.json" "$work/scripts.json"
