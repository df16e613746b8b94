#!/usr/bin/env bash
# Renders the pictures of docs/tutorial.md by following it: writes the page's files to an empty folder and runs its commands,
# in the page's order. Requires ImageMagick. Check each picture before you commit it.
#   docs/make_tutorial.sh [WEFT_PROGRAM]    default: ./weft
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
weft=$(readlink -f "${1:-$here/../weft}")
images=$here/images/tutorial
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$images"

# Converts the page to a shell script.
awk '
  /^<!-- file: .* -->$/ { name = $3; next }
  /^```/ && inside { if (name != "") print "END_OF_FILE"; name = ""; inside = 0; next }
  /^```/ {
    inside = 1; runs = $0 == "```sh"
    if (name != "") printf "mkdir -p \"$(dirname %s)\"\ncat >%s <<\"END_OF_FILE\"\n", name, name
    next
  }
  inside && (name != "" || runs)
' "$here/tutorial.md" >"$scratch/page.sh"
ln -s "$weft" "$scratch/weft"
(cd "$scratch" && bash -e page.sh </dev/null)

# Reduces pictures to 256 dithered colours: half the bytes, and the difference is hardly visible.
small() {
  convert "$1" -strip -dither FloydSteinberg -colors 256 -define png:compression-filter=5 -define png:compression-level=9 \
    "$images/$2.png"
}
cd "$scratch/tutorial"
for shown in 02 03 03-noon 04 05 06 07 08 10 10-depth; do small "$shown.png" "$shown"; done
convert \( 07.png -crop 80x90+300+0 \) \( 08.png -crop 80x90+300+0 \) +repage -filter point -resize 300% +append glow.png
small glow.png 08-detail
convert \( 08.png -crop 80x90+355+90 \) \( 09.png -crop 80x90+355+90 \) +repage -filter point -resize 300% +append detail.png
small detail.png 09-detail
