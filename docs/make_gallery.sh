#!/usr/bin/env bash
# Draws the pictures of the gallery and writes docs/gallery.md. Needs ImageMagick. Look at each picture before you commit
# it.
#   docs/make_gallery.sh [WEFT_PROGRAM]    default: ./weft
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/.." && pwd)
weft=${1:-$root/weft}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$here/images/gallery"

cat <<'END' >"$scratch/gallery.md"
# Gallery

What graphs can do with JSON and GLSL alone: none of these has a line of C++ of its own. `docs/make_gallery.sh` draws the
pictures and writes this page.
END

# GRAPH TITLE ALT OPTIONS, the description on stdin.
show() {
  local graph=$1 title=$2 alt=$3 options=$4
  # shellcheck disable=SC2086  # options are words
  "$weft" render --graph "$root/graphs/$graph.json" --size 960x540 $options -o "$scratch/$graph.png" </dev/null
  # A palette small enough would dither, which looks like the renderer's own noise.
  convert "$scratch/$graph.png" -strip -sampling-factor 4:4:4 -quality 91 "$here/images/gallery/$graph.jpg"
  # shellcheck disable=SC2016  # the shell's own backquotes stay
  {
    printf '\n## %s\n\n![%s](images/gallery/%s.jpg)\n\n' "$title" "$alt" "$graph"
    cat
    printf '\n[`graphs/%s.json`](../graphs/%s.json), %d lines\n\n```\n./weft render --graph graphs/%s.json%s\n```\n' \
      "$graph" "$graph" "$(wc -l <"$root/graphs/$graph.json")" "$graph" "${options:+ $options}"
  } >>"$scratch/gallery.md"
}

show bloom "Bloom" "A court at night: lamps, candles and lanterns glow softly" "--time 22" <<'END'
A lens scatters a share of all light that comes in. The picture is halved six times by a filter that weighs every texel
alike, and on the way back each mip mixes with the next coarser one, in place. The result replaces a share of the picture:
no threshold, and no light that wasn't there. Repeats over the mips make the chain two passes, and the last mix is a blend
state.
END

show taa "Temporal anti-aliasing" "The court in the late sun; wires, railings and leaves have no stairs" "" <<'END'
`"jitter": 16` lets each frame look through other points of its pixels, and `resolved[-1]` is what the earlier ones saw.
Velocities of the nearest surface say where that was, Catmull-Rom weights keep it sharp, and what lies outside of the mean
and deviation of this frame's neighbours, in YCoCg, is clipped. What stands still ends at the mean of its frames.
END

show dof "Depth of field" "A fountain in focus before a court at night; lamps become discs of light" "--time 22" <<'END'
The picture is parted at half resolution into what is blurred behind the focus and what is blurred before it, each
multiplied by its share before anything is filtered (Liu 2016, "Rendering 'Monster Hunter Online'"). What is sharp weighs
nothing, so a bright edge in focus sheds no halo over what lies behind it, and what a blurred leaf hides is guessed from
beside it. The lens is a premultiplied blend over the picture.
END

show edges "Edges" "The court as a pale drawing: outlines in ink, creases in red" "" <<'END'
A view for finding faults. Ink is where depth jumps: near plane over distance runs straight across the screen on any
plane, so only ends of surfaces have a second difference, and steep floors stay clean. Red is where the normals bend.
Where leaf lies on leaf the ink is thinned. The lit picture stays faintly below.
END

show reaction_diffusion "Reaction and diffusion" "Worms and rings of enamel, cream and coral on dark blue" "" <<'END'
Gray and Scott's two chemicals on a grid of their own, without a scene: one feeds, one eats. A repeat takes 64 steps a
frame between the two layers of an image that is kept from frame to frame. Feed and kill drift across the dish, so that
rings, worms and mazes meet. The dish is drawn as a lit relief.
END

show fjord "Fjord" "A sunrise behind mountains, mirrored in still water" "" <<'END'
A picture in the spirit of shader toys, also without a scene. One pass raises the land, ridge upon ridge; one marches
four rays for each pixel over it, through mist, with shadows, clouds, and a mirrored ray where it meets water; one draws
shafts of light out of the sun, and the last develops the film.
END

mv "$scratch/gallery.md" "$here/gallery.md"
