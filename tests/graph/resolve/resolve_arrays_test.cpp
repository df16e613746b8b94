// Tests ports that are arrays in the shader: one element for each mip or layer of the range.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

ShaderBinding array_of(ShaderBinding binding, uint32_t count) {
    binding.count = count;
    binding.is_array = true;
    return binding;
}

class ResolveArrays : public ResolveTest {
 protected:
    ResolveArrays() {
        shaders["write.comp"] = with_params(compute({array_of(image_out("dst", Format::r32f), 4)}),
                                            {member("dstCount", 1, ScalarType::u32), member("dstSize", 2)});
        shaders["in_place.comp"] = compute({array_of(image_in_out("dst", Format::r32f), 4)});
        shaders["read.comp"] = compute({array_of(sampled("src"), 3), image_out("dst")});
        shaders["scalar.comp"] = compute({image_out("dst", Format::r32f)});
        shaders["draw.frag"] = fragment({"dst"});
    }

    // Returns a graph in which pass "w" writes to the port "dst". Its reference is on line 3.
    static std::string writing(const std::string& port, const std::string& shader = "write.comp",
                               const std::string& type = "compute", const std::string& read = "x") {
        return R"j("resources": {"x": {"format": "r32f", "size": [100, 60], "mips": 5, "layers": 3}},
"passes": {"w": {"type": ")j" +
               type + R"j(", "shader": ")j" + shader + "\", \"out\": {\"dst\":\n" + port +
               R"j(}}, "r": {"type": "readback", "in": [")j" + read + "\"]}}";
    }

    static const ParamWrite& param(const PassDecl& pass, const char* name) {
        static const ParamWrite none;
        for (const ParamWrite& p : pass.params)
            if (p.member == name) return p;
        ADD_FAILURE() << "no member " << name;
        return none;
    }
};

TEST_F(ResolveArrays, ThePlanHasOneUseOfTheRange) {
    const ResolvedGraph g = good(writing(R"j({"ref": "x.mip(1..3).layer(1)", "each": "mip"})j", "write.comp",
                                         "compute", "x.mip(1..3).layer(1)"));
    const UseDecl& written = use(g, "w", "dst");
    EXPECT_EQ(written.each, EachPart::mip);
    EXPECT_EQ(written.range, (SubresourceRange{1, 3, 1, 1, aspect::kColor}));
    EXPECT_EQ(element_count(written), 3u);
    EXPECT_EQ(element_range(written, 0), (SubresourceRange{1, 1, 1, 1, aspect::kColor}));
    EXPECT_EQ(element_range(written, 2), (SubresourceRange{3, 1, 1, 1, aspect::kColor}));
    EXPECT_EQ(element_range(written, 3), element_range(written, 2)) << "a spare element shows the last mip";
    const PassDecl& pass = pass_in(g, "w");
    EXPECT_EQ(param(pass, "dstCount").value[0], 3);
    EXPECT_EQ(param(pass, "dstSize").value[0], 50) << "the size of element 0";
    EXPECT_EQ(param(pass, "dstSize").value[1], 30);
    EXPECT_EQ(pass.groups, (std::array<uint32_t, 3>{7, 4, 1}));
}

TEST_F(ResolveArrays, EachLayerIsAnElement) {
    const ResolvedGraph g =
        good(writing(R"j({"ref": "x.mip(2)", "each": "layer"})j", "write.comp", "compute", "x.mip(2)"));
    const UseDecl& written = use(g, "w", "dst");
    EXPECT_EQ(element_count(written), 3u);
    EXPECT_EQ(element_range(written, 1), (SubresourceRange{2, 1, 1, 1, aspect::kColor}));
    EXPECT_EQ(pass_in(g, "w").groups[2], 1u) << "the elements are no third dimension";
}

TEST_F(ResolveArrays, AnArrayCanBeModifiedInPlace) {
    const ResolvedGraph g = good(
        R"j("resources": {"x": {"format": "r32f", "mips": 4}}, "passes": {
"c": {"type": "clear", "out": ["x"]},
"w": {"type": "compute", "shader": "in_place.comp", "in": {"dst": {"ref": "x", "each": "mip"}},
      "out": {"dst": {"ref": "x", "each": "mip"}}},
"r": {"type": "readback", "in": ["x"]}})j");
    EXPECT_EQ(use(g, "w", "dst").each, EachPart::mip);
    EXPECT_EQ(seen(g, "w", "dst"), "c");
    const Diagnostic error = bad(
        R"j("resources": {"x": {"format": "r32f", "mips": 4}}, "passes": {
"c": {"type": "clear", "out": ["x"]},
"w": {"type": "compute", "shader": "in_place.comp", "in": {"dst": "x"},
      "out": {"dst": {"ref": "x", "each": "mip"}}},
"r": {"type": "readback", "in": ["x"]}})j");
    EXPECT_EQ(error.code, "W165");
}

