#!/usr/bin/env bash
# Renders every .gltf and .glb below FOLDER with both shipped graphs. Files that render are also rendered
# under the validation layer. Prints a table of exit codes, seconds and first messages. Fails when a run has
# an exit code other than 0 or 3, takes longer than 10 s, or has exit code 3 without a message. Usage:
#   third_party_suite.sh WEFT FOLDER [PICTURES]
# Debian's package assimp-testmodels contains suitable files, for example:
#   third_party_suite.sh weft /usr/share/assimp/models/glTF2 pictures
set -uo pipefail
weft=$1
folder=${2%/}
pictures=${3:-}
most_s=10
graphs=$(dirname "$(readlink -f "$0")")/../../graphs
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
if [ -n "$pictures" ]; then mkdir -p "$pictures"; fi
faults=0
runs=0

# Prints the first error of the last run without the name of the file. If there is no error, prints the first
# warning.
said() {
  { grep -E 'error\[|validation:' "$scratch/err" || grep 'warning\[' "$scratch/err"; } | head -n 1 |
    sed -E 's/^[^ ]*: (error|warning)/\1/' | cut -c1-160
}

# Usage: run LABEL FILE PICTURE [FLAGS]. Renders FILE, prints one row of the table and stores the exit code in
# `code`.
run() {
  local label=$1 file=$2 picture=$3 begin end seconds verdict=""
  shift 3
  begin=$(date +%s%N)
  timeout 60 "$weft" render "$file" -o "$picture" --size 320x180 "$@" >"$scratch/out" 2>"$scratch/err"
  code=$?
  end=$(date +%s%N)
  seconds=$(((end - begin) / 10000000))
  seconds=$((seconds / 100)).$(printf %02d $((seconds % 100)))
  runs=$((runs + 1))
  if [ "$code" != 0 ] && [ "$code" != 3 ]; then verdict="WRONG EXIT "; fi
  if [ "$code" = 3 ] && ! grep -q 'error\[' "$scratch/err"; then verdict+="NO MESSAGE "; fi
  if [ "${seconds%.*}" -ge "$most_s" ]; then verdict+="TOO SLOW "; fi
  if [ -n "$verdict" ]; then faults=$((faults + 1)); fi
  printf '%s | %s | %s | %s | %s%s\n' "${file#"$folder"/}" "$label" "$code" "$seconds" "$verdict" \
    "$(said)"
}

printf 'file | run | exit | s | first message\n'
while IFS= read -r file; do
  name=$(printf %s "${file#"$folder"/}" | tr '/ ' '__')
  picture=$scratch/picture.png
  if [ -n "$pictures" ]; then picture=$pictures/$name.png; fi
  run deferred "$file" "$picture"
  [ "$code" = 0 ] || continue
  run forward "$file" "${picture%.png}-forward.png" --graph "$graphs/forward.json"
  run validated "$file" "$scratch/validated.png" --validate
done < <(find "$folder" -type f \( -iname '*.gltf' -o -iname '*.glb' \) | sort)
printf '%s runs, %s faults\n' "$runs" "$faults"
[ "$runs" -gt 0 ] && [ "$faults" = 0 ]
