// A graph with images whose sizes follow a live scale.
#pragma once

#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {

class LiveTest : public ResolveTest {
 protected:
    LiveTest() {
        shaders["paint"] =
            with_params(fragment({"color"}), {member("size", 2), member("k"), member("renderScale")});
        shaders["make"] = with_params(compute({image_out("dst")}), {member("dstSize", 2)});
        shaders["shrink"] = with_params(
            compute({sampled("src"), image_out("dst")}),
            {member("srcSize", 2), member("srcUv", 2), member("srcUvMost", 2), member("steps"), member("i")});
        shaders["show"] = fragment({"color"}, {sampled("src"), sampled("before")});
    }

    // Returns the text of the graph with more members of the pass "paint", such as ", \"state\": {}".
    static std::string body(const std::string& paint = "", const std::string& resources = "") {
        return R"j("imports": {"backbuffer": "output"},
"params": {"renderScale": {"default": 1, "range": [0.25, 1]}, "gain": {"default": 2, "range": [1, 4]}},
"consts": {"k": "gain * render.x"},
"sizes": {"render": {"size": "output", "scale": "renderScale"}, "half": "ceil(render / 2)"},
"resources": {"color": "rgba16f", "low": {"format": "rgba16f", "size": "half", "mips": 3},
  "other": {"format": "rgba16f", "size": "ceil(render/2)"}, "past": {"format": "rgba16f", "history": 2})j" +
               resources + R"j(},
"passes": {
  "paint": {"type": "fullscreen", "shader": "paint", "out": {"color": "color"},
            "params": {"size": "render"})j" +
               paint + R"j(},
  "shrink": {"type": "compute", "shader": "shrink", "in": {"src": "color"}, "out": {"dst": "low.mip(0)"},
             "params": {"steps": "render.x / half.x * gain", "i": 0}},
  "down": {"type": "compute", "shader": "shrink", "repeat": {"i": "1..2"}, "in": {"src": "low.mip(i - 1)"},
           "out": {"dst": "low.mip(i)"}, "threads": ["half.x + i", "half.y", 1], "params": {"steps": "i"}},
  "copy": {"type": "copy", "queue": "transfer", "in": {"src": "low.mip(0)"}, "out": {"dst": "other"}},
  "keep": {"type": "blit", "in": {"src": {"ref": "other", "sampler": {"filter": "nearest"}}}, "out": {"dst": "past"}},
  "show": {"type": "fullscreen", "shader": "show", "in": {"src": "past", "before": "past[-1]"},
           "out": {"color": "backbuffer"}}})j";
    }
};

}  // namespace weft::test
