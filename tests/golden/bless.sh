#!/usr/bin/env bash
# Renders the pictures of views.txt again, with the driver that made the existing pictures. Check each picture before
# you commit it, and describe the changes in the commit message.
#   tests/golden/bless.sh [WEFT_PROGRAM]    default: ./weft
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
weft=${1:-$root/weft}
if ! command -v "$weft" >/dev/null; then
  echo "bless.sh: WEFT_PROGRAM '$weft' is no program; build the viewer and name it: bless.sh build/viewer/weft" >&2
  exit 1
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
while read -r graph scene camera options; do
  [ -n "$graph" ] && [ "${graph:0:1}" != "#" ] || continue
  case $options in *--probes*) ;; *) options="--probes none $options" ;; esac
  # shellcheck disable=SC2086  # options are words
  "$weft" render "builtin:$scene" --graph "$root/graphs/$graph.json" --camera "$camera" --size 320x180 \
    -o "$scratch/$graph-$scene-$camera.png" --stats "$scratch/stats.json" $options </dev/null
done <"$here/views.txt"
# Replaces the old pictures only if all new ones exist. Each picture is copied beside its destination and then renamed,
# so that a full disk leaves no incomplete file.
sed -n 's/^ *"\(device\|driver\)": "\(.*\)",$/\2/p' "$scratch/stats.json" >"$scratch/driver.txt"
next=$(mktemp -d "$here/.next-XXXXXX")
trap 'rm -rf "$scratch" "$next"' EXIT
cp "$scratch"/*.png "$scratch/driver.txt" "$next"
for old in "$here"/*.png; do
  [ -e "$next/${old##*/}" ] || rm -f "$old"
done
mv "$next"/* "$here"
