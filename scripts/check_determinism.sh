#!/usr/bin/env bash
# usage: check_determinism.sh
# Builds the library and a program that lets 200 worlds live, with two compilers at several optimisation levels, and
# compares what the programs print byte for byte. COMPILERS names other compilers, WAYWRIGHT_JOBS limits how many run at
# once.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C.UTF-8

read -r -a compilers <<<"${COMPILERS:-g++-12 clang++-14}"
levels=(-O0 -O2 -O3 "-O3 -march=native")
jobs=${WAYWRIGHT_JOBS:-$(nproc)}
root=build/determinism

mapfile -t sources < <(
  find src -name '*.cpp' | sort
  printf '%s\n' tests/determinism/print_meshes.cpp tests/support/random_changes.cpp tests/support/random_scenes.cpp
)

launcher=()
if command -v ccache >/dev/null; then launcher=(ccache); fi

# build_and_run FOLDER COMPILER FLAG...
build_and_run() {
  local folder=$1
  shift
  rm -rf "$folder"
  mkdir -p "$folder"
  local source
  for source in "${sources[@]}"; do
    printf '%s\0%s\0' "$source" "$folder/${source//\//_}.o"
  done | xargs -0 -n 2 -P "$jobs" sh -c '"$@" -c "$0" -o "$1"' 2>"$folder/errors.log"
}
