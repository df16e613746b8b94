#!/usr/bin/env python3
"""Compares a picture of Weft with one of Cycles; atrium.sh calls it.

usage: atrium.py FOLDER

FOLDER has weft.pfm, the radiance in cd/m² multiplied by 2^EXPOSURE_EV, and cycles-sky.hdr and cycles-lamps.hdr, whose
sum is the radiance. weft-sun.pfm and cycles-sun.hdr have the light that comes directly from the sun. The table shows
the mean luminance of regions of the picture. `rest` is the light without that of weft-sun.pfm or cycles-sun.hdr: the
light of the sky and of other surfaces. Below are the differences of the whole picture (see README.md). Both pictures
are written with the same tone curve.
"""
import pathlib
import sys

import numpy
from PIL import Image

from compare import FOLDER, difference, medians, read_pfm, read_radiance

EXPOSURE_EV = -12
LUMINANCE = numpy.array([0.2126, 0.7152, 0.0722])
JPEG_QUALITY = 88


def display(radiance):
    """The tone curve and the encoding of srgb.glsl."""
    x = radiance * 2.0 ** EXPOSURE_EV
    toned = numpy.clip(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0, 1)
    encoded = numpy.where(toned <= 0.0031308, 12.92 * toned, 1.055 * toned ** (1 / 2.4) - 0.055)
    return (encoded * 255 + 0.5).astype("u1")


def print_regions(pictures):
    print("%-22s %23s %23s %23s" % ("", "all light", "direct light of the sun", "rest"))
    print("%-22s" % "region" + " %8s %7s %6s" % ("Weft", "Cycles", "ratio") * 3 + "   red  green  blue of all light")
    for line in (FOLDER / "atrium_regions.txt").read_text().splitlines():
        if line.startswith("#"):
            continue
        name, *box = line.split()
        left, top, right, bottom = map(int, box)
        weft, cycles, weft_sun, cycles_sun = (p[top:bottom, left:right].mean((0, 1)) for p in pictures)
        pairs = [(weft, cycles), (weft_sun, cycles_sun), (weft - weft_sun, cycles - cycles_sun)]
        cells = [(a @ LUMINANCE, b @ LUMINANCE) for a, b in pairs]
        print("%-22s" % name + "".join(" %8.1f %7.1f %6s" % (a, b, "%.2f" % (a / b) if b > 1 else "-") for a, b in cells) +
              "   " + "  ".join("%.2f" % ratio for ratio in weft / cycles))


def read_weft(path):
    return numpy.array(read_pfm(path)[2])


def read_cycles(path):
    return numpy.array(read_radiance(path)[2])


def print_differences(weft, cycles):
    height, width, _ = weft.shape
    pixels = [picture.reshape(-1, 3).tolist() for picture in (weft, cycles)]
    blocks = [medians(picture.tolist(), width, height) for picture in (weft, cycles)]
    print("pixels:            sum %+.4f   L1 %.4f" % difference(*pixels))
    print("medians of blocks: sum %+.4f   L1 %.4f" % difference(*blocks))


def main():
    folder = pathlib.Path(sys.argv[1])
    weft = read_weft(folder / "weft.pfm") / 2.0 ** EXPOSURE_EV
    cycles = read_cycles(folder / "cycles-sky.hdr") + read_cycles(folder / "cycles-lamps.hdr")
    print_regions((weft, cycles, read_weft(folder / "weft-sun.pfm"), read_cycles(folder / "cycles-sun.hdr")))
    print_differences(weft, cycles)
    for name, picture in (("weft", weft), ("cycles", cycles)):
        image = Image.fromarray(display(picture))
        image.save(folder / ("path-traced-%s.png" % name))
        image.save(folder / ("path-traced-%s.jpg" % name), quality=JPEG_QUALITY)


main()
