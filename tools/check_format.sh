#!/usr/bin/env bash
# Names the files that clang-format would change; with --fix changes them.
# SPDX-License-Identifier: MIT
set -euo pipefail
cd "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."

tops=()
for top in core io render editor apps tests benchmarks examples; do
  [[ -d $top ]] && tops+=("$top")
done
mapfile -t files < <(find "${tops[@]}" \( -name '*.h' -o -name '*.cpp' \) | sort)
if [[ ${1-} == --fix ]]; then
  clang-format --style=file -i "${files[@]}"
  exit 0
fi
status=0
for file in "${files[@]}"; do
  if ! clang-format --style=file "$file" | cmp -s - "$file"; then
    printf '%s\n' "$file: not formatted; run tools/check_format.sh --fix"
    status=1
  fi
done
exit "$status"
