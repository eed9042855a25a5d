#!/usr/bin/env bash
# Runs a command on a screen that nobody sees, with a window manager on it: with_screen.sh COMMAND...
# SPDX-License-Identifier: MIT
set -euo pipefail
if [[ " $* " == *" --gtest_list_tests "* ]]; then
  exec "$@"
fi
export QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=${QT_SCALE_FACTOR:-1} LIBGL_ALWAYS_SOFTWARE=1 NO_AT_BRIDGE=1
# A window that is mapped before the manager has taken over is never told that it is seen.
# shellcheck disable=SC2016  # the inner shell expands these
exec xvfb-run -a -s "-screen 0 1600x1100x24" bash -c '
  openbox & manager=$!
  trap "kill $manager" EXIT
  for ((i = 0; i < 600; ++i)); do
    xdotool get_num_desktops >/dev/null 2>&1 && break
    sleep 0.05
  done
  "$@"' run "$@"
