#!/usr/bin/env python3
"""Writes the scenes (glTF) and the environment pictures (Radiance) of the references into this folder.

usage: make_scenes.py

The files are in the repository. Run this script only to change them, and then render the references again (make.sh).
Names of materials choose the BSDF of the path tracer: D… diffuse, M… metal, P… plastic; see cycles.py.
"""
import base64
import json
import math
import pathlib
import struct

FOLDER = pathlib.Path(__file__).resolve().parent


# ---------------------------------------------------------------- meshes: lists of positions, normals and indices

def sphere(centre, radius, columns=64, rows=32):
    positions, normals, indices = [], [], []
    for row in range(rows + 1):
        polar = math.pi * row / rows
        for column in range(columns + 1):
            azimuth = 2 * math.pi * column / columns
            n = (math.sin(polar) * math.sin(azimuth), math.cos(polar), math.sin(polar) * math.cos(azimuth))
            normals.append(n)
            positions.append(tuple(c + radius * x for c, x in zip(centre, n)))
    for row in range(rows):
        for column in range(columns):
            a = row * (columns + 1) + column
            b = a + columns + 1
            indices += [a, b, a + 1, a + 1, b, b + 1]
    return positions, normals, indices


def box(low, high):
    positions, normals, indices = [], [], []
    for axis in range(3):
        for side in (0, 1):
            n = [0, 0, 0]
            n[axis] = 2 * side - 1
            u, v = (axis + 1) % 3, (axis + 2) % 3
            start = len(positions)
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                p = [0.0] * 3
                p[axis] = (low, high)[side][axis]
                p[u] = (low, high)[du][u]
                p[v] = (low, high)[dv][v]
                positions.append(tuple(p))
                normals.append(tuple(n))
            order = (0, 1, 2, 0, 2, 3) if side else (0, 2, 1, 0, 3, 2)
            indices += [start + i for i in order]
    return positions, normals, indices


def write_gltf(name, objects):
    """Writes NAME.gltf. `objects`: list of (mesh, material name, colour, metalness, roughness)."""
    data, views, accessors, meshes, nodes, materials = b"", [], [], [], [], []

    def accessor(values, kind, code):
        nonlocal data
        flat = [x for v in values for x in v] if kind == "VEC3" else values
        blob = struct.pack("<%d%s" % (len(flat), code), *flat)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(blob)})
        entry = {"bufferView": len(views) - 1, "componentType": 5126 if code == "f" else 5123,
                 "count": len(values), "type": kind}
        if kind == "VEC3":
            entry["min"] = [min(v[i] for v in values) for i in range(3)]
            entry["max"] = [max(v[i] for v in values) for i in range(3)]
        data += blob + b"\0" * (-len(blob) % 4)
        accessors.append(entry)
        return len(accessors) - 1

    for (positions, normals, indices), material, colour, metalness, roughness in objects:
        materials.append({"name": material, "pbrMetallicRoughness": {
            "baseColorFactor": [*colour, 1], "metallicFactor": metalness, "roughnessFactor": roughness}})
        if material[0] == "D":  # A diffuse surface without a coat.
            materials[-1]["extensions"] = {"KHR_materials_specular": {"specularFactor": 0}}
        primitive = {"attributes": {"POSITION": accessor(positions, "VEC3", "f"),
                                    "NORMAL": accessor(normals, "VEC3", "f")},
                     "indices": accessor(indices, "SCALAR", "H"), "material": len(materials) - 1}
        meshes.append({"primitives": [primitive]})
        nodes.append({"mesh": len(meshes) - 1})
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    document = {"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_materials_specular"], "scene": 0,
                "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
                "materials": materials, "accessors": accessors, "bufferViews": views,
                "buffers": [{"byteLength": len(data), "uri": uri}]}
    (FOLDER / "scenes" / (name + ".gltf")).write_text(json.dumps(document, separators=(",", ":")) + "\n")


