#!/usr/bin/env bash
# Compiles the public headers. The compiler sees only framework/include and system headers. So a header must include
# everything that it needs, and only headers that are installed. With WEFT_EXTENDED, each header is compiled by itself;
# this takes two minutes of processor time. Without it, each tenth header is compiled by itself, and all headers are
# compiled together, in alphabetical order and in the opposite order.
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

# The compiled text includes a header instead of being it, because of the warning "#pragma once in main file".
mapfile -t headers < <(find weft -name '*.h' | sort)
alone=()
for i in "${!headers[@]}"; do
  if [ -n "${WEFT_EXTENDED:-}" ] || ((i % 10 == 0)); then alone+=("${headers[i]}"); fi
done
for order in cat tac; do
  printf '#include "%s"\n' "${headers[@]}" | "$order" | "$compiler" "${flags[@]}" -x c++ -
done
printf '%s\n' "${alone[@]}" |
  xargs -P "$(nproc)" -I{} sh -c 'echo "#include \"$1\"" | "$2" '"${flags[*]}"' -x c++ - || { echo "$1 does not compile by itself" >&2; exit 255; }' _ {} "$compiler"
echo "${#headers[@]} public headers compile together, ${#alone[@]} of them by themselves"