TEST_F(ResolveArrays, AnArrayOfSamplersTakesElseAndStaysOneUse) {
    const auto reading = [](const std::string& condition) {
        return R"j("resources": {"a": {"format": "r32f", "mips": 3}, "b": {"format": "r32f", "mips": 2}, "y": "rgba16f"},
"passes": {"ca": {"type": "clear", "out": ["a"], "if": )j" +
               condition + R"j(}, "cb": {"type": "clear", "out": ["b"]},
"f": {"type": "compute", "shader": "read.comp", "out": {"dst": "y"},
      "in": {"src": {"ref": "a", "else": "b", "each": "mip"}}}, "r": {"type": "readback", "in": ["y"]}})j";
    };
    EXPECT_EQ(element_count(use(good(reading("1")), "f", "src")), 3u);
    EXPECT_EQ(element_count(use(good(reading("0")), "f", "src")), 2u);
    EXPECT_EQ(use(good(reading("1")), "f", "src").sampler.mip_filter, SamplerFilter::nearest)
        << "an element has one mip";
}

struct BadArray {
    const char* name;
    const char* port;
    const char* shader;
    const char* type;
    const char* code;
    const char* message;
    const char* help;
};
void PrintTo(const BadArray& bad, std::ostream* out) {
    *out << bad.port;
}
class ResolveBadArray : public ResolveArrays, public testing::WithParamInterface<BadArray> {};

TEST_P(ResolveBadArray, IsRefusedAtThePort) {
    const BadArray& b = GetParam();
    const Diagnostic error = bad(writing(b.port, b.shader, b.type, "x.mip(0)"));
    EXPECT_EQ(error.code, b.code);
    EXPECT_EQ(error.line, 3u) << error.message;
    EXPECT_NE(error.message.find(b.message), std::string::npos) << error.message;
    expect_help(error, b.help);
}

constexpr BadArray kBadArrays[]{
    {"WithoutEach", R"j("x.mip(0).layer(0)")j", "write.comp", "compute", "W196", "has no \"each\"",
     "\"each\": \"mip\""},
    {"WithoutArray", R"j({"ref": "x.mip(0..1).layer(0)", "each": "mip"})j", "scalar.comp", "compute", "W196",
     "is not an array", "dst[2]"},
    {"Short", R"j({"ref": "x.layer(0)", "each": "mip"})j", "write.comp", "compute", "W196", "has 5 mips",
     "dst[5]"},
    {"Attachment", R"j({"ref": "x.mip(0).layer(0)", "each": "mip"})j", "draw.frag", "fullscreen", "W196",
     "not an image that the shader", "remove"},
    {"TooManyLayers", R"j({"ref": "x.mip(0..1)", "each": "mip"})j", "write.comp", "compute", "W173",
     "3 layers", "layer(0)"},
    {"TooManyMips", R"j({"ref": "x", "each": "layer"})j", "write.comp", "compute", "W173", "one mip",
     "mip(0)"},
};
INSTANTIATE_TEST_SUITE_P(All, ResolveBadArray, testing::ValuesIn(kBadArrays),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(ResolveArrays, APassWithoutAShaderHasNoArrays) {
    const Diagnostic error = bad(
        R"j("resources": {"x": "r32f", "y": "r32f"}, "passes": {"c": {"type": "clear", "out": ["x"]},
"p": {"type": "copy", "in": {"src": {"ref": "x", "each": "mip"}}, "out": {"dst": "y"}},
"r": {"type": "readback", "in": ["y"]}})j");
    EXPECT_EQ(error.code, "W196");
    EXPECT_NE(error.message.find("copy pass"), std::string::npos) << error.message;
}

TEST_F(ResolveArrays, EachElementCountsForTheLimitOfTheDevice) {
    profile.max_storage_images_per_stage = 4;
    good(writing(R"j({"ref": "x.mip(0..1).layer(0)", "each": "mip"})j", "write.comp", "compute",
                 "x.mip(0..1).layer(0)"));
    profile.max_storage_images_per_stage = 3;
    const Diagnostic error = bad(writing(R"j({"ref": "x.mip(0..1).layer(0)", "each": "mip"})j"));
    EXPECT_EQ(error.code, "W197");
    EXPECT_NE(error.message.find("4 storage images"), std::string::npos) << error.message;
    EXPECT_NE(error.message.find("maxStorageImagesPerStage"), std::string::npos) << error.message;
}

}  // namespace
}  // namespace weft::test
