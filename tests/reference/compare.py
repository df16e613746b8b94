#!/usr/bin/env python3
"""Renders the scenes of the references with Weft and compares the pictures with those of a path tracer.

usage: compare.py WEFT [WORD...] [--graph NAME] [--keep FOLDER] [--report]

WEFT is the program `weft`. WORD: only the references whose names contain it; without WORD, and without WEFT_EXTENDED
in the environment, only those in QUICK. The table shows for each reference:
  sum     Σ Weft / Σ reference − 1, over all channels and the compared pixels: see README.md
  L1      Σ |Weft − reference| / Σ reference
Both are taken of the absolute radiance; no factor is fitted. --graph NAME: the graph for all scenes (default: `reflections` for floors, `deferred` for the
others). Without --report, only those references are compared that
pictures.txt marks as `held`. The exit code is 1 if one of these exceeds its limit. --keep keeps the pictures (PFM).
"""
import argparse
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent
GRAPHS = FOLDER.parent.parent / "graphs"
# Limits of |sum| and L1 for pictures of a sphere under an environment, and of L1 for all other scenes.
MOST_SUM, MOST_L1, MOST_SCENE_L1 = 0.03, 0.10, 0.15
# Limits of L1 for the pixels of a metal floor with boxes, drawn with the graph `reflections`: by the scene.
MOST_FLOOR_L1 = {"floor_050": 0.12, "floor_250": 0.10}
# Weft renders spheres and floors with this number of samples for each pixel along each axis, because it takes one sample for each
# pixel of its picture, and the path tracer takes the mean over a pixel.
SAMPLES = 4
# Parts of the names of the references that every test run compares.
QUICK = ["matt-day", "court-day", "diorama-day", "plastic-day", "plastic-studio", "metal_250-day", "metal_250-studio", "metal_100-day", "metal_400-day", "floor_250-studio"]
# Exit codes: of `weft` without a Vulkan device, and of a test that is skipped.
NO_DEVICE, SKIPPED = 4, 77


def read_radiance(path):
    """Returns width, height and rows of (r, g, b) of a Radiance picture with run-length codes."""
    data = path.read_bytes()
    at = data.index(b"\n\n") + 2
    end = data.index(b"\n", at)
    words = data[at:end].split()
    height, width, at, rows = int(words[1]), int(words[3]), end + 1, []
    for _ in range(height):
        at, channels = at + 4, []
        for _ in range(4):
            channel = []
            while len(channel) < width:
                count = data[at]
                if count > 128:
                    channel += [data[at + 1]] * (count - 128)
                    at += 2
                else:
                    channel += data[at + 1:at + 1 + count]
                    at += 1 + count
            channels.append(channel)
        rows.append([tuple(m * 2.0 ** (e - 136) if e else 0.0 for m in (r, g, b)) for r, g, b, e in zip(*channels)])
    return width, height, rows


def read_pfm(path):
    data = path.read_bytes()
    kind, size, scale, values = data.split(b"\n", 3)
    width, height = (int(x) for x in size.split())
    assert kind == b"PF" and float(scale) < 0
    floats = struct.unpack("<%df" % (3 * width * height), values[:12 * width * height])
    rows = [[floats[3 * (y * width + x):3 * (y * width + x) + 3] for x in range(width)] for y in range(height)]
    return width, height, rows[::-1]  # PFM begins with the lowest row.


def radiance_of(graph):
    """Returns the resource with the radiance: with temporal anti-aliasing, `hdr` is a single sample for each pixel."""
    return "resolved" if "modules/taa.json" in graph.read_text() else "hdr"


def skip_unless_extended():
    """Ends the test: it takes longer than CI may, so only `./weft test --extended` runs it."""
    if "WEFT_EXTENDED" not in os.environ:
        print("only with WEFT_EXTENDED")
        sys.exit(SKIPPED)


def render(weft, reference, graph, folder, resource=None):
    """Returns width, height and rows of a resource of the graph. `resource`: by default, the radiance."""
    graph = graph if isinstance(graph, pathlib.Path) else GRAPHS / (graph + ".json")
    out = folder / (reference["name"] + "-" * bool(resource) + (resource or "") + ".pfm")
    command = [weft, "render", FOLDER / "scenes" / (reference["scene"] + ".gltf"),
               "--graph", graph,
               "--env", FOLDER / "environments" / (reference["environment"] + ".hdr"),
               "--exposure", "0", "--size", "%dx%d" % tuple(n * reference["samples"] for n in reference["size"]), "--camera", reference["camera"],
               "--resource", resource or radiance_of(graph), "--timeout", "1200", "-o", out, *reference["options"]]
    run = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if run.returncode == NO_DEVICE:
        print(run.stderr)
        sys.exit(SKIPPED)
    if run.returncode != 0:
        sys.exit("%s\n%s%s" % (" ".join(str(c) for c in command), run.stdout, run.stderr))
    return averaged(*read_pfm(out), reference["samples"])


