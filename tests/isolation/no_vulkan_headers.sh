#!/usr/bin/env bash
# Compiles every source of weft_graph, weft_check, weft_null and weft_shader with a first include directory whose
# vulkan/vulkan.h and volk.h are #error. A precompiled header of what most of them include makes it quick; it is made
# under the same directory. The C++ pass of docs/writing-a-pass.md is compiled too, so that the page stays true.
#   no_vulkan_headers.sh COMPILER SOURCE_ROOT SCRATCH_FOLDER
set -euo pipefail
compiler=$1 root=$2 scratch=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

flags=(-std=c++20 -I"$here/poison" -I"$root/framework/include" -I"$root/framework")
for folder in /usr/include/spirv_cross /usr/local/include/spirv_cross; do
  [ ! -d "$folder" ] || flags+=(-isystem "$folder")
done

rm -rf "$scratch"
mkdir -p "$scratch/docs"

# The trap works: a file that includes either header is refused.
for header in vulkan/vulkan.h volk.h; do
  if echo "#include <$header>" | "$compiler" "${flags[@]}" -fsyntax-only -x c++ - 2>/dev/null; then
    echo "the poisoned $header was not found first: this test would see nothing" >&2
    exit 1
  fi
done

{
  for header in algorithm functional map set vector; do echo "#include <$header>"; done
  for header in "$root"/framework/include/weft/*.h; do
    case $header in */light_list.h) ;; *) echo "#include \"weft/${header##*/}\"" ;; esac
  done
} >"$scratch/most.h"
"$compiler" "${flags[@]}" -x c++-header "$scratch/most.h" -o "$scratch/most.h.gch"

# "<!-- file: NAME -->" and the fence behind it, to a file of that name.
awk -v into="$scratch/docs" '
  /^<!-- file: .*\.(h|cpp) -->$/ { name = into "/" $3; next }
  name && /^```/ { if (inside) { close(name); name = ""; inside = 0 } else { inside = 1
    folder = name; sub("/[^/]*$", "", folder); system("mkdir -p \"" folder "\"") } next }
  inside { print > name }' "$root/docs/writing-a-pass.md"

sources=("$root"/framework/graph/*.cpp "$root"/framework/check/*.cpp "$root"/framework/null/*.cpp
  "$root"/framework/shader/*.cpp "$root"/framework/shader/worker/*.cpp "$scratch"/docs/passes/*/*.cpp)
printf '%s\0' "${sources[@]}" |
  xargs -0 -P "$(nproc)" -n 1 "$compiler" "${flags[@]}" -I"$scratch/docs/passes" -include "$scratch/most.h" \
    -Winvalid-pch -fsyntax-only
echo "${#sources[@]} sources compile without Vulkan headers"