def write_scenes():
    ball = sphere((0, 0, 0), 1)
    write_gltf("matt", [(ball, "D", (0.8, 0.5, 0.3), 0, 1)])
    write_gltf("plastic", [(ball, "P", (0.6, 0.12, 0.05), 0, 0.3)])
    for roughness in (0.1, 0.25, 0.4):
        write_gltf("metal_%03d" % round(1000 * roughness), [(ball, "M", (1, 0.78, 0.34), 1, roughness)])
    white, red, green = (0.75, 0.75, 0.75), (0.65, 0.12, 0.08), (0.15, 0.45, 0.12)
    # A court of 6 m × 6 m: three walls of 3 m, half a roof, no wall towards +z.
    write_gltf("court", [
        (box((-3, -0.1, -3), (3, 0, 3)), "D floor", white, 0, 1),
        (box((-3.2, 0, -3), (-3, 3, 3)), "D left", red, 0, 1),
        (box((3, 0, -3), (3.2, 3, 3)), "D right", green, 0, 1),
        (box((-3.2, 0, -3.2), (3.2, 3, -3)), "D back", white, 0, 1),
        (box((-3.2, 3, -3.2), (3.2, 3.2, 0)), "D roof", white, 0, 1),
        (box((-1.8, 0, -1.6), (-0.6, 1.2, -0.4)), "D box", white, 0, 1),
        (sphere((1.1, 0.6, -0.6), 0.6, 48, 24), "D ball", (0.5, 0.5, 0.7), 0, 1)])
    # A diorama: unlike objects of all three kinds of material on a plate.
    write_gltf("diorama", [
        (box((-2.2, -0.2, -1.6), (2.2, 0, 1.6)), "D plate", (0.5, 0.45, 0.4), 0, 1),
        (box((-2.0, 0, -1.5), (2.0, 1.6, -1.3)), "D wall", white, 0, 1),
        (box((-1.9, 0, -1.3), (-1.6, 1.2, -0.2)), "D side", red, 0, 1),
        (box((-1.9, 1.2, -1.3), (-0.5, 1.35, -0.2)), "D shelf", white, 0, 1),
        (box((-0.8, 0, -1.3), (-0.5, 1.2, -1.0)), "D post", white, 0, 1),
        (sphere((0.25, 0.5, -0.5), 0.5, 48, 24), "M ball", (0.95, 0.9, 0.85), 1, 0.25),
        (sphere((1.35, 0.4, -0.3), 0.4, 48, 24), "P ball", (0.1, 0.2, 0.6), 0, 0.3),
        (box((-1.1, 0, 0.2), (-0.4, 0.5, 0.9)), "P box", (0.6, 0.5, 0.1), 0, 0.5),
        (sphere((0.5, 0.25, 0.7), 0.25, 32, 16), "D ball", green, 0, 1)])
    # Boxes on a metal floor, which mirrors them.
    for roughness in (0.05, 0.25):
        write_gltf("floor_%03d" % round(1000 * roughness), [
            (box((-4, -0.1, -4), (4, 0, 4)), "M floor", (0.9, 0.88, 0.85), 1, roughness),
            (box((-1.6, 0, -1.4), (-0.6, 1.1, -0.6)), "D red", red, 0, 1),
            (box((-0.2, 0, -2.2), (0.7, 1.6, -1.5)), "D white", white, 0, 1),
            (box((1.1, 0, -0.9), (1.8, 0.7, -0.2)), "D green", green, 0, 1),
            (box((-0.7, 0, 0.4), (-0.3, 0.35, 0.8)), "D yellow", (0.7, 0.6, 0.1), 0, 1),
            (sphere((0.6, 0.4, 0.3), 0.4, 48, 24), "D ball", (0.5, 0.5, 0.7), 0, 1)])


# ---------------------------------------------------------------- environment pictures
# Row 0 is up (+y), the middle column is −z, +x is to the right of it. Units: cd/m².

WIDTH, HEIGHT = 256, 128


