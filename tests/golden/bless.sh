#!/usr/bin/env bash
# Makes the pictures that views.txt names anew, with the driver that made them. Look at each before you commit it, and
# say in the commit what you saw.
#   tests/golden/bless.sh [WEFT_PROGRAM]    default: ./weft
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
weft=${1:-$root/weft}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
rm -f "$here"/*.png
while read -r graph scene camera options; do
  [ -n "$graph" ] && [ "${graph:0:1}" != "#" ] || continue
  # shellcheck disable=SC2086  # options are words
  "$weft" render "builtin:$scene" --graph "$root/graphs/$graph.json" --camera "$camera" --size 320x180 \
    -o "$here/$graph-$scene-$camera.png" --stats "$scratch/stats.json" $options </dev/null
done <"$here/views.txt"
sed -n 's/^ *"\(device\|driver\)": "\(.*\)",$/\2/p' "$scratch/stats.json" >"$here/driver.txt"
