#!/usr/bin/env python3
"""Switches off one part of the light after the other (parts of the probes, and the near field), and compares the pictures with a path tracer.

usage: ablation.py WEFT

Each part must bring the picture nearer to the reference: without it, L1 (see compare.py) is larger by a factor. The
scenes: a court with red and green walls under half a roof, and a ball of metal among other objects, both in the sun.
"""
import json
import math
import pathlib
import sys
import tempfile

import compare

FOLDER = pathlib.Path(__file__).resolve().parent
# Regular grids of probes: with fewer probes than Weft places, this takes less time.
COURT = {"origin": [-3.9, -0.6, -3.9], "spacing": 1.3, "size": [7, 4, 7]}
DIORAMA = {"origin": [-2.4, -0.4, -1.8], "spacing": 0.8, "size": [7, 4, 6]}
REFLECTIONS = [{"position": [0.25, 0.75, 0.75]}, {"position": [-1.25, 0.75, -0.25]}]
# The ball of metal in the diorama.
BALL, BALL_RADIUS = (0.25, 0.5, -0.5), 0.5
# The least factor by which L1 grows if a part is switched off.
LEAST_FACTOR = 1.05


def probes_in(folder, name, volume, reflections):
    path = folder / (name + ".probes.json")
    path.write_text(json.dumps({"version": 1, "volume": volume, "reflections": reflections}))
    return ["--probes", str(path)]


def variants(folder):
    """Returns lists of variants for references: part, options and graph; first with all parts, then without one of them."""
    court = probes_in(folder, "court", COURT, [])
    diorama = probes_in(folder, "diorama", DIORAMA, REFLECTIONS)
    near = FOLDER / "near.json"
    return [
        ("court-day", [("all parts", court, "deferred"),
                       ("no visibility of probes", court, FOLDER / "no_visibility.json"),
                       ("no bounces", court + ["--param", "probeFeedback=0"], "deferred"),
                       ("no volume", ["--probes", "none"], "deferred")]),
        ("diorama-day", [("all parts", diorama, "deferred"),
                         ("no reflection probes", probes_in(folder, "plain", DIORAMA, []), "deferred")]),
        ("court-day", [("with near field", ["--probes", "auto"], near), ("no near field", ["--probes", "auto"], "deferred")])]


def ball_pixels(reference):
    """Returns the pixels of the ball of metal in the diorama, within 95 % of its radius."""
    numbers = [float(x) for x in reference["camera"].split(",")]
    (width, height), eye, at = reference["size"], numbers[0:3], numbers[3:6]
    forward = unit([b - a for a, b in zip(eye, at)])
    right = unit(cross(forward, [0, 1, 0]))
    up, high = cross(right, forward), math.tan(math.radians(numbers[6]) / 2)
    to_ball, found = [b - a for a, b in zip(eye, BALL)], []
    for y in range(height):
        for x in range(width):
            u, v = high * (2 * x + 1 - width) / height, high * (height - 2 * y - 1) / height
            way = unit([f + u * r + v * w for f, r, w in zip(forward, right, up)])
            if math.dist(cross(way, to_ball), (0, 0, 0)) < 0.95 * BALL_RADIUS:
                found.append((x, y))
    return found


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    return [x / math.dist(v, (0, 0, 0)) for x in v]


def compared(weft, reference, graph, folder):
    """Returns sum and L1 of the court, or of the ball in the diorama."""
    if reference["scene"] != "diorama":
        return compare.compared(weft, reference, graph, folder)
    found = compare.render(weft, reference, graph, folder)[2]
    wanted = compare.read_radiance(FOLDER / "pictures" / (reference["name"] + ".hdr"))[2]
    pixels = ball_pixels(reference)
    return compare.difference([found[y][x] for x, y in pixels], [wanted[y][x] for x, y in pixels])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    compare.skip_unless_extended()
    references = {reference["name"]: reference for reference in compare.references()}
    failed = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for name, parts in variants(folder):
            whole = None
            for part, options, graph in parts:
                reference = dict(references[name], options=options)
                summed, l1 = compared(sys.argv[1], reference, graph, folder)
                print("%-14s %-26s sum %+.4f  L1 %.4f" % (name, part, summed, l1), flush=True)
                if whole is not None and l1 < LEAST_FACTOR * whole:
                    failed.append("%s, %s" % (name, part))
                whole = l1 if whole is None else whole
    if failed:
        sys.exit("without these parts, the error is not larger by a factor of %g: %s" % (LEAST_FACTOR, "; ".join(failed)))


if __name__ == "__main__":
    main()
