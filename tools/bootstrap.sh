# What the three doors (kiri, kirisim, test) share: install what is missing, build, say what happens.
# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced with KIRI_ROOT set to the root of the repository. Everything is said on standard error, so that
# the output of the program stays clean.

KIRI_BUILD=$KIRI_ROOT/build
KIRI_LOG=$KIRI_BUILD/bootstrap.log

say() { printf '%s\n' "kirisim: $*" >&2; }

give_up() {
  say "$@"
  exit 70
}

# Shows the lines of standard input as progress: one line that overwrites itself on a terminal, about ten lines
# otherwise. Everything goes to the log as well.
show_progress() {
  local line at total shown=-1 width=${COLUMNS:-80}
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$KIRI_LOG"
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      at=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
    elif [[ $line =~ ^(Unpacking|Setting\ up|Get:) ]]; then
      at=0 total=0
    else
      continue
    fi
    if [[ -t 2 ]]; then
      printf '\r\033[K%s' "${line:0:width-1}" >&2
    elif ((at > 0 && (at * 10 / total != shown || at == total))); then
      shown=$((at * 10 / total))
      printf 'kirisim: built %d of %d\n' "$at" "$total" >&2
    fi
  done
  [[ -t 2 ]] && printf '\r\033[K' >&2
  return 0
}

# Prints what went wrong: the log from the first failure on, without the commands that were run.
show_failure() {
  { grep -m 1 -A 100000 -E '^FAILED|^CMake Error|^E: |error' "$KIRI_LOG" || cat "$KIRI_LOG"; } |
    grep -vE '^\[[0-9]+/[0-9]+\] |^(: && )?/usr/.* -[oc] |^-- ' | tail -n 60 >&2
  say "the whole log: $KIRI_LOG"
}

# The packages that a door needs: packages_of kiri, packages_of kiri test. Those whose command is there from
# another source are left out: Debian's npm, for one, cannot stand beside the nodejs of NodeSource.
packages_of() {
  local name door reason
  while read -r name door reason; do
    [[ $name == \#* || -z $name ]] && continue
    if [[ $reason =~ ^unless=([^ ]+) ]] && command -v "${BASH_REMATCH[1]}" >/dev/null; then continue; fi
    [[ " $* " == *" $door "* ]] && printf '%s\n' "$name"
  done <"$KIRI_ROOT/tools/packages.txt"
}

# Those of the named packages that are not installed.
missing_packages() {
  local installed name
  installed=" $(dpkg-query -W -f='${db:Status-Status}=${Package} ' "$@" 2>/dev/null || true) "
  for name in "$@"; do
    [[ $installed == *" installed=$name "* ]] || printf '%s\n' "$name"
  done
}

# Installs what the named doors need and is not there. Sets KIRI_INSTALLED to 1 when it installed something.
install_missing() {
  local -a wanted missing root=()
  KIRI_INSTALLED=0
  mapfile -t wanted < <(packages_of "$@")
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "this is no Debian system, so nothing is installed; needed: ${wanted[*]}"
    return 0
  fi
  mapfile -t missing < <(missing_packages "${wanted[@]}")
  ((${#missing[@]} == 0)) && return 0
  if ((EUID != 0)); then
    command -v sudo >/dev/null || give_up "these packages are missing, and only root can install them;" \
      "as root run: apt-get install --no-install-recommends ${missing[*]}"
    root=(sudo)
  fi
  say "installing ${#missing[@]} packages: ${missing[*]}"
  local -a apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -o DPkg::Lock::Timeout=600
    -o Dpkg::Use-Pty=0)
  "${apt[@]}" update 2>&1 | show_progress ||
    say "the package lists could not all be refreshed; going on with what is there"
  if ! "${apt[@]}" install --no-install-recommends "${missing[@]}" 2>&1 | show_progress; then
    show_failure
    give_up "the packages could not be installed; try: apt-get install --no-install-recommends ${missing[*]}"
  fi
  KIRI_INSTALLED=1
}

# Takes the lock of the build folder on descriptor 9, so that two doors never build at the same time.
take_lock() {
  mkdir -p "$KIRI_BUILD" || give_up "cannot write to $KIRI_BUILD"
  exec 9>"$KIRI_BUILD/.lock"
  command -v flock >/dev/null || return 0
  if ! flock -n 9; then
    say "waiting for another build of this folder to end"
    flock 9
  fi
}

release_lock() { exec 9>&-; }

# Configures a preset: when it never was, when it was for another place, or when told `always`.
configure() {
  local preset=$1 when=${2:-} cache=$KIRI_BUILD/$1/CMakeCache.txt
  if [[ -f $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$KIRI_ROOT" "$cache"; then
    say "build/$preset was made for another place; starting it anew"
    rm -rf "${KIRI_BUILD:?}/$preset"
  fi
  if [[ $when == always || $KIRI_INSTALLED == 1 || ! -f $KIRI_BUILD/$preset/build.ninja ]]; then
    say "configuring build/$preset"
    if ! (cd "$KIRI_ROOT" && cmake --preset "$preset") >>"$KIRI_LOG" 2>&1; then
      show_failure
      return 1
    fi
  fi
}

# Builds targets of a preset: build release kiri.
build() {
  local preset=$1
  shift
  say "building build/$preset ($*)"
  if ! (cd "$KIRI_ROOT" && cmake --build --preset "$preset" -j "$(nproc)" --target "$@") 2>&1 | show_progress; then
    show_failure
    return 1
  fi
}

# The packages of a program: the window needs those of the command line too.
doors_of() { [[ $1 == kirisim ]] && printf 'kiri kirisim\n' || printf 'kiri\n'; }

# True when build/release/NAME is newer than everything it is made from. Folders count too, so that an added
# or removed file is seen.
is_program_fresh() {
  local name=$1 stamp=$KIRI_BUILD/release/.$1-built
  local -a made_of=(CMakeLists.txt CMakePresets.json ARCHITECTURE.md cmake core io render apps)
  [[ $name == kirisim ]] && made_of+=(editor)
  [[ -x $KIRI_BUILD/release/$name && -f $stamp ]] || return 1
  [[ -z $(cd "$KIRI_ROOT" && find "${made_of[@]}" -newer "$stamp" -print -quit 2>/dev/null) ]]
}

# Sees to it that build/release/NAME is there and up to date: need_program kiri. At once when it is.
need_program() {
  local name=$1 ninja=$KIRI_BUILD/release/build.ninja when=
  is_program_fresh "$name" && return 0
  take_lock
  if ! is_program_fresh "$name"; then
    : >"$KIRI_LOG"
    # shellcheck disable=SC2046  # one word for each door
    install_missing $(doors_of "$name")
    touch "$KIRI_BUILD/.started"
    # Configured before its packages were there, the build does not know the program.
    grep -qsF "build $name:" "$ninja" || when=always
    if ! configure release $when || ! build release "$name"; then
      give_up "the program could not be built"
    fi
    mv -f "$KIRI_BUILD/.started" "$KIRI_BUILD/release/.$name-built"
  fi
  release_lock
}
