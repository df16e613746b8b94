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

This page shows pictures of graphs that consist only of JSON and GLSL. Only the pass that uploads the lights to the GPU
is written in C++. The script `docs/make_gallery.sh` renders the pictures and writes this page.
END

draw() {
  local picture=$1
  shift
  "$weft" render --size 960x540 "$@" -o "$picture" </dev/null
}

draw "$here/images/atrium.png" --graph "$root/graphs/weft.json"
draw "$here/images/atrium-night.png" --graph "$root/graphs/weft.json" --time 22
for tier in low medium high ultra; do  # For docs/tiers.md.
  draw "$scratch/$tier.png" --graph "$root/graphs/weft.json" --tier "$tier"
  convert "$scratch/$tier.png" -strip -sampling-factor 4:4:4 -quality 91 "$here/images/gallery/tier-$tier.jpg"
done
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
The scene has 1,024 lamps: points, spots, tubes and rectangles, each with a limited range. The picture is divided into
tiles of 16 × 16 pixels. For each tile, a culling pass lists the lamps that reach a surface in the tile. Each pixel then
adds only the light of the lamps in its tile's list. The result is bit for bit the same as the sum over all lamps.
[Thousands of lights](lights.md) describes the method.
END

show lights_per_tile light_indexed "Lights per tile" "A heat map of the same view: how many lamps each tile lists" \
  builtin:lights --lights 1024 --time 22 --debug "Lights per tile" <<'END'
This debug view of the same frame shows how many lamps each tile lists. Of the 1,024 lamps, a tile lists about 20; a
tile that shows only sky lists none.
END

show stage forward_plus "Kinds of lamps" "A stage: a neon tube, a lit window, leaves thrown on a wall, a lantern's spots" \
  builtin:stage <<'END'
The scene contains a spot that projects the shadow of leaves, a rectangle with barn doors, two tubes, and a lantern with
holes and a custom falloff curve. One loop in the shader evaluates all these kinds of lamps, and any number of the lamps
may move. This picture is rendered with forward+ (forward shading with lists of lamps per tile).
END

show materials weft "Hair, silk, ice and paper" "A table: hair on a stand, silk, blocks of ice, a lantern, two balls of plaster" \
  builtin:materials <<'END'
The G-buffer has no room for these materials, so a forward pass draws them over the lit picture. Hair and silk are rough
in one direction. The tips of the hair are transparent and get the same light as the strands. Ice and paper show the
light from behind, scattered. The right ball of plaster is rough, so it looks flatter than the left one. [Ice, paper and
plaster](scenes.md#ice-paper-and-plaster) lists what a material needs.
END

show bloom bloom "Bloom" "A court at night: lamps, candles and lanterns glow softly" --time 22 <<'END'
Bloom imitates a lens, which scatters a share of all incoming light. The picture is halved six times, with a filter that
gives every texel the same weight. On the way back to full size, each mip is mixed in place with the next coarser mip.
The result replaces a share of the picture, so bloom needs no threshold and adds no light. The graph needs only one
entry to halve the mips and one entry to mix them, because each entry is a repeat over the mips. The tone curve mixes the
result with the picture. The module `graphs/modules/bloom.json` does all of this.
END

show reflections reflections "Reflections of the screen" "The pool mirrors the fountain, the columns and the curtains" \
  --camera pool <<'END'
Surfaces mirror what the picture shows. From each surface, a ray follows the depth image until it meets another surface,
and takes its light from the previous frame. Rough surfaces choose another direction in each frame, and the rays of
neighbours and of earlier frames are averaged. Where a ray leaves the picture, the reflection probes answer. The module
`graphs/modules/reflections.json` does this for every graph with a G-buffer; see [Reflections of the
screen](reflections.md).
END

show water weft "Water" "A pool from its end: tiles bent by ripples, lilies, and the mirrored court" \
  --camera=0.3,1.2,3.9,-0.1,0.3,-0.5,60 <<'END'
Two layers of a normal map move over the water. The surface bends the picture behind it, the water absorbs red light, and
the rest is mirrored. [Glass and water](scenes.md#glass-and-water) lists what a material needs. `weft.json` is the frame
with everything: shadows, light probes, near field, reflections and temporal anti-aliasing, in four [tiers](tiers.md).
END

show taa taa "Temporal anti-aliasing" "The court in the sun; wires, railings and leaves have no stairs" <<'END'
With `"jitter": 16`, each frame samples its pixels at different points. The history `resolved[-1]` is the result of
earlier frames. For each pixel, the shader takes the velocity of the nearest surface around the pixel and finds where
this surface was in the previous frame. Catmull-Rom weights keep the history sharp. The shader clips the colour from the
history to a range of colours in YCoCg: the middle of the range is the mean of the neighbour pixels in this frame, and
the standard deviation of these pixels gives the size of the range. Parts of the picture that do not move converge to
the mean of the frames. Where all pixels of a tile of 8 × 8 pixels become brighter or darker by about the same factor,
the light has changed, and the tile begins a new mean. The same happens where a lamp goes on or off. The module
`graphs/modules/taa.json` does all of this, for every graph that has `hdr`, `velocity` and `depth`.
[Anti-aliasing](anti-aliasing.md) describes it, and a faster method without history.
END

show dof dof "Depth of field" "A fountain in focus before a court at night; lamps become discs of light" --time 22 <<'END'
At half resolution, the picture is split into two layers: the surfaces behind the focus, and the surfaces in front of
the focus. Before a layer is filtered, each colour is multiplied by a weight from 0 (sharp) to 1 (blurred) (Liu 2016,
"Rendering 'Monster Hunter Online'"). Sharp parts of the picture have the weight 0, so a bright edge in focus causes no
halo on the surfaces behind it. Colours that a blurred leaf hides are estimated from the surroundings of the leaf. The
blur reads every pixel in its range without filtering, so each lamp becomes a uniform disc of its own size. The result
is blended over the picture with premultiplied alpha.
END

show edges edges "Edges" "The court as a pale drawing: outlines in ink, creases in red" <<'END'
This view helps to find mistakes in a scene. Black lines mark jumps of depth. The shader divides the distance of the
near plane by the distance of the pixel, and computes the second difference of this quotient. On a flat surface the
quotient is linear in screen space, so its second difference is zero. So even a floor at a grazing angle gets no lines;
only the ends of surfaces do. Red lines mark creases. Lines among leaves are lighter. The lit picture is faintly visible
under the lines.
END

show reaction_diffusion reaction_diffusion "Reaction and diffusion" "Worms and rings of enamel, cream and coral on dark blue" <<'END'
The graph simulates Gray and Scott's reaction of two chemicals on a grid, without a scene: the first chemical is food,
and the second chemical consumes the food. A repeat computes 64 steps per frame. The image of the grid has two layers;
each step reads one layer and writes the other. The image keeps its content from frame to frame. The rates `feed` and
`kill` of the reaction vary across the grid, so the picture shows rings, worms and mazes. The grid is drawn as a lit
relief in a dish.
END

show fjord fjord "Fjord" "A sunrise behind mountains, mirrored in still water" <<'END'
This procedural picture also needs no scene. The first pass computes the height of the land. The second pass marches
four rays per pixel over the land; it adds mist, shadows, clouds, and a reflected ray at the water. The third pass adds
light shafts from the sun, and the last pass applies a film curve.
END

mv "$scratch/gallery.md" "$here/gallery.md"
