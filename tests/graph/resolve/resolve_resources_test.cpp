// Tests parameters, sizes, extents, mip levels, buffers, imports and formats.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveResources : public ResolveTest {
 protected:
    ResolveResources() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["any.comp"] = compute({image_out("dst", Format::undefined)});
        shaders["fill.comp"] = compute({buffer("dst", false, true)});
        shaders["read.comp"] = compute({sampled("src"), image_out("dst")});
    }

    // Returns a graph with one image "x" that has these members, and a pass that clears "x".
    std::string image(const std::string& keys, const std::string& before = "") {
        return before + R"j("resources": {"x": {"format": "rgba16f", )j" + keys +
               R"j(}}, "passes": {"c": {"type": "clear", "out": ["x"]}})j";
    }
    std::string buffer_of(const std::string& element, const std::string& count) {
        return R"j("consts": {"n": 100}, "resources": {"x": {"buffer": ")j" + element + R"j(", "count": ")j" +
               count + R"j("}}, "passes": {"c": {"type": "clear", "out": ["x"]}})j";
    }
};

TEST_F(ResolveResources, DefaultSizeIsRenderElseOutput) {
    EXPECT_EQ(resource_in(good(image(R"j("mips": 1)j")), "x").extent, (Extent3D{640, 360, 1}));
    const ResolvedGraph g = good(image(R"j("mips": 1)j", R"j("sizes": {"render": "ceil(output * 0.5)"},)j"));
    EXPECT_EQ(resource_in(g, "x").extent, (Extent3D{320, 180, 1}));
}

TEST_F(ResolveResources, SizesMayReferToEachOtherInAnyOrder) {
    const ResolvedGraph g =
        good(image(R"j("size": "a")j", R"j("sizes": {"a": "b / 2", "b": "c / 2", "c": "output"},)j"));
    EXPECT_EQ(resource_in(g, "x").extent, (Extent3D{160, 90, 1}));
}

TEST_F(ResolveResources, SizesInACircle) {
    const Diagnostic d = bad(image(R"j("size": "a")j", R"j("sizes": {"a": "b / 2", "b": "a"},)j"));
    EXPECT_EQ(d.code, "W106");
    EXPECT_NE(d.message.find("a -> b -> a"), std::string::npos) << d.message;
}

TEST_F(ResolveResources, ExtentsAndMipsAreClamped) {
    const ResolvedGraph g = good(image(R"j("size": "output / 10000", "mips": 9)j"));
    EXPECT_EQ(resource_in(g, "x").extent, (Extent3D{1, 1, 1}));
    EXPECT_EQ(resource_in(g, "x").mips, 1u);
    EXPECT_EQ(resource_in(good(image(R"j("mips": "full")j")), "x").mips, 10u);
    EXPECT_EQ(resource_in(good(image(R"j("mips": 99)j")), "x").mips, 10u);
}

TEST_F(ResolveResources, MipsOfAnotherResource) {
    const ResolvedGraph g = good(R"j("resources": {
        "z": {"format": "r32f", "mips": "full"},
        "a": {"format": "rgba16f", "mips": "mips(z) - 2"}},
      "passes": {"c": {"type": "clear", "out": ["z", "a"]}})j");
    EXPECT_EQ(resource_in(g, "a").mips, 8u);
}

TEST_F(ResolveResources, TooLargeForTheDevice) {
    const Diagnostic d = bad(image(R"j("size": "output * 100")j"));
    EXPECT_EQ(d.code, "W119");
    EXPECT_NE(d.message.find("64000x36000"), std::string::npos) << d.message;
}

TEST_F(ResolveResources, MipOutOfRangeNamesTheValidOnes) {
    const Diagnostic d = bad(R"j(
"resources": {"x": {"format": "rgba16f", "mips": 4}},
"passes": {"c": {"type": "clear", "out": {"dst": "x.mip(4)"}}})j");
    EXPECT_EQ(d.code, "W105");
    EXPECT_EQ(d.line, 3u);
    EXPECT_EQ(d.message, R"j(mip 4 of "x" is out of range)j");
    expect_help(d, "mips 0 to 3");
}

TEST_F(ResolveResources, LayerOutOfRange) {
    const Diagnostic d = bad(R"j("resources": {"x": {"format": "rgba16f", "layers": 3}},
      "passes": {"c": {"type": "clear", "out": {"dst": "x.layer(1..3)"}}})j");
    EXPECT_EQ(d.code, "W105");
    expect_help(d, "layers 0 to 2");
}

TEST_F(ResolveResources, BuffersHaveNoMips) {
    const Diagnostic d = bad(R"j("resources": {"x": {"buffer": "u32", "count": 4}},
      "passes": {"c": {"type": "clear", "out": {"dst": "x.mip(0)"}}})j");
    EXPECT_EQ(d.code, "W105");
}

TEST_F(ResolveResources, BufferBytes) {
    EXPECT_EQ(resource_in(good(buffer_of("u32", "n")), "x").size_bytes, 400u);
    EXPECT_EQ(resource_in(good(buffer_of("vec4", "n * 2")), "x").size_bytes, 3200u);
    const ResolvedGraph g = good(buffer_of("Light", "output.x / 64"));
    EXPECT_EQ(resource_in(g, "x").stride_bytes, 48u);
    EXPECT_EQ(resource_in(g, "x").size_bytes, 480u);
}

TEST_F(ResolveResources, BufferFaults) {
    EXPECT_EQ(bad(buffer_of("Ligth", "1")).code, "W116");
    expect_help(bad(buffer_of("Ligth", "1")), "did you mean \"Light\"");
    EXPECT_EQ(bad(buffer_of("mat4", "n * 1000000000000000000")).code, "W119");
    EXPECT_EQ(bad(buffer_of("u32", "output")).code, "W106");
    EXPECT_EQ(bad(buffer_of("u32", "m")).code, "W107");
}

