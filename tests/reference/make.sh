#!/usr/bin/env bash
# Renders all references again with Blender's path tracer. Needs the Debian packages blender and python3-numpy.
# usage: make.sh [NAME...]    only the pictures whose names contain one of the given words
set -euo pipefail
cd "$(dirname "$0")"
command -v blender >/dev/null || { echo "make.sh: install the Debian packages blender and python3-numpy" >&2; exit 1; }
mkdir -p pictures

words=("$@")
is_wanted() {
    [ ${#words[@]} -eq 0 ] && return
    for word in "${words[@]}"; do [[ $1 == *"$word"* ]] && return; done
    return 1
}

while read -r picture scene environment width height samples bounces scattering camera _; do
    case $picture in ''|'#'*) continue;; esac
    is_wanted "$picture" || continue
    echo "$picture"
    blender -b --factory-startup -P cycles.py -- "scenes/$scene.gltf" "environments/$environment.hdr" \
        "$PWD/pictures/$picture.hdr" "$width" "$height" "$samples" "$bounces" "$scattering" "$camera" \
        </dev/null >/dev/null 2>&1
done < pictures.txt
