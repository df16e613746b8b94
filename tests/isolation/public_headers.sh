#!/usr/bin/env bash
# Compiles each public header by itself. The compiler sees only framework/include and system headers. So a header must
# include everything that it needs, and only headers that are installed.
#   public_headers.sh COMPILER SOURCE_ROOT
set -euo pipefail
compiler=$1 root=$2
cd "$root/framework/include"

flags=(-std=c++20 -fsyntax-only -Wall -Wextra -Werror -I.)

# Tests this script itself: a header that lacks an #include must fail to compile.
broken=$(mktemp --suffix=.h)
trap 'rm -f "$broken"' EXIT
echo 'inline std::string name() { return {}; }' >"$broken"
if "$compiler" "${flags[@]}" -x c++ "$broken" 2>/dev/null; then
  echo "a header that lacks an #include compiles: this test would see nothing" >&2
  exit 1
fi

# A header that is compiled by itself always gives the warning "#pragma once in main file". So the compiled file
# includes the header instead.
mapfile -t headers < <(find weft -name '*.h' | sort)
printf '%s\n' "${headers[@]}" |
  xargs -P "$(nproc)" -I{} sh -c 'echo "#include \"$1\"" | "$2" '"${flags[*]}"' -x c++ - || { echo "$1 does not compile by itself" >&2; exit 255; }' _ {} "$compiler"
echo "${#headers[@]} public headers compile by themselves"
