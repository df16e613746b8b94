#!/usr/bin/env bash
# Checks rules for the sources that grep can test. Prints every violation, and fails if there is one.
#   source_rules.sh SOURCE_ROOT
set -euo pipefail
cd "$1"
breaches=0
# report RULE: reads the violations from stdin, and prints them with the text of the rule.
report() {
  local line
  while IFS= read -r line; do
    printf '%s: %s\n' "$1" "$line"
    breaches=$((breaches + 1))
  done
}
# Lists all text files of the project except this one, because this file contains the forbidden words.
files() { find "$@" -type f -not -name source_rules.sh | sort; }
# Prints all lines of the files as FILE:LINE:TEXT without // comments, for rules that concern only code.
# shellcheck disable=SC2016  # awk's own $0
code() { xargs awk '{ sub(/\/\/.*/, ""); print FILENAME ":" FNR ":" $0 }'; }
sources() { files "$@" | grep -E '\.(h|cpp|glsl|vert|frag|comp|sh|in)$' || true; }

everything=(framework passes shaders viewer tests)

# Shaders in tests/ that are named after the SPIR-V capability DemoteToHelperInvocation may contain the word "Helper".
report "name says nothing" < <(
  files "${everything[@]}" | grep -v '/DemoteToHelperInvocation\.' |
    grep -iE '/[a-z_]*(util|common|helper|manager)[a-z_]*\.' || true)

report "Vulkan name in a module that knows no Vulkan" < <(
  sources framework/include framework/graph framework/check framework/null framework/shader framework/load \
    framework/scene framework/image passes | grep -vE '^framework/include/weft/(vulkan|render)/' | code |
    grep -E '\b(Vk[A-Z]|VK_[A-Z]|vkCmd[A-Z]|vk[A-Z][a-z]+[A-Z(])|volk\.h|vulkan/' || true)

report "unfinished" < <(
  files "${everything[@]}" docs graphs README.md | xargs grep -nIE '\b(TODO|FIXME|XXX|HACK)\b|[Nn]ot implemented' || true)

report "shared ownership, or a singleton" < <(
  sources framework passes viewer | code | grep -E '\b(std::)?(shared_ptr|weak_ptr|make_shared)\b|[gG]et_?[iI]nstance\(' || true)

# Only framework/file may write files and stdout, because it checks every write for errors. All code may write to
# stderr.
report "written without framework/file" < <(
  sources framework viewer | grep -v '^framework/file/' | code |
    grep -E '\b(ofstream|fstream|fwrite|fputc|putchar|puts|printf|fopen) *\(|\bofstream\b|\bstdout\)|std::cout|stbi_write_[a-z]+\(|SaveEXR\(' |
    grep -vE 'fopen\([^;]*"re?"' || true)

report "slow third-party header in a header" < <(
  files framework passes viewer | grep -E '\.h$' |
    xargs grep -nIE '#include [<"](nlohmann/json\.hpp|CLI/|tiny_gltf|stb_|tinyexr|fmt/|glslang/)' || true)

# The checker must not use the code of the stages that it checks.
report "framework/check includes more than plans, declarations and the standard library" < <(
  grep -nE '^ *# *include' framework/check --include=*.h --include=*.cpp -r |
    grep -vE '#include ("(weft/)?check/([a-z]+/)?[a-z_]+\.h"|<[a-z_]+>)' |
    grep -vE '"weft/(plan|transition|declaration|resource_declaration|live_value|switches|access|result|source|format|shader_interface|device_profile)\.h"' || true)

# The null executor must use neither the code of the stages nor that of the checker.
report "framework/null includes more than plans, declarations and the standard library" < <(
  grep -nE '^ *# *include' framework/null/*.h framework/null/*.cpp |
    grep -vE '#include ("null/[a-z_]+\.h"|<[a-z_]+>|"weft/(plan|declaration)\.h")' || true)

report "diagnostic without a row in docs/diagnostics.md" < <(
  grep -rhoE '"[WSVCX][0-9]{3}"' framework viewer passes | tr -d '"' | sort -u |
    while IFS= read -r code; do grep -q "^| $code |" docs/diagnostics.md || echo "$code"; done)
report "row of docs/diagnostics.md without a diagnostic" < <(
  grep -oE '^\| [WSVCX][0-9]{3} \|' docs/diagnostics.md | tr -d '| ' | sort |
    while IFS= read -r code; do grep -rqF "\"$code\"" framework viewer passes || echo "$code"; done)

report "link to nowhere" < <(
  for page in README.md docs/*.md; do
    grep -oE '\]\([^)#]+' "$page" | cut -c3- | grep -vE '^[a-z]+:' |
      while IFS= read -r target; do [ -e "$(dirname "$page")/$target" ] || echo "$page: $target"; done || true
  done)

if ((breaches)); then
  echo "$breaches breaches"
  exit 1
fi
echo "no breaches"
