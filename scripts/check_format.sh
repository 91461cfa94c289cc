#!/usr/bin/env bash
# usage: check_format.sh [--fix]
# Refuses files in C++ and C that clang-format would change; with --fix, changes them. Checks the files that git tracks or
# would track. Outside a work tree, checks all files.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case ${1:-} in
  --fix) mode=(-i) ;;
  *) mode=(--dry-run -Werror) ;;
esac

list_files() {
  git ls-files -z --cached --others --exclude-standard -- '*.cpp' '*.hpp' '*.inl' '*.c' '*.h' 2>/dev/null ||
    find . -path ./build -prune -o \( -name '*.cpp' -o -name '*.hpp' -o -name '*.inl' -o -name '*.[ch]' \) -print0
}

list_files | while IFS= read -r -d '' file; do
  # A file that git tracks may be missing in the work tree.
  if [[ -f $file ]]; then printf '%s\0' "$file"; fi
done | xargs -0 --no-run-if-empty clang-format-14 "${mode[@]}"
