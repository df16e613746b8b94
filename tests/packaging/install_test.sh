#!/usr/bin/env bash
# Installs the build, moves the folder, and uses the moved folder as a user and as an embedder would. Without a Vulkan
# device the exit code is 77 (skipped), after all parts of the test that need no device have passed.
#   install_test.sh CMAKE BUILD_FOLDER SOURCE_ROOT PROGRAM
set -euo pipefail
cmake=$1 build=$2 source=$3 program=$4
# The folder is outside the source tree, because the program also searches the folders above its own folder for missing
# files. So it could find files of the source tree.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
installed=$scratch/moved

# The samples beside `embedding` and `cooked` that are built and run. The extended tests build and run all of them.
samples=(raw_pass own_semaphores plan_only)
if [ "${WEFT_EXTENDED:-0}" = 1 ]; then
  samples+=(own_command_buffer own_format two_sessions moving own_meshes shipped_graph built_graph)
fi

say() { printf '%s\n' "$*"; }
fail() {
  say "FAILED: $*" >&2
  exit 1
}

install_and_move() {
  "$cmake" --install "$build" --prefix "$scratch/first" >"$scratch/install.log"
  mv "$scratch/first" "$installed"
  # No file may contain the path of the folder before the move, or of the source tree.
  if grep -rlI -e "$scratch/first" -e "$source" "$installed/lib/cmake" "$installed/lib/pkgconfig" "$installed/include"; then
    fail "these files name a place of the machine that built them"
  fi
}

