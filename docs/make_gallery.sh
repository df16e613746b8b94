#!/usr/bin/env bash
# Draws the pictures of the README and of the gallery, and writes docs/gallery.md. Needs ImageMagick. Look at each picture before you commit
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

What graphs can do with JSON and GLSL alone: but for the upload of lights none of these has a line of C++ of its own.
`docs/make_gallery.sh` draws the pictures and writes this page.
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
  # A palette small enough would dither, which looks like the renderer's own noise.
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
Points, spots, tubes and panes, each with a range. Light culling lists for each tile of 16 × 16 pixels the lamps that reach
a surface in it, and the light of each pixel is the sum over its tile's list: the same to the last bit as if all had been
asked. [Thousands of lights](lights.md) says how.
END

show lights_per_tile light_indexed "Lights per tile" "A heat map of the same view: how many lamps each tile lists" \
  builtin:lights --lights 1024 --time 22 --debug "Lights per tile" <<'END'
A debug view of the same frame. Among 1,024 lamps a tile asks about 20; sky asks none.
END

show stage forward_plus "What lamps can be" "A stage: a neon tube, a lit window, leaves thrown on a wall, a lantern's spots" \
  builtin:stage <<'END'
A spot that throws the shadow of leaves, a rectangle with barn doors, two tubes, and a lantern with holes and a falloff of
its own. All of them go through one loop, here in forward+, and any number of them may move.
END

show bloom bloom "Bloom" "A court at night: lamps, candles and lanterns glow softly" --time 22 <<'END'
A lens scatters a share of all light that comes in. The picture is halved six times by a filter that weighs every texel
alike, and on the way back each mip mixes with the next coarser one, in place. The result replaces a share of the picture:
no threshold, and no light that wasn't there. Repeats over the mips make the chain two passes, and the last mix is a blend
state.
END

show taa taa "Temporal anti-aliasing" "The court in the sun; wires, railings and leaves have no stairs" <<'END'
`"jitter": 16` lets each frame look through other points of its pixels, and `resolved[-1]` is what the earlier ones saw.
Velocities of the nearest surface say where that was, Catmull-Rom weights keep it sharp, and what lies outside of the mean
and deviation of this frame's neighbours, in YCoCg, is clipped. What stands still ends at the mean of its frames.
END

show dof dof "Depth of field" "A fountain in focus before a court at night; lamps become discs of light" --time 22 <<'END'
The picture is parted at half resolution into what is blurred behind the focus and what is blurred before it, each
multiplied by its share before anything is filtered (Liu 2016, "Rendering 'Monster Hunter Online'"). What is sharp weighs
nothing, so a bright edge in focus sheds no halo over what lies behind it, and what a blurred leaf hides is guessed from
beside it. The gather reads every pixel in reach, unfiltered: each lamp is an even disc of the size of its own circle. The
lens is a premultiplied blend over the picture.
END

show edges edges "Edges" "The court as a pale drawing: outlines in ink, creases in red" <<'END'
A view for finding faults. Ink is where depth jumps: near plane over distance runs straight across the screen on any
plane, so only ends of surfaces have a second difference, and steep floors stay clean. Red is where the normals bend.
Where leaf lies on leaf the ink is thinned. The lit picture stays faintly below.
END

show reaction_diffusion reaction_diffusion "Reaction and diffusion" "Worms and rings of enamel, cream and coral on dark blue" <<'END'
Gray and Scott's two chemicals on a grid of their own, without a scene: one feeds, one eats. A repeat takes 64 steps a
frame between the two layers of an image that is kept from frame to frame. Feed and kill drift across the dish, so that
rings, worms and mazes meet. The dish is drawn as a lit relief.
END

show fjord fjord "Fjord" "A sunrise behind mountains, mirrored in still water" <<'END'
A picture in the spirit of shader toys, also without a scene. One pass raises the land, ridge upon ridge; one marches
four rays for each pixel over it, through mist, with shadows, clouds, and a mirrored ray where it meets water; one draws
shafts of light out of the sun, and the last develops the film.
END

mv "$scratch/gallery.md" "$here/gallery.md"
