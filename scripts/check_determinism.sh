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
mkdir -p "$root"

# build FOLDER COMPILER FLAGS: builds the program with CMake. United sources take less time (cmake/unity.cmake).
build() {
  local options=(-DCMAKE_CXX_COMPILER="$2" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="$3" -DWAYWRIGHT_UNITY=8)
  local part
  for part in TESTS TOOLS C EXAMPLES; do options+=("-DWAYWRIGHT_BUILD_$part=OFF"); done
  if command -v ccache >/dev/null; then options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  rm -rf "$1"
  if ! { cmake -S . -B "$1" -G Ninja "${options[@]}" &&
    cmake --build "$1" --parallel "$jobs" --target waywright_print_meshes; } >"$1.log" 2>&1; then
    tail -n 40 "$1.log" >&2
    printf '%s\n' "check_determinism: the build in $1 failed; the whole output is in $1.log" >&2
    exit 1
  fi
  mv "$1/tests/determinism/waywright_print_meshes" "$1/print_meshes"
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
    build "$root/$name" "$compiler" "$level"
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