# Expects that all libraries which are not part of the system come from the installed folder.
check_libraries() {
  local name arrow path
  while read -r name arrow path _; do
    case $name in
      linux-vdso.so.1 | */ld-linux* | libc.so.* | libm.so.* | libstdc++.so.* | libgcc_s.so.*) continue ;;
    esac
    [ "$arrow" = "=>" ] || fail "ldd of $1: $name $arrow"
    [[ $(readlink -f "$path") == "$installed"/lib/weft/* ]] || fail "$1 takes $name from $path"
  done < <(env -i ldd "$1")
  [ -n "$(ls -A "$installed/share/doc/weft/licences")" ] || fail "no licences came along"
}

# Renders the default picture as a user would: with an empty environment, and in another working folder.
render_default() {
  local renders=(render --probes none --frames 4 --size 320x180 -o)
  (cd / && env -i ${ASAN_OPTIONS:+ASAN_OPTIONS="$ASAN_OPTIONS"} "$installed/bin/weft" "${renders[@]}" "$scratch/installed.png")
  "$program" "${renders[@]}" "$scratch/built.png"
  cmp "$scratch/installed.png" "$scratch/built.png" || fail "the installed program draws another picture"
  (cd / && env -i ${ASAN_OPTIONS:+ASAN_OPTIONS="$ASAN_OPTIONS"} "$installed/bin/weft" plan --profile tiler \
    "$installed/share/weft/graphs/deferred.json" >/dev/null) || fail "the installed program finds no profiles"
}

build_sample() {
  "$cmake" -S "$source/docs/examples/embedding" -B "$scratch/embedding" -G Ninja -DCMAKE_PREFIX_PATH="$installed" \
    >"$scratch/embedding.log"
  "$cmake" --build "$scratch/embedding" --target embedding cooked "${samples[@]}" >>"$scratch/embedding.log" || {
    cat "$scratch/embedding.log" >&2
    fail "the embedding sample doesn't build"
  }
}

# Compiles one file that includes every public header, with warnings enabled and with the flags of pkg-config.
build_with_pkg_config() {
  (cd "$installed/include" && find weft -name '*.h' | sort | sed 's/.*/#include <&>/') >"$scratch/all_headers.h"
  # shellcheck disable=SC2046,SC2086  # flags are words
  ${CMAKE_CXX_COMPILER_LAUNCHER:-} "${CXX:-g++}" -std=c++20 -Wall -Wextra -Werror ${CXXFLAGS:-} \
    -include "$scratch/all_headers.h" "$source/tests/packaging/same_picture.cpp" \
    $(PKG_CONFIG_PATH="$installed/lib/pkgconfig" pkg-config --cflags --libs weft) -o "$scratch/same_picture" ||
    fail "a file doesn't build with what pkg-config says"
}

# Runs the commands of docs/embedding.md for a build without CMake, with the path of the installed folder. Commands that
# need a device are left out.
build_by_the_page() {
  cp -r "$source/docs/examples/embedding" "$scratch/by_hand"
  awk '/^<!-- compiled by the tests -->$/ { wanted = 1; next } /^```/ { inside = wanted && !inside; if (!inside) wanted = 0; next }
       inside' "$source/docs/embedding.md" | grep -v '^\./' | sed "s|~/weft|$installed|; s|^g++|\${CXX:-g++} \${CXXFLAGS:-}|" \
    >"$scratch/by_hand/build.sh"
  grep -q -- '-o embedding' "$scratch/by_hand/build.sh" || fail "docs/embedding.md shows no command that compiles"
  (cd "$scratch/by_hand" && bash -e build.sh) || fail "what docs/embedding.md says doesn't compile its sample"
  [ -x "$scratch/by_hand/embedding" ] || fail "what docs/embedding.md says makes no program"
}

# The sample program embeds Weft and writes its own image. The image must contain the same picture as that of `weft
# render`.
compare_sample() {
  "$scratch/embedding/embedding" "$scratch/embedded.ppm" --validate || fail "the embedding sample ended with $?"
  "$program" render builtin:spheres --graph "$source/graphs/deferred.json" --probes none --device 0 --size 320x180 \
    --frames 3 -o "$scratch/reference.png"
  "$scratch/same_picture" "$scratch/reference.png" "$scratch/embedded.ppm" ||
    fail "the embedding sample draws another picture"
}

# Builds the other samples with the flags of pkg-config. This takes long, so it is part of the extended tests.
build_other_samples_with_pkg_config() {
  local sample folder=$source/docs/examples/embedding
  for sample in "${samples[@]}"; do
    # shellcheck disable=SC2046,SC2086  # flags are words
    "${CXX:-g++}" -std=c++20 ${CXXFLAGS:-} -I"$folder" -DWEFT_DATA_DIR="\"$installed/share/weft\"" \
      "$folder/$sample/main.cpp" "$folder/sample.cpp" "$folder/own_device.cpp" \
      $(PKG_CONFIG_PATH="$installed/lib/pkgconfig" pkg-config --cflags --libs weft vulkan) -o "$scratch/$sample" ||
      fail "the sample $sample doesn't build with what pkg-config says"
  done
  # shellcheck disable=SC2046,SC2086  # flags are words
  "${CXX:-g++}" -std=c++20 ${CXXFLAGS:-} -I"$folder" "$folder/cooked/main.cpp" "$folder/own_device.cpp" \
    $(PKG_CONFIG_PATH="$installed/lib/pkgconfig" pkg-config --cflags --libs weft_runtime vulkan) -o "$scratch/cooked" ||
    fail "the sample cooked doesn't build with what pkg-config says"
}

# Runs the other samples under the validation layer. Each checks its own picture.
run_other_samples() {
  local sample
  for sample in "${samples[@]}"; do
    [ "$sample" = plan_only ] || "$scratch/embedding/$sample" --validate || fail "the sample $sample ended with $?"
  done
  (cd / && env -i ${ASAN_OPTIONS:+ASAN_OPTIONS="$ASAN_OPTIONS"} "$installed/bin/weft" plan --size 320x180 \
    --format cooked -o "$scratch/disc.cooked" "$scratch/by_hand/cooked/disc.json")
  "$scratch/embedding/cooked" "$scratch/disc.cooked" --validate || fail "the sample cooked ended with $?"
  if nm -C "$scratch/embedding/cooked" | grep -q -e 'glslang::' -e 'spvtools::'; then
    fail "the sample cooked contains a GLSL compiler"
  fi
}

# Expects that the pages for authors and embedders are installed, and that each file that they link to is, too.
check_pages() {
  local page
  for page in format shaders writing-a-pass SECURITY diagnostics glossary lights sun-shadows scenes command-line embedding; do
    [ -s "$installed/share/weft/docs/$page.md" ] || fail "docs/$page.md is not installed"
  done
  python3 "$source/tests/packaging/check_links.py" "$installed/share/weft/docs" || fail "an installed page has a link to nothing"
}

# Expects that docs/embedding.md quotes the output that the sample program really prints.
check_quotes() {
  local line
  while IFS= read -r line; do
    grep -qF -- "$line" "$source"/docs/examples/embedding/{*,*/main}.cpp || fail "docs/embedding.md quotes what the sample lacks: $line"
  done < <(awk '/^```/ { inside = $0 == "```cpp"; next } inside && NF' "$source/docs/embedding.md")
}

check_quotes
install_and_move
check_pages
for installed_program in "$installed"/bin/*; do check_libraries "$installed_program"; done
build_sample
(cd / && env -i "$scratch/embedding/plan_only" | grep -q '^tonemap$') || fail "the sample plan_only makes no plan"
build_with_pkg_config
build_by_the_page
if [ "${WEFT_EXTENDED:-0}" = 1 ]; then build_other_samples_with_pkg_config; fi
if ! "$program" doctor >/dev/null 2>&1; then
  say "skipped: no Vulkan device to render on"
  exit 77
fi
render_default
compare_sample
run_other_samples
say "passed"