TEST_F(ResolveResources, ParametersAndTheirOverrides) {
    const std::string body = image(R"j("size": "output * scale")j",
                                   R"j("params": {"scale": {"default": 1, "range": [0.25, 1]}},)j");
    params["scale"] = 0.5;
    const ResolvedGraph g = good(body);
    EXPECT_EQ(resource_in(g, "x").extent, (Extent3D{320, 180, 1}));
    ASSERT_EQ(g.params.size(), 1u);
    EXPECT_EQ(g.params[0].value, 0.5);
    params["scale"] = 2;
    const Diagnostic range = bad(body);
    EXPECT_EQ(range.code, "W120");
    expect_help(range, "0.25 to 1");
    params = {{"scael", 1}};
    const Diagnostic unknown = bad(body);
    EXPECT_EQ(unknown.code, "W120");
    expect_help(unknown, "did you mean \"scale\"");
}

TEST_F(ResolveResources, ParameterOfAClosedSet) {
    params["n"] = 3;
    const Diagnostic d =
        bad(image(R"j("mips": "n")j", R"j("params": {"n": {"default": 1, "enum": [1, 2]}},)j"));
    EXPECT_EQ(d.code, "W120");
    expect_help(d, "1, 2");
}

TEST_F(ResolveResources, OneWrongSizeIsOneError) {
    const Diagnostic d = bad(image(R"j("size": "a")j", R"j("sizes": {"a": "b", "b": "otput"},)j"));
    EXPECT_EQ(d.code, "W107");
    expect_help(d, "output");
}

TEST_F(ResolveResources, ImportUnknownOrOfTheWrongKind) {
    const Diagnostic unknown = bad(R"j("imports": {"opaqe": "drawlist"}, "passes": {})j");
    EXPECT_EQ(unknown.code, "W118");
    expect_help(unknown, "did you mean \"opaque\"");
    const Diagnostic kind = bad(R"j("imports": {"instances": "image"}, "passes": {})j");
    EXPECT_EQ(kind.code, "W118");
    expect_help(kind, R"j("instances": "buffer")j");
}

TEST_F(ResolveResources, DrawListsAreNoResources) {
    const Diagnostic d = bad(R"j("imports": {"opaque": "drawlist"}, "resources": {"y": "rgba16f"}, "passes": {
      "c": {"type": "compute", "shader": "read.comp", "in": {"src": "opaque"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W103");
    expect_help(d, "\"draws\"");
}

TEST_F(ResolveResources, TurnsAreNoResources) {
    const Diagnostic d = bad(R"j("imports": {"spin": "turns"}, "resources": {"y": "rgba16f"}, "passes": {
      "c": {"type": "compute", "shader": "read.comp", "in": {"src": "spin"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(d.code, "W103");
    expect_help(d, "\"turns\" of a group");
}

TEST_F(ResolveResources, FirstFormatThatServesAllUsages) {
    const ResolvedGraph g = good(R"j("resources": {"x": "rgba8_srgb|rgba8", "y": "rgba16f"}, "passes": {
      "a": {"type": "compute", "shader": "any.comp", "out": {"dst": "x"}},
      "b": {"type": "compute", "shader": "read.comp", "in": {"src": "x"}, "out": {"dst": "y"}}})j");
    EXPECT_EQ(resource_in(g, "x").format, Format::rgba8);
    EXPECT_EQ(resource_in(g, "x").usage, usage::kStorage | usage::kSampled);
}

TEST_F(ResolveResources, NoFormatServes) {
    const Diagnostic d = bad(R"j("resources": {"x": "rgba8_srgb|d32f"}, "passes": {
      "a": {"type": "compute", "shader": "any.comp", "out": {"dst": "x"}}})j");
    EXPECT_EQ(d.code, "W117");
    expect_help(d, R"j("rgba8_srgb" does not support storage images)j");
    expect_help(d, R"j("d32f" does not support storage images)j");
}

TEST_F(ResolveResources, DefaultSamplerNeedsAFilterableFormat) {
    profile.formats[Format::r32f] &= ~format_feature::kSampledLinear;
    const auto body = [](const std::string& port) {
        return R"j("resources": {"x": "r32f", "y": "rgba16f"}, "passes": {
          "a": {"type": "clear", "out": ["x"]},
          "b": {"type": "compute", "shader": "read.comp", "in": {"src": )j" +
               port + R"j(}, "out": {"dst": "y"}}})j";
    };
    EXPECT_EQ(bad(body(R"j("x")j")).code, "W117");
    const ResolvedGraph g = good(body(R"j({"ref": "x", "sampler": {"filter": "nearest"}})j"));
    EXPECT_EQ(use(g, "b", "src").sampler.filter, SamplerFilter::nearest);
}

TEST_F(ResolveResources, UnusedResourceIsAWarning) {
    good(
        R"j("resources": {"x": "rgba16f", "y": "rgba16f"}, "passes": {"c": {"type": "clear", "out": ["x"]},
            "r": {"type": "readback", "in": ["x"]}})j");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].code, "W130");
    EXPECT_EQ(warnings[0].severity, Severity::warning);
    EXPECT_NE(warnings[0].message.find("\"y\""), std::string::npos);
}

TEST_F(ResolveResources, ObservedNameThatDoesNotExist) {
    observed = {"hrd"};
    const Diagnostic d =
        bad(R"j("resources": {"hdr": "rgba16f"}, "passes": {"c": {"type": "clear", "out": ["hdr"]}})j");
    EXPECT_EQ(d.code, "W103");
    expect_help(d, "did you mean \"hdr\"");
}

}  // namespace
}  // namespace weft::test
