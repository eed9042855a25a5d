#!/usr/bin/env bash
# Runs a command on a screen that nobody sees, with a window manager on it: with_screen.sh COMMAND...
# SPDX-License-Identifier: MIT
set -euo pipefail
if [[ " $* " == *" --gtest_list_tests "* ]]; then
  exec "$@"
fi
folder=$(mktemp -d)
server='' manager=''
clean_up() {
  [[ -z $manager ]] || kill "$manager" 2>/dev/null || true
  [[ -z $server ]] || kill "$server" 2>/dev/null || true
  rm -rf "$folder"
}
trap clean_up EXIT

# Waits until a command succeeds, for half a minute at most.
await() {
  local i
  for ((i = 0; i < 600; ++i)); do
    "$@" >/dev/null 2>&1 && return
    sleep 0.05
  done
  printf 'with_screen.sh: in vain waited for: %s\n' "$*" >&2
  exit 70
}

# The server finds a free number by itself, so many can start at once.
Xvfb -displayfd 3 -screen 0 1600x1100x24 -noreset -nolisten tcp 3>"$folder/display" 2>"$folder/log" &
server=$!
await test -s "$folder/display"
DISPLAY=:$(<"$folder/display")
export DISPLAY
export QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=${QT_SCALE_FACTOR:-1} LIBGL_ALWAYS_SOFTWARE=1 NO_AT_BRIDGE=1
openbox >/dev/null 2>&1 &
manager=$!
# A window that is mapped before the manager has taken over is never told that it is seen.
await xdotool get_num_desktops
"$@"
