#!/usr/bin/env bash
# Tests that weft_graph, weft_check, weft_null, weft_shader and weft_load include no Vulkan headers. Preprocesses each
# of their sources with an include folder whose vulkan/vulkan.h and volk.h contain only #error. The C++ pass of
# docs/writing-a-pass.md is compiled in the same way, so that the page stays correct.
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

# Tests this script itself: a file that includes one of the two headers must fail to compile.
for header in vulkan/vulkan.h volk.h; do
  if echo "#include <$header>" | "$compiler" "${flags[@]}" -E -x c++ - >/dev/null 2>&1; then
    echo "the poisoned $header was not found first: this test would see nothing" >&2
    exit 1
  fi
done

# Finds each line "<!-- file: NAME -->" of the page and writes the following fenced block to a file of that name.
awk -v into="$scratch/docs" '
  /^<!-- file: .*\.(h|cpp) -->$/ { name = into "/" $3; next }
  name && /^```/ { if (inside) { close(name); name = ""; inside = 0 } else { inside = 1
    folder = name; sub("/[^/]*$", "", folder); system("mkdir -p \"" folder "\"") } next }
  inside { print > name }' "$root/docs/writing-a-pass.md"

"$compiler" "${flags[@]}" -I"$scratch/docs/passes" -fsyntax-only "$scratch"/docs/passes/*/*.cpp

# All sources are preprocessed as one file, so that each header is read only once.
mapfile -t sources < <(cd "$root" && find framework/{graph,check,null,shader,load} -name '*.cpp' | sort)
cd "$root"
printf '#include "%s"\n' "${sources[@]}" | "$compiler" "${flags[@]}" -I"$root" -E -o /dev/null -x c++ -
echo "${#sources[@]} sources and the page's do without Vulkan headers"
