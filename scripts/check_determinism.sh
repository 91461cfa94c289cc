#!/usr/bin/env bash
# usage: check_determinism.sh
# Builds the library and a program that runs changes on 200 worlds, with two compilers at several optimisation levels.
# Compares the output of the programs byte for byte. Prints a line for each build and a verdict. Outputs that differ
# remain in build/determinism/. COMPILERS names other compilers; WAYWRIGHT_JOBS limits how many run at once.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C.UTF-8

read -r -a compilers <<<"${COMPILERS:-g++-12 clang++-14}"
levels=("-O0" "-O2" "-O3 -DNDEBUG" "-O3 -DNDEBUG -march=native")
jobs=${WAYWRIGHT_JOBS:-$(nproc)}
root=build/determinism

list_sources() {
  find src -name '*.cpp' | sort
  printf '%s\n' tests/determinism/print_meshes.cpp tests/support/random_changes.cpp tests/support/random_scenes.cpp
}

# build FOLDER COMPILER FLAG...
build() {
  local folder=$1
  shift
  local compile=("$@" -std=c++20 -ffp-contract=off -Iinclude -Isrc -Itests)
  if command -v ccache >/dev/null; then compile=(ccache "${compile[@]}"); fi
  rm -rf "$folder"
  mkdir -p "$folder"
  # shellcheck disable=SC2016 # the inner shell is to expand these
  list_sources | xargs -P "$jobs" -I '{}' \
    bash -c 'source=$1 folder=$2; shift 2; "$@" -c "$source" -o "$folder/${source//\//_}.o"' \
    compile '{}' "$folder" "${compile[@]}"
  "$1" "$folder"/*.o -o "$folder/print_meshes"
  rm "$folder"/*.o
}

reference=
different=0
builds=0
for compiler in "${compilers[@]}"; do
  if ! command -v "$compiler" >/dev/null; then
    printf '%s\n' "check_determinism: $compiler is not here" >&2
    exit 1
  fi
  for level in "${levels[@]}"; do
    name=$compiler${level// /}
    # Word splitting is wanted: one argument a flag.
    # shellcheck disable=SC2086
    build "$root/$name" "$compiler" $level
    output=$root/$name/output
    "$root/$name/print_meshes" >"$output"
    reference=${reference:-$output}
    verdict=same
    if ! cmp -s "$reference" "$output"; then
      verdict=DIFFERENT
      different=$((different + 1))
    fi
    builds=$((builds + 1))
    read -r hash _ < <(sha256sum "$output")
    printf '%-40s %s scripts, %s bytes, %.16s… %s\n' "$compiler $level" "$(grep -c '^script ' "$output")" \
      "$(stat -c %s "$output")" "$hash" "$verdict"
  done
done

if ((different > 0)); then
  printf 'not deterministic: %d of %d builds differ from the first\n' "$different" "$builds"
  exit 1
fi
printf 'deterministic: %d builds print the same bytes\n' "$builds"
