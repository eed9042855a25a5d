#!/usr/bin/env bash
# Makes the pictures of README.md and docs/ again, with the program itself.
# SPDX-License-Identifier: MIT
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
cd "$root"

sheet() { # EXAMPLE PICTURE OPTIONS...
  local example=$1 picture=$2
  shift 2
  ./kiri sheet "examples/$example.kiri" -o "docs/pictures/$picture.png" --background '#ffffff' --dpi 110 "$@"
}

view() { # EXAMPLE PICTURE OPTIONS...
  local example=$1 picture=$2
  shift 2
  ./kiri render "examples/$example.kiri" -o "docs/pictures/$picture.png" --background '#ffffff' "$@"
}

sheet leaf_acer_circinatum leaf --steps 17,18,last --columns 3 --no-numbers --no-titles
sheet leaf_palmate palmate_steps
sheet leaf_secondary_lobes secondary_lobes --steps 3,5,7,13-16 --columns 4
sheet ship ship_steps
sheet kirigami_snowflake snowflake_steps
view leaf_hornbeam opening --step 30.6 --view=-25,35 --perspective 30 --shade --shadow --dpi 90
view kirigami_snowflake layers --step 5 --view 30,25 --explode 5 --shade --dpi 100
view ship thickness --view 20,40 --thickness 0.8 --shade --shadow --dpi 100
maple=$(mktemp --suffix .kiri)
./kiri leaf examples/leaves/sugar_maple_lobes.json -o "$maple"
./kiri measure "$maple" -o docs/pictures/maple_measured.png --background '#ffffff' --dpi 90
rm "$maple"
./kiri animate examples/leaf_palmate.kiri --size 320x220 --fps 12 --speed 180 --hold 0.2 -o docs/pictures/leaf_film.gif
./kiri animate examples/leaf_hornbeam.kiri --steps 31 --size 280x210 --fps 15 --speed 60 -o docs/pictures/hornbeam_opens.gif
tools/make_models_page.py

# The window's are made by the journeys of the tests, which fold in it with mouse and keyboard.
cmake --build --preset release --target kiri_tests_apps_desktop_journeys kiri_tests_apps_desktop \
  kiri_tests_apps_desktop_dialogs
shots=$(mktemp -d)
KIRI_PICTURES=$shots tools/with_screen.sh build/release/kiri_tests_apps_desktop_journeys
KIRI_PICTURES=$shots tools/with_screen.sh build/release/kiri_tests_apps_desktop --gtest_filter='CaptionInTheWindow.*'
KIRI_PICTURES=$shots tools/with_screen.sh build/release/kiri_tests_apps_desktop_dialogs --gtest_filter='StartPageTest.Pointing*'
cp "$shots/caption-step.png" docs/pictures/window_caption.png
cp "$shots/start-preview-light-1x.png" docs/pictures/window_start.png
cp "$shots/journey-leaf.png" docs/pictures/window.png
cp "$shots/journey-stretch.png" docs/pictures/window_stretch.png
cp "$shots/journey-pattern.png" docs/pictures/window_pattern.png
cp "$shots/journey-faults.png" docs/pictures/window_faults.png
rm -r "$shots"