def direction(column, row):
    azimuth = ((column + 0.5) / WIDTH - 0.5) * 2 * math.pi
    polar = (row + 0.5) / HEIGHT * math.pi
    return (math.sin(polar) * math.sin(azimuth), math.cos(polar), -math.sin(polar) * math.cos(azimuth))


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return tuple(x / length for x in v)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def day(d):
    """A blue sky with a haze around a sun of 2° radius, over brown ground. The sun gives half of the light."""
    to_sun = unit((0.5, 0.6, 0.4))
    near_sun = max(dot(d, to_sun), 0)
    if near_sun > math.cos(math.radians(2)):
        return (850, 760, 620)
    if d[1] < 0:
        return (0.35, 0.28, 0.2)
    haze = 3 * near_sun ** 40 + (1 - d[1]) ** 4
    return tuple(s + h * haze for s, h in zip((0.45, 0.8, 1.7), (1.3, 1.2, 1.0)))


def overcast(d):
    """A sky whose zenith is three times as bright as its horizon, over dark ground."""
    if d[1] < 0:
        return (0.2, 0.2, 0.18)
    return tuple(c * (1 + 2 * d[1]) / 3 for c in (1.9, 2.0, 2.2))


def studio(d):
    """A dark room with a warm and a cold soft box and a narrow strip of light."""
    def inside(at, right, width, height):
        at, right = unit(at), unit(right)
        up = (at[1] * right[2] - at[2] * right[1], at[2] * right[0] - at[0] * right[2],
              at[0] * right[1] - at[1] * right[0])
        depth = dot(d, at)
        return depth > 0 and abs(dot(d, right)) < width * depth and abs(dot(d, up)) < height * depth
    if inside((1, 0.7, 0.8), (0.8, 0, -1), 0.45, 0.3):
        return (9, 7.4, 5.6)
    if inside((-1, 0.2, 0.3), (0.3, 0, 1), 0.3, 0.6):
        return (2.4, 3.2, 4.6)
    if inside((0, 1, -0.4), (1, 0, 0), 0.8, 0.08):
        return (14, 14, 14)
    return tuple(0.12 + 0.06 * d[1] for _ in range(3))


def window(d):
    """A dark room with a large window behind the camera, which is much brighter than 30 times the median."""
    at = unit((0.5, -0.1, 1))
    right = unit((1, 0, -0.5))
    up = (at[1] * right[2] - at[2] * right[1], at[2] * right[0] - at[0] * right[2], at[0] * right[1] - at[1] * right[0])
    depth = dot(d, at)
    if depth > 0 and abs(dot(d, right)) < 0.35 * depth and abs(dot(d, up)) < 0.8 * depth:
        return (4, 4.5, 5)
    return (0.02, 0.018, 0.016)


def rgbe(colour):
    largest = max(colour)
    if largest < 1e-32:
        return (0, 0, 0, 0)
    mantissa, exponent = math.frexp(largest)
    scale = mantissa * 256 / largest
    return tuple(min(255, int(c * scale + 0.5)) for c in colour) + (exponent + 128,)


def coded(values):
    """Run-length code of one channel of a row."""
    out, i = bytearray(), 0
    while i < len(values):
        run = 1
        while i + run < len(values) and run < 127 and values[i + run] == values[i]:
            run += 1
        if run >= 3:
            out += bytes((128 + run, values[i]))
            i += run
            continue
        start = i
        while i < len(values) and i - start < 128 and len(set(values[i:i + 3])) + 2 * (i + 2 >= len(values)) > 1:
            i += 1
        i = max(i, start + 1)
        out += bytes((i - start,)) + bytes(values[start:i])
    return bytes(out)


def write_environment(name, radiance):
    data = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (HEIGHT, WIDTH)
    for row in range(HEIGHT):
        # The mean over 4 × 4 points of a texel.
        texels = []
        for column in range(WIDTH):
            points = [radiance(direction(column + (i - 1.5) / 4, row + (j - 1.5) / 4))
                      for i in range(4) for j in range(4)]
            texels.append(rgbe([sum(p[c] for p in points) / 16 for c in range(3)]))
        data += bytes((2, 2, WIDTH >> 8, WIDTH & 255))
        for channel in range(4):
            data += coded([t[channel] for t in texels])
    (FOLDER / "environments" / (name + ".hdr")).write_bytes(data)


if __name__ == "__main__":
    (FOLDER / "scenes").mkdir(exist_ok=True)
    (FOLDER / "environments").mkdir(exist_ok=True)
    write_scenes()
    for light in (day, overcast, studio, window):
        write_environment(light.__name__, light)
