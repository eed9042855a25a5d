#!/usr/bin/env bash
# Runs clang-tidy on sources of the product: check_tidy.sh BUILD_FOLDER [FILE...]; without files, on all of them.
# SPDX-License-Identifier: MIT
set -euo pipefail
build=$(readlink -f -- "$1")
shift
cd "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."

if (($# == 0)); then
  exec python3 tools/tidy_rooms.py "$build"
fi
# The build is g++'s: flags that only g++ knows are no defect.
status=0
found=$(printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" \
  clang-tidy -p "$build" --quiet --extra-arg=-Wno-unknown-warning-option 2>&1) || status=1
grep -vE '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -header-filter' <<<"$found" || true
exit "$status"
