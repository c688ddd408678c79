# SPDX-License-Identifier: MIT
# shellcheck shell=bash disable=SC2034
# Functions that the scripts share: messages, installing what is missing, building a preset.
# Read by bash scripts, which set -euo pipefail before.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Debian 12 packages: what softcnc is built from, and what its tests need beyond that.
build_packages=(g++ cmake ninja-build pkg-config libeigen3-dev libcli11-dev libspdlog-dev libfmt-dev
                libtomlplusplus-dev nlohmann-json3-dev libexpected-dev libzstd-dev libzip-dev
                zlib1g-dev libxxhash-dev libyaml-cpp-dev libreaderwriterqueue-dev libcairo2-dev libncurses-dev
                fonts-dejavu-core)
test_packages=(catch2 clang libclang-rt-14-dev librapidcheck-dev libbenchmark-dev python3
               python3-numpy python3-scipy python3-matplotlib python3-yaml parallel zstd
               python3-pytest python3-pexpect python3-pyte mypy)
# What the Python package is built from.
python_packages=(pybind11-dev python3-dev)
# What shows the pages of reports; their sources also need Node, see need_node.
browser_packages=(chromium)
tidy_packages=(clang clang-tidy clang-format)

say() { printf 'softcnc: %s\n' "$*" >&2; }

# missing PACKAGE...: those that are not installed, on one line.
missing() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed* ]] ||
      printf '%s ' "$package"
  done
}

# as_root COMMAND...: never asks for a password without a terminal.
as_root() {
  if ((EUID == 0)); then "$@"
  elif { : </dev/tty; } 2>/dev/null; then sudo -- "$@"
  else sudo -n -- "$@"; fi
}

apt_install() {
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --no-install-recommends "$@" </dev/null
}

# need PACKAGE...: installs what is missing; exit 2 with the command to type if that is not allowed.
need() {
  local wanted log="$root/build/install.log"
  read -ra wanted <<<"$(missing "$@")"
  ((${#wanted[@]})) || return 0
  local line="apt-get install ${wanted[*]}"
  if ((EUID != 0)) && ! as_root true 2>/dev/null; then
    say "these packages are missing, and only root can install them:"
    printf '  sudo %s\n' "$line" >&2
    exit 2
  fi
  mkdir -p "$root/build"
  say "installing ${wanted[*]}"
  apt_install "${wanted[@]}" >"$log" 2>&1 && return 0
  say "updating the list of packages, then installing again"
  { as_root apt-get update --quiet && apt_install "${wanted[@]}"; } >>"$log" 2>&1 && return 0
  tail -n 15 "$log" >&2
  say "installing failed; the output is in $log"
  exit 2
}

# need_node: Node and npm, whoever has installed them; Debian's otherwise.
need_node() {
  command -v node >/dev/null && command -v npm >/dev/null && return 0
  need nodejs npm
}

# configure PRESET [CMAKE OPTION...]
configure() {
  local log="$root/build/$1.log"
  mkdir -p "$root/build"
  say "configuring preset $1 in build/$1"
  local cached=()
  command -v ccache >/dev/null && cached=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  (cd "$root" && cmake --preset "$@" "${cached[@]}") >"$log" 2>&1 && return 0
  tail -n 25 "$log" >&2
  say "configuring failed; the output is in $log"
  return 1
}

# Of one object of a build, most of which are of some files: seconds of CPU, about.
seconds_per_object=8

# show_progress: passes on what ninja prints, but of its steps only how far it is, every 20 s.
show_progress() {
  local line status far='' said=$SECONDS
  while true; do
    status=0
    IFS= read -r -t 20 line || status=$?
    if ((status > 128)); then line=''; elif ((status > 0)); then return; fi
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]\  ]]; then
      far="${BASH_REMATCH[1]} of ${BASH_REMATCH[2]} steps"
    elif [[ -n $line && $line != 'ninja: '* ]]; then
      printf '%s\n' "$line"
    fi
    if [[ -n $far ]] && ((SECONDS - said >= 20)); then
      said=$SECONDS
      say "$far"
    fi
  done
}

# build PRESET TARGET...: says how long it takes, about, and how far it is: ninja's own lines on a
# terminal.
build() {
  local make=(ninja -C "$root/build/$1" -j"$(nproc)") objects seconds long=''
  if [[ ! -f $root/build/$1/.ninja_log ]]; then
    objects=$("${make[@]}" -t targets all | grep -c '\.o: CXX') || true
    seconds=$((objects * seconds_per_object / $(nproc)))
    long=", which takes about $(((seconds + 59) / 60)) min on this computer"
  fi
  say "building ${*:2} in build/$1$long"
  if [[ -t 2 ]]; then
    "${make[@]}" "${@:2}" </dev/null >&2
  else
    "${make[@]}" "${@:2}" </dev/null | show_progress >&2
  fi
}
