#!/usr/bin/env bash
# Makes the leaves of examples/ again from their recipes in examples/leaves/, with the program itself.
# SPDX-License-Identifier: MIT
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
cd "$root"

for recipe in examples/leaves/*.json; do
  ./kiri leaf "$recipe" -o "examples/leaf_$(basename -- "$recipe" .json).kiri"
done
