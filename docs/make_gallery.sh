#!/usr/bin/env bash
# Renders the pictures of the README and of the gallery, and writes docs/gallery.md. Requires ImageMagick. Check each picture
# before you commit it.
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

Pictures of graphs that consist only of JSON and GLSL: except for the upload of lights, none of them has C++ code of its own.
`docs/make_gallery.sh` renders the pictures and writes this page.
END

draw() {
  local picture=$1
  shift
  "$weft" render --size 960x540 "$@" -o "$picture" </dev/null
}

draw "$here/images/atrium.png"
draw "$here/images/atrium-night.png" --time 22
draw "$here/images/ink.png" --graph "$here/examples/ink.json" --param penWidth=2

# PICTURE GRAPH TITLE ALT [OPTION…], the description on stdin.
show() {
  local picture=$1 graph=graphs/$2.json title=$3 alt=$4
  shift 4
  draw "$scratch/$picture.png" --graph "$root/$graph" "$@"
  # A PNG with a small palette would need dithering, which looks like noise of the renderer.
  convert "$scratch/$picture.png" -strip -sampling-factor 4:4:4 -quality 91 "$here/images/gallery/$picture.jpg"
  # shellcheck disable=SC2016  # the shell's own backquotes stay
  {
    printf '\n## %s\n\n![%s](images/gallery/%s.jpg)\n\n' "$title" "$alt" "$picture"
    cat
    printf '\n[`%s`](../%s), %d lines\n\n```\n./weft render --graph %s' "$graph" "$graph" "$(wc -l <"$root/$graph")" "$graph"
    for option in "$@"; do
      case $option in *' '*) printf ' "%s"' "$option" ;; *) printf ' %s' "$option" ;; esac
    done
    printf '\n```\n'
  } >>"$scratch/gallery.md"
}

show light_indexed light_indexed "A thousand lights" "The court at night in the light of 1,024 coloured lamps" \
  builtin:lights --lights 1024 --time 22 <<'END'
Points, spots, tubes and rectangles, each with a range. For each tile of 16 × 16 pixels, light culling lists the lamps that
reach a surface in the tile. The light of each pixel is the sum over its tile's list, equal in every bit to the sum over all
lamps. [Thousands of lights](lights.md) describes the method.
END

show lights_per_tile light_indexed "Lights per tile" "A heat map of the same view: how many lamps each tile lists" \
  builtin:lights --lights 1024 --time 22 --debug "Lights per tile" <<'END'
A debug view of the same frame. Of 1,024 lamps a tile evaluates about 20; a tile of sky evaluates none.
END

show stage forward_plus "Kinds of lamps" "A stage: a neon tube, a lit window, leaves thrown on a wall, a lantern's spots" \
  builtin:stage <<'END'
A spot that projects the shadow of leaves, a rectangle with barn doors, two tubes, and a lantern with holes and a custom
falloff. One loop evaluates all of them, here in forward+, and any number of them may move.
END

show bloom bloom "Bloom" "A court at night: lamps, candles and lanterns glow softly" --time 22 <<'END'
A lens scatters a share of all incoming light. The picture is halved six times with a filter that gives every texel the same
weight; on the way back each mip is mixed with the next coarser one, in place. The result replaces a share of the picture,
without a threshold and without additional light. Repeats over the mips make the chain two passes, and the last mix is a
blend state.
END

show taa taa "Temporal anti-aliasing" "The court in the sun; wires, railings and leaves have no stairs" <<'END'
With `"jitter": 16`, each frame samples its pixels at different points, and `resolved[-1]` is the result of earlier frames.
Velocities of the nearest surface give its earlier position, Catmull-Rom weights keep it sharp, and values outside the mean
and deviation of this frame's neighbours, in YCoCg, are clipped. Still parts of the picture converge to the mean of the frames.
END

show dof dof "Depth of field" "A fountain in focus before a court at night; lamps become discs of light" --time 22 <<'END'
At half resolution the picture is split into a layer blurred behind the focus and a layer blurred in front of it, each
multiplied by its share before filtering (Liu 2016, "Rendering 'Monster Hunter Online'"). Sharp parts have no weight, so a
bright edge in focus causes no halo on the surfaces behind it, and colours hidden by a blurred leaf are estimated from its
surroundings. The gather reads every pixel in its range, unfiltered, so each lamp is a uniform disc of its own size. The
result is blended over the picture with premultiplied alpha.
END

show edges edges "Edges" "The court as a pale drawing: outlines in ink, creases in red" <<'END'
A view for finding faults. Black lines mark jumps of depth: near plane divided by distance is linear in screen space on any
plane, so only the ends of surfaces have a second difference, and steep floors have no lines. Red lines mark creases. Among
leaves the lines are lighter. The lit picture is faintly visible below.
END

show reaction_diffusion reaction_diffusion "Reaction and diffusion" "Worms and rings of enamel, cream and coral on dark blue" <<'END'
Gray and Scott's two chemicals on a grid, without a scene: one is food, the other consumes it. A repeat takes 64 steps per
frame between the two layers of an image that is kept from frame to frame. The rates `feed` and `kill` vary across the dish,
which therefore shows rings, worms and mazes. The dish is drawn as a lit relief.
END

show fjord fjord "Fjord" "A sunrise behind mountains, mirrored in still water" <<'END'
A procedural picture, also without a scene. One pass computes the height of the land; one marches four rays per pixel over it,
with mist, shadows, clouds, and a reflected ray at the water; one adds light shafts from the sun, and the last one applies a
film curve.
END

mv "$scratch/gallery.md" "$here/gallery.md"
