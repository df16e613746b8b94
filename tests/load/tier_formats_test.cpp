// Tests the choice of formats that suit all tiers of a graph, and the number of loads that the choice needs.
#include "shader/shader_memory.h"
#include "tests/shader/shader_folder.h"
#include "weft/load/load_graph.h"

namespace weft {
namespace {

// Tier "paint" writes `color` as a storage image. The other tiers use `color` as a colour attachment.
constexpr const char* kGraph = R"({
  "version": 1, "name": "tiers", "imports": { "backbuffer": "output" },
  "resources": { "color": "b10g11r11f|rgba16f" },
  "passes": {
    "draw": { "type": "fullscreen", "shader": "draw.frag", "out": ["color"] },
    "show": { "type": "fullscreen", "shader": "show.frag", "in": ["color"], "out": ["backbuffer"] }
  },
  "tiers": {
    "low": {}, "medium": {}, "high": {},
    "paint": { "patch": { "passes": { "draw": { "type": "compute", "shader": "paint.comp" } } } }
  }
})";
// Number of variants of the graph: four quality tiers, and the graph without a tier.
constexpr size_t kTiers = 5;

class TierFormats : public ShaderFolder {
 protected:
    TierFormats() {
        write("graph/g.json", kGraph);
        write("graph/draw.frag",
              "#version 460\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(1); }\n");
        write("graph/show.frag",
              "#version 460\nlayout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 backbuffer;\n"
              "uniform sampler2D color;\nvoid main() { backbuffer = texture(color, uv); }\n");
        write("graph/paint.comp",
              "#version 460\nlayout(local_size_x = 8, local_size_y = 8) in;\n"
              "uniform writeonly image2D color;\n"
              "void main() { imageStore(color, ivec2(gl_GlobalInvocationID.xy), vec4(1)); }\n");
        ImportDecl output;
        output.name = "backbuffer";
        output.kind = ImportKind::output;
        output.resource.name = "backbuffer";
        output.resource.lifetime = ResourceLifetime::imported;
        output.resource.format = Format::rgba8;
        output.resource.extent = {64, 64, 1};
        output.resource.import = ImportState{};
        imports_.imports.emplace("backbuffer", output);
        settings_.reader = [](const std::string& path) {
            std::ifstream in(path);
            return std::optional(std::string(std::istreambuf_iterator<char>(in), {}));
        };
        settings_.shader_root = base_ / "shaders";
        const FormatFeatureMask drawn = ~format_feature::kStorage;
        profile_.formats = {{Format::b10g11r11f, drawn},
                            {Format::rgba8, drawn},
                            {Format::rgba16f, drawn | format_feature::kStorage}};
    }

    LoadInput input(const std::string& tier, const SkippedFormats* common = nullptr) {
        return {.request = {.path = path_, .tier = tier},
                .settings = settings_,
                .passes = passes_,
                .imports = imports_,
                .profile = profile_,
                .memory = &memory_,
                .common_formats = common};
    }

    Format format_of(const JsonDoc& document, const std::string& tier, const SkippedFormats* common) {
        Diagnostics warnings;
        const Result<LoadedGraph> loaded = load_graph(document, input(tier, common), warnings);
        EXPECT_TRUE(loaded.ok()) << to_text(loaded.errors());
        if (!loaded) return Format::undefined;
        return loaded->graph.resources[find_resource(loaded->graph, "color")].format;
    }

    std::string path_ = (base_ / "graph/g.json").string();
    LoadSettings settings_;
    PassCatalog passes_;
    ImportCatalog imports_;
    DeviceProfile profile_;
    ShaderMemory memory_;
};

// Counts requests for programs: each load of a tier requests the two programs of its passes. Without given
// common formats, a load of one tier also loads all other tiers, to find the formats. If common_formats()
// finds the formats once, each tier is loaded only twice: by common_formats(), and then with its result.
TEST_F(TierFormats, FoundOnceTheyLoadEachTierTwiceInsteadOfAllTiersForEach) {
    const Result<JsonDoc> document = read_graph(path_, settings_);
    ASSERT_TRUE(document.ok()) << to_text(document.errors());
    const std::vector<std::string> tiers{"", "low", "medium", "high", "paint"};
    for (const std::string& tier : tiers)
        EXPECT_EQ(format_of(*document, tier, nullptr), Format::rgba16f) << tier;
    EXPECT_EQ(memory_.requests(), kTiers * kTiers * 2) << "each looks at all";

    const uint64_t before = memory_.requests();
    const SkippedFormats common = common_formats(*document, input("low"));
    EXPECT_EQ(common, (SkippedFormats{{"color", 1}}));
    for (const std::string& tier : tiers)
        EXPECT_EQ(format_of(*document, tier, &common), Format::rgba16f) << tier;
    EXPECT_EQ(memory_.requests() - before, 2 * kTiers * 2);
    EXPECT_EQ(memory_.misses(), 3u) << "each program is compiled once";
}

TEST_F(TierFormats, WithoutATierThatNeedsTheOtherTheFirstIsTaken) {
    std::string text(kGraph);
    text.replace(text.find("\"type\": \"compute\", \"shader\": \"paint.comp\""), 41,
                 "\"shader\": \"draw.frag\"");
    write("graph/g.json", text);
    const Result<JsonDoc> document = read_graph(path_, settings_);
    ASSERT_TRUE(document.ok()) << to_text(document.errors());
    const SkippedFormats common = common_formats(*document, input(""));
    EXPECT_EQ(format_of(*document, "low", &common), Format::b10g11r11f);
    EXPECT_EQ(format_of(*document, "low", nullptr), Format::b10g11r11f);
}

}  // namespace
}  // namespace weft