def averaged(width, height, rows, samples):
    """Returns the picture with each block of samples × samples pixels as one pixel: the mean."""
    if samples == 1:
        return width, height, rows
    result = []
    for y in range(0, height, samples):
        block = [[p for row in rows[y:y + samples] for p in row[x:x + samples]] for x in range(0, width, samples)]
        result.append([tuple(sum(channel) / samples ** 2 for channel in zip(*pixels)) for pixels in block])
    return width // samples, height // samples, result


def sphere_pixels(width, height, camera):
    """Returns the pixels within 95 % of the radius of the unit sphere at the origin."""
    numbers = [float(x) for x in camera.split(",")]
    distance = math.sqrt(sum((a - b) ** 2 for a, b in zip(numbers[0:3], numbers[3:6])))
    radius = 0.95 * (height / 2) * math.tan(math.asin(1 / distance)) / math.tan(math.radians(numbers[6] / 2))
    return [(x, y) for y in range(height) for x in range(width)
            if math.hypot(x + 0.5 - width / 2, y + 0.5 - height / 2) < radius]


def medians(rows, width, height):
    """Returns the medians of blocks of 4 × 4 pixels, for each channel: they remove single bright paths."""
    result = []
    for y in range(0, height - 3, 4):
        for x in range(0, width - 3, 4):
            block = [rows[y + j][x + i] for j in range(4) for i in range(4)]
            result.append([sorted(p[c] for p in block)[8] for c in range(3)])
    return result


def floor_pixels(material):
    """Returns the pixels that show only metal: the floor. `material`: rows of (occlusion, roughness, metalness)."""
    return [(x, y) for y, row in enumerate(material) for x, texel in enumerate(row) if texel[2] > 0.999]


def difference(weft, reference):
    total = sum(sum(p) for p in reference)
    summed = sum(sum(p) for p in weft) / total - 1
    l1 = sum(abs(a - b) for p, q in zip(weft, reference) for a, b in zip(p, q)) / total
    return summed, l1


def references():
    for line in (FOLDER / "pictures.txt").read_text().splitlines():
        words = line.split()
        if not words or words[0] == "#":
            continue
        name, scene, environment, width, height, _, bounces, scattering, camera, state = words
        options = ["--param", "multipleScattering=0"] if scattering == "single" else []
        if bounces == "0":
            options += ["--probe-rounds", "1"]  # Further rounds add only reflected light, and a sphere sees none.
        is_floor = scene in MOST_FLOOR_L1
        yield {"name": name, "scene": scene, "environment": environment, "size": (int(width), int(height)),
               "camera": camera, "options": options, "is_sphere": bounces == "0", "is_floor": is_floor,
               "samples": SAMPLES if bounces == "0" or is_floor else 1, "is_held": state == "held"}


def compared(weft, reference, graph, folder):
    graph = graph or ("reflections" if reference["is_floor"] else "deferred")
    width, height, found = render(weft, reference, graph, folder)
    size_and_rows = read_radiance(FOLDER / "pictures" / (reference["name"] + ".hdr"))
    assert size_and_rows[:2] == (width, height)
    wanted = size_and_rows[2]
    if reference["is_floor"]:
        pixels = floor_pixels(render(weft, reference, "deferred", folder, "orm")[2])
        return difference([found[y][x] for x, y in pixels], [wanted[y][x] for x, y in pixels])
    if not reference["is_sphere"]:
        return difference(medians(found, width, height), medians(wanted, width, height))
    pixels = sphere_pixels(width, height, reference["camera"])
    return difference([found[y][x] for x, y in pixels], [wanted[y][x] for x, y in pixels])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("weft")
    parser.add_argument("words", nargs="*")
    parser.add_argument("--graph")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--report", action="store_true")
    a = parser.parse_args()
    words, failed = a.words or ([] if a.report or "WEFT_EXTENDED" in os.environ else QUICK), 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = a.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        print("%-26s %8s %8s" % ("reference", "sum", "L1"))
        for reference in references():
            if words and not any(word in reference["name"] for word in words):
                continue
            if not reference["is_held"] and not a.report:
                continue
            summed, l1 = compared(a.weft, reference, a.graph, folder)
            exceeds = abs(summed) > MOST_SUM or l1 > MOST_L1 if reference["is_sphere"] else \
                l1 > MOST_FLOOR_L1.get(reference["scene"], MOST_SCENE_L1)
            failed += exceeds and reference["is_held"]
            print("%-26s %+8.4f %8.4f%s" % (reference["name"], summed, l1, "  exceeds the limit" if exceeds else ""))
    if failed:
        sys.exit("%d references that are `held` exceed their limits" % failed)


if __name__ == "__main__":
    main()
