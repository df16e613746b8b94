// Tests that resolve() gives each port the sampler that its author stated, and refuses samplers that the
// shader or the device does not support.
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveSampler : public ResolveTest {
 protected:
    ResolveSampler() {
        shaders["plain.comp"] = compute({sampled("src"), image_out("dst")});
        ShaderBinding shadow = sampled("src");
        shadow.shadow = true;
        shadow.numeric = NumericClass::depth;
        ShaderBinding fetched = sampled("src");
        fetched.filters = false;
        shaders["fetch.comp"] = compute({fetched, image_out("dst")});
        shaders["shadow.comp"] = compute({shadow, image_out("dst")});
        profile.max_sampler_anisotropy = 16;
        for (const Format format : {Format::d32f, Format::r32f})
            profile.formats[format] |= format_feature::kSampledMinMax | format_feature::kSampledLinear;
    }

    // Returns a graph in which pass "f" samples the cleared image "x". The sampler is line 3 of the text.
    static std::string sampling(const std::string& sampler, const std::string& shader = "plain.comp",
                                const std::string& format = "r32f") {
        return R"j("resources": {"x": {"format": ")j" + format +
               R"j(", "mips": 3}, "y": "rgba16f"}, "passes": {"c": {"type": "clear", "out": ["x"]},
"f": {"type": "compute", "shader": ")j" +
               shader + "\", \"in\": {\"src\": {\"ref\": \"x\", \"sampler\":\n{" + sampler +
               "}}}, \"out\": {\"dst\": \"y\"}}}";
    }
};

TEST_F(ResolveSampler, EachSettingReachesThePort) {
    const ResolvedGraph g = good(sampling(
        R"j("anisotropy": 4.5, "lodBias": -1.5, "minLod": 0.5, "maxLod": 2, "reduction": "min", "wrap": "repeat")j"));
    EXPECT_EQ(use(g, "f", "src").sampler, (SamplerDecl{.wrap = SamplerWrap::repeat,
                                                       .reduction = SamplerReduction::min,
                                                       .anisotropy = 4.5F,
                                                       .lod_bias = -1.5F,
                                                       .min_lod = 0.5F,
                                                       .max_lod = 2}));
    EXPECT_EQ(use(good(sampling("")), "f", "src").sampler, SamplerDecl{});
}

TEST_F(ResolveSampler, AShadowSamplerComparesAsStatedOrWithGreaterEqual) {
    const auto compare_of = [&](const std::string& sampler) {
        return use(good(sampling(sampler, "shadow.comp", "d32f")), "f", "src").sampler.compare;
    };
    EXPECT_EQ(compare_of(""), CompareOp::greater_equal);
    EXPECT_EQ(compare_of(R"j("compare": "none")j"), CompareOp::greater_equal);
    EXPECT_EQ(compare_of(R"j("compare": "less_equal")j"), CompareOp::less_equal);
    EXPECT_EQ(compare_of(R"j("compare": "never")j"), CompareOp::never);
    EXPECT_EQ(compare_of(R"j("compare": "always")j"), CompareOp::always);
}

struct BadSampler {
    const char* name;
    const char* text;
    const char* shader;
    const char* code;
    uint32_t column;
    const char* message;
    const char* help;
};
void PrintTo(const BadSampler& bad, std::ostream* out) {
    *out << bad.text;
}

class ResolveBadSampler : public ResolveSampler, public testing::WithParamInterface<BadSampler> {};

TEST_P(ResolveBadSampler, IsRefusedAtItsValue) {
    const BadSampler& b = GetParam();
    profile.max_sampler_anisotropy = 8;
    const bool shadow = std::string(b.shader) == "shadow.comp";
    const Diagnostic error = bad(sampling(b.text, b.shader, shadow ? "d32f" : "r32f"));
    EXPECT_EQ(error.code, b.code);
    EXPECT_EQ(error.line, 3u);
    EXPECT_EQ(error.column, b.column);
    EXPECT_NE(error.message.find(b.message), std::string::npos) << error.message;
    expect_help(error, b.help);
}

constexpr BadSampler kBadSamplers[]{
    {"Compare", R"j("compare": "less")j", "plain.comp", "W172", 13, "does not compare", "sampler2DShadow"},
    {"ReducedShadow", R"j("reduction": "min")j", "shadow.comp", "W172", 15, "shadow sampler", "sampler2D"},
    {"Anisotropy", R"j("anisotropy": 9)j", "plain.comp", "W187", 16, "at most 8", "smaller"},
    {"Bias", R"j("lodBias": -2.5)j", "plain.comp", "W187", 13, "only -2 to 2", "nearer to 0"},
};
INSTANTIATE_TEST_SUITE_P(All, ResolveBadSampler, testing::ValuesIn(kBadSamplers),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(ResolveSampler, ADeviceWithoutAnisotropyNamesTheFeature) {
    profile.max_sampler_anisotropy = 1;
    good(sampling(R"j("anisotropy": 1)j"));
    const Diagnostic error = bad(sampling(R"j("anisotropy": 1.5)j"));
    EXPECT_EQ(error.code, "W187");
    EXPECT_NE(error.message.find("samplerAnisotropy"), std::string::npos) << error.message;
    expect_help(error, "remove \"anisotropy\"");
}

TEST_F(ResolveSampler, AReductionNeedsAFormatThatTheDeviceReduces) {
    profile.formats[Format::r32f] &= ~format_feature::kSampledMinMax;
    const Diagnostic error = bad(sampling(R"j("reduction": "max")j"));
    EXPECT_EQ(error.code, "W117");
    expect_help(error, "the sampler reductions min and max");
    // Weft chooses the next format of the list. A reduction does not need linear filtering.
    profile.formats[Format::r16f] |= format_feature::kSampledMinMax;
    profile.formats[Format::r16f] &= ~format_feature::kSampledLinear;
    const ResolvedGraph g = good(sampling(R"j("reduction": "max")j", "plain.comp", "r32f|r16f"));
    EXPECT_EQ(resource_in(g, "x").format, Format::r16f);
}

TEST_F(ResolveSampler, APortWithoutFilteringNeedsNoFormatThatFilters) {
    profile.formats[Format::r32f] &= ~format_feature::kSampledLinear;
    const std::string graph = R"j("resources": {"x": "r32f", "y": "rgba16f"},
"passes": {"c": {"type": "clear", "out": ["x"]},
"f": {"type": "compute", "shader": "SHADER", "in": {"src": "x"}, "out": {"dst": "y"}}})j";
    const auto with_shader = [&](const char* name) {
        return std::string(graph).replace(graph.find("SHADER"), 6, name);
    };
    EXPECT_EQ(bad(with_shader("plain.comp")).code, "W117");
    EXPECT_EQ(use(good(with_shader("fetch.comp")), "f", "src").sampler.filter, SamplerFilter::nearest);
}

TEST_F(ResolveSampler, ABlitTakesOnlyAFilter) {
    const auto blit = [](const std::string& sampler) {
        return R"j("resources": {"x": "r32f", "y": {"format": "r32f", "size": "half"}}, "sizes": {"half": "output / 2"},
"passes": {"c": {"type": "clear", "out": ["x"]},
"b": {"type": "blit", "in": {"src": {"ref": "x", "sampler": {)j" +
               sampler + R"j(}}}, "out": ["y"]}})j";
    };
    good(blit(R"j("filter": "nearest")j"));
    const Diagnostic error = bad(blit(R"j("lodBias": 1)j"));
    EXPECT_EQ(error.code, "W183");
    EXPECT_NE(error.message.find("only shaders can use"), std::string::npos) << error.message;
}

}  // namespace
}  // namespace weft::test
