#!/usr/bin/env bash
# Compares the first picture of Weft, the default of `weft render`, with Cycles, the path tracer of Blender. Needs the
# Debian packages blender, python3-numpy and python3-pil. Takes about 15 minutes on two processor cores.
# usage: atrium.sh WEFT FOLDER [SAMPLES]
#   FOLDER gets the scene, the pictures and the table. Pictures of Cycles that are there already are used again.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
weft=$(realpath "$1")
samples=${3:-256}
command -v blender >/dev/null || { echo "atrium.sh: install the Debian package blender" >&2; exit 1; }
mkdir -p "$2"
cd "$2"

# The camera "court" of builtin:atrium: position, target, and vertical field of view in degrees.
camera=3.9,1.75,8.1,-1.5,2.6,-3.2,37.2936
size=640x360
most_bounces=16

# LIGHTS BOUNCES SAMPLES: renders the light of these sources with Cycles.
trace() {
    [ -e "cycles-$1.hdr" ] && return
    echo "Cycles: light of the $1, $3 samples"
    blender -b --factory-startup -P "$here/cycles.py" -- atrium.glb atrium.hdr "$PWD/cycles-$1.hdr" \
        "${size%x*}" "${size#*x}" "$3" "$2" imported "$camera" "$1" </dev/null >cycles.log 2>&1
    [ -e "cycles-$1.hdr" ] || { cat cycles.log >&2; exit 1; }
}

# RESOURCE OPTION...: renders with Weft.
draw() {
    "$weft" render builtin:atrium --size "$size" --resource "$1" --timeout 1200 "${@:2}" 2>weft.log ||
        { cat weft.log >&2; exit 1; }
}

"$weft" scene builtin:atrium --gltf atrium.glb --sky atrium.hdr --probes none >/dev/null
trace sky "$most_bounces" "$samples"
trace lamps "$most_bounces" "$samples"
trace sun 0 32
# Temporal anti-aliasing weights samples by their brightness, so the exposure must be that of a picture. atrium.py
# divides by it.
draw resolved --exposure -12 -o weft.pfm
draw hdr --exposure -12 --env none --probes none --graph "$here/../../graphs/deferred.json" -o weft-sun.pfm
/usr/bin/python3 "$here/atrium.py" . | tee atrium.txt
"$weft" compare path-traced-weft.png path-traced-cycles.png --metric flip
