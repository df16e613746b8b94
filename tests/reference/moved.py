#!/usr/bin/env python3
"""Moves and turns a whole scene, with its environment and its camera, and compares the pictures.

usage: moved.py WEFT

The light of probes depends on where the probes stand. They move with the scene, so the picture must stay the same.
The table shows for each motion the L1 of compare.py between the pictures of the moved scene and of the scene as it is.
"""
import json
import math
import pathlib
import sys
import tempfile

import compare
import make_scenes

# Limit of L1. With a grid of probes that stood still in the world, it was up to 0.108.
MOST_L1 = 0.03
# The environment is turned by whole columns, so that no texel is interpolated.
COLUMNS = 26
# Name of the motion, its way in metres, and the number of columns by which everything is turned around +y.
MOTIONS = [("as it is", (0, 0, 0), 0), ("half a spacing", (0.25, 0.25, 0.25), 0), ("turned", (0, 0, 0), COLUMNS)]


def turned(point, angle):
    """Returns the point after a turn by `angle` around +y, clockwise as seen from above, as columns of an environment."""
    c, s = math.cos(-angle), math.sin(-angle)
    return [c * point[0] + s * point[2], point[1], -s * point[0] + c * point[2]]


def moved_reference(reference, way, columns, folder):
    """Writes the scene and the environment after the motion, and returns the reference with these."""
    angle = 2 * math.pi * columns / make_scenes.WIDTH
    place = str(folder / ("%d-%s" % (columns, "-".join("%g" % x for x in way))))
    scene = json.loads((compare.FOLDER / "scenes" / (reference["scene"] + ".gltf")).read_text())
    scene["nodes"].append({"children": scene["scenes"][0]["nodes"], "translation": way,
                           "rotation": [0, math.sin(-angle / 2), 0, math.cos(angle / 2)]})
    scene["scenes"][0]["nodes"] = [len(scene["nodes"]) - 1]
    pathlib.Path(place + ".gltf").write_text(json.dumps(scene))
    environment = folder / ("day-%d" % columns)
    if not environment.with_suffix(".hdr").exists():
        make_scenes.write_environment(str(environment), lambda d: make_scenes.day(turned(d, -angle)))
    camera = [float(x) for x in reference["camera"].split(",")]
    eye, at = ([a + b for a, b in zip(turned(point, angle), way)] for point in (camera[0:3], camera[3:6]))
    return dict(reference, scene=place, environment=str(environment), camera=",".join("%r" % x for x in eye + at + camera[6:]))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    compare.skip_unless_extended()
    reference = next(r for r in compare.references() if r["name"] == "court-day")
    failed, still = [], None
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for name, way, columns in MOTIONS:
            width, height, rows = compare.render(sys.argv[1], moved_reference(reference, way, columns, folder),
                                                 "deferred", folder)
            picture = compare.medians(rows, width, height)
            still = still or picture
            l1 = compare.difference(picture, still)[1]
            print("%-16s L1 %.4f" % (name, l1), flush=True)
            if l1 > MOST_L1:
                failed.append(name)
    if failed:
        sys.exit("the picture depends on where the scene stands: " + ", ".join(failed))


if __name__ == "__main__":
    main()
