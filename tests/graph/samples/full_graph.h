// Contains the text of a graph that uses most keys of the graph format. It has no tiers, debug views or
// tests.
#pragma once

namespace weft::test {

inline constexpr const char* kFullGraph = R"json({
  "$schema": "weft.schema.json", "version": 1, "name": "full", "frames": 4, "jitter": 8,
  "imports": { "opaque": "drawlist", "backbuffer": { "kind": "output" },
    "probeTurns": "turns" },
  "consts": { "tile": 16 },
  "params": { "scale": { "default": 0.5, "enum": [0.5, 1], "step": 0.5, "unit": "EV", "ui": "A/B" }, "on": true },
  "sizes": { "render": "ceil(output * scale)", "fixed": [64, "tile * 2"] },
  "resources": {
    "albedo": "rgba8_srgb", "depth": "d32f", "normal": "rg16_snorm|rgba16f",
    "hdr": { "format": "rgba16f", "size": "render", "mips": "full", "layers": 6, "clear": [0, 0, 0, 1],
             "preExposed": true },
    "acc": { "format": "rgba16f", "history": 2, "firstFrame": [0, 0, 0, 1], "onResize": "resample" },
    "probes": { "buffer": "vec4", "count": 9, "keep": "shared", "firstFrame": 1 },
    "hdrMs": { "format": "rgba16f", "samples": 4 }, "sky": { "format": "rgba16f", "cube": 128, "mips": 7 },
    "fog": { "format": "rgba16f", "kind": "3d", "size": 64, "depth": 32 }, "args": { "buffer": "u32", "count": 3 },
    "lights": { "buffer": "Light", "count": "tile * tile" }
  },
  "passes": {
    "gbuffer": { "type": "raster", "draws": ["opaque"], "shader": "gbuffer", "depth": { "ref": "depth", "clear": 0 },
      "out": ["normal", "albedo"], "view": "camera",
      "state": { "cull": "material", "frontFace": "cw", "topology": "lines", "fill": "line", "depth": "less_equal",
                 "depthClamp": true, "depthBias": { "constant": 1, "slope": 2 }, "scissor": [0, 1, 20, 30],
                 "stencil": { "compare": "equal", "pass": "replace", "reference": 7 },
                 "blend": { "albedo": "add" }, "writeMask": { "normal": "rg" } } },
    "light": { "type": "compute", "shader": "light.comp", "queue": "async", "groups": ["tile", 1, 1],
      "in": { "n": { "ref": "normal@gbuffer", "else": "hdr.mip(0)", "optional": true,
                     "sampler": { "filter": "nearest", "wrap": "repeat", "compare": "greater_equal" } } },
      "out": { "hdr": "hdr.mip(0).layer(0..5)" }, "params": { "a": "scale + 1", "b": [1, 2, "tile"], "c": true },
      "after": ["gbuffer"], "if": "on", "repeat": { "i": "0..1", "j": "tile-1..0 by -1" },
      "constants": { "N": "tile", "FAST": true }, "cost": { "flops": "100 * output.x" }, "partial": true,
      "switch": "!on" },
    "show": { "type": "fullscreen", "shader": "show.frag", "in": ["hdr"], "out": ["backbuffer"], "covers": true,
      "state": { "blend": { "color": ["src_alpha", "add", "one"], "alpha": ["zero", "max", "one"] },
                 "writeMask": "rgb" } },
    "upload": { "type": "light_upload", "out": ["lights"], "params": { "n": 3 } },
    "lines": { "type": "raster", "draws": ["opaque"], "shader": "lines", "out": ["hdrMs"],
      "resolve": { "hdr.mip(0).layer(0)": "hdrMs" } },
    "indirect": { "type": "compute", "shader": "light.comp", "groups": { "indirect": "args" }, "out": ["fog"] },
    "culled": { "type": "raster", "draws": { "list": "opaque", "indirect": "args" }, "shader": "lines", "out": ["hdrMs"] },
    "shrink": { "type": "blit", "in": { "src": "hdr.mip(0)" }, "out": { "dst": "hdr.mip(1)" } },
    "wipe": { "type": "clear", "out": ["hdr"], "clear": 1 }
  },
  "groups": {
    "relight": {
      "repeat": { "m": "0..5" }, "perFrame": 2, "turns": "probeTurns", "warmUp": 3, "rest": true, "settle": 1,
      "resources": { "raw": { "format": "rgba16f", "size": 128, "mips": 3 }, "low": { "format": "r8", "mips": "mips(raw)" } },
      "passes": {
        "gather": { "type": "compute", "shader": "light.comp", "in": { "bounce": { "ref": "sky", "wakes": false } },
          "out": { "dst": "raw.mip(mips(raw)-3)" } },
        "filter": { "type": "compute", "shader": "light.comp", "in": ["raw@gather"], "out": { "dst": "sky.layer(m)" },
          "repeat": { "k": "0..1" }, "after": ["gather", "wipe"] } } } }
})json";

}  // namespace weft::test
