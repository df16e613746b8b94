// Renders the shipped graphs on Vulkan drivers other than the packaged one (the driver of the other tests),
// with the newest validation layer. The layer must give no message, and the pictures may differ only as much
// as Vulkan allows.
// tests/drivers/fetch.sh puts the drivers and the layer into build/drivers.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "tests/drivers/edge_mask.h"
#include "tests/drivers/snapped_graphs.h"
#include "tests/golden/golden_views.h"
#include "tests/viewer/documentation/snippets.h"
#include "tests/viewer/gltf_file.h"
#include "tests/viewer/program.h"
#include "weft/scene/image_decode.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;
const fs::path kDrivers = WEFT_SOURCE_DIR "/build/drivers";
const fs::path kGraphs = WEFT_SOURCE_DIR "/graphs";

struct Driver {
    const char* name;
    // Name of the driver's folder in build/drivers.
    const char* folder;
};

constexpr Driver kMesa{"MesaOfBackports", "mesa-backports"};
constexpr Driver kSwiftShader{"SwiftShader", "swiftshader"};

void PrintTo(const Driver& driver, std::ostream* out) {
    *out << driver.name;
}

// A deliberate fault in a shader of the graph `graph`: in the file `file` (relative to the shader folder),
// the text `text` is replaced by `faulty`. This makes one factor 3 % too large.
struct Fault {
    const char *graph, *file, *text, *faulty;
};

constexpr Fault kFaults[] = {
    {"bloom", "bloom/up.comp", "params.bloomSpread)", "params.bloomSpread * 1.03)"},
    {"bloom", "bloom/tonemap.frag", "params.bloomStrength)", "params.bloomStrength * 1.03)"},
    {"dof", "dof/circle.glsl", "= aperture_m *", "= 1.03 * aperture_m *"},
    {"edges", "edges/edges.frag", "params.exposure", "params.exposure * 1.03"},
    {"edges", "edges/lines.comp", "jump / params.jump", "jump * 1.03 / params.jump"},
    {"deferred", "gbuffer/gbuffer.frag", "sqrt(base.rgb)", "1.03 * sqrt(base.rgb)"},
};

image::Image read_picture(const fs::path& file) {
    const std::string bytes = read_text(file);
    const scene::DecodedImage decoded =
        scene::decode_image({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
    EXPECT_EQ(decoded.error, "") << file;
    image::Image picture{decoded.size.width_px, decoded.size.height_px, image::Encoding::display, {}};
    for (size_t i = 0; i + 3 < decoded.rgba.size(); i += 4)
        picture.texels.emplace_back(glm::vec3(decoded.rgba[i], decoded.rgba[i + 1], decoded.rgba[i + 2]) /
                                    255.0f);
    return picture;
}

class Drivers : public testing::TestWithParam<Driver> {
 protected:
    void SetUp() override {
        if (!extended()) GTEST_SKIP() << "only with WEFT_EXTENDED";
        if (const std::string why = absent(GetParam().folder); !why.empty()) GTEST_SKIP() << why;
    }

    // Returns the reason why the driver is missing, or an empty text if the driver is present.
    static std::string absent(const std::string& folder) {
        if (fs::exists(kDrivers / folder / "icd.json")) return "";
        const std::string reason = read_text(kDrivers / (folder + ".skipped"));
        return reason.empty() ? "tests/drivers/fetch.sh has not been run" : reason;
    }
    static Environment environment(const Driver& driver) {
        Environment all{{"VK_DRIVER_FILES", (kDrivers / driver.folder / "icd.json").string()}};
        const fs::path layer = kDrivers / "validation";
        // Without this folder, the Vulkan loader uses the packaged validation layer.
        if (fs::exists(layer / "VkLayer_khronos_validation.json"))
            all.emplace_back("VK_LAYER_PATH", layer.string());
        return all;
    }
    static RunResult run(std::vector<std::string> words) { return run_weft(words, environment(GetParam())); }

    void expect_silence(std::vector<std::string> words) const {
        words.insert(words.end(), {"--validate", "--stats", scratch_ / "stats.json"});
        if (std::ranges::find(words, "--frames") == words.end()) words.insert(words.end(), {"--frames", "2"});
        const RunResult result = run(words);
        ASSERT_EQ(result.exit_code, 0) << result.text();
        const auto stats = nlohmann::json::parse(read_text(scratch_ / "stats.json"));
        EXPECT_EQ(stats.at("validation").at("messages"), 0) << result.text();
        EXPECT_EQ(stats.at("validation").at("layers").size(), 1u);
    }

    // Makes copies of the shipped graphs without features whose results depend on the driver. Returns the
    // folder of the copies.
    fs::path snapped(Triangles triangles) const {
        const fs::path folder = scratch_ / "snapped";
        const SnappedShaders changed = write_snapped_graphs(folder, triangles);
        EXPECT_EQ(changed.vertex, 4);
        EXPECT_EQ(changed.fragment, 4);
        EXPECT_TRUE(changed.has_wide_lines);
        return folder;
    }
    // Renders the view with the packaged driver and returns the file of the picture.
    fs::path reference(const GoldenView& view, const fs::path& graphs) const {
        const fs::path picture = scratch_ / "reference.png";
        const RunResult result = run_weft(view.render(graphs / (view.graph + ".json"), picture));
        EXPECT_EQ(result.exit_code, 0) << result.text();
        return picture;
    }
    DriverDifference difference(const GoldenView& view, const fs::path& wanted,
                                const fs::path& graphs) const {
        const fs::path picture = scratch_ / "now.png";
        const RunResult result = run(view.render(graphs / (view.graph + ".json"), picture));
        EXPECT_EQ(result.exit_code, 0) << result.text();
        if (result.exit_code != 0 || !fs::exists(wanted)) return {};
        const DriverDifference found = compare_drivers(read_picture(wanted), read_picture(picture));
        std::printf("%s, %s: %s\n", GetParam().name, view.name().c_str(), to_text(found).c_str());
        return found;
    }

    ScratchFolder scratch_;
};

TEST_P(Drivers, SayNothingOfTheShippedGraphs) {
    for (const GoldenView& view : golden_views()) {
        SCOPED_TRACE(view.name());
        std::vector<std::string> words{"render",   "builtin:" + view.scene,
                                       "--graph",  (kGraphs / (view.graph + ".json")).string(),
                                       "--camera", view.camera,
                                       "--size",   "160x90",
                                       "-o",       scratch_ / "now.png"};
        words.insert(words.end(), view.options.begin(), view.options.end());
        expect_silence(words);
    }
}

TEST_P(Drivers, SayNothingAtAnySize) {
    for (const char* scene : {"builtin:atrium", "builtin:spheres"})
        for (const char* size : {"1x1", "641x361", "1280x720"}) {
            SCOPED_TRACE(std::string(scene) + " " + size);
            expect_silence({"render", scene, "--size", size, "-o", scratch_ / "now.png"});
        }
}

// Leaves out the barriers of pass "lighting" and expects a validation message. Without this test, the absence
// of messages in other tests would prove nothing.
TEST_P(Drivers, NameABarrierThatIsLeftOut) {
    const RunResult result = run({"render", "builtin:spheres", "--validate", "--size", "64x36", "--frames",
                                  "2", "-o", scratch_ / "a.png", "--test-drop-barriers", "lighting"});
    EXPECT_EQ(result.exit_code, 5) << result.text();
    EXPECT_NE(result.err.find("pass lighting"), std::string::npos) << result.text();
}

TEST_P(Drivers, PassTheTestsOfTheShippedGraphs) {
    std::vector<std::string> words{"check", "--run"};
    for (const auto& entry : fs::directory_iterator(kGraphs))
        if (entry.path().extension() == ".json") words.push_back(entry.path().string());
    const RunResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result.text();
}

// The example of docs/format.md draws all opaque objects with one command, and finds their textures in a
// table. The picture must be the same as with the textures of the material sets. SwiftShader lacks
// drawIndirectCount, and its limit is 64 textures; the atrium has more.
TEST_P(Drivers, TheDocumentedTableGivesThePictureOfTheMaterialSets) {
    for (const auto& [name, content] : snippets_of("format.md")) scratch_.write(name, content);
    const auto render = [&](const char* name) {
        return std::vector<std::string>{"render",     "builtin:atrium",
                                        "--graph",    scratch_ / (std::string(name) + ".json"),
                                        "--size",     "160x90",
                                        "--resource", "albedo",
                                        "-o",         scratch_ / (std::string(name) + ".pfm")};
    };
    if (GetParam().name == std::string(kSwiftShader.name)) {
        const std::string graph = read_text(scratch_ / "indexed.json");
        const std::string counted =
            R"({ "list": "opaque", "indirect": "opaqueCommands", "count": "number" })";
        scratch_.write("indexed.json", replaced(graph, counted, R"(["opaque"])"));
        const RunResult refused = run(render("indexed"));
        EXPECT_EQ(refused.exit_code, 3);
        EXPECT_NE(refused.err.find("error[W231]"), std::string::npos) << refused.text();
        EXPECT_NE(refused.err.find("the device allows 64"), std::string::npos) << refused.text();
        return;
    }
    scratch_.write("sets/sets.vert", read_text(scratch_ / "indexed/indexed.vert"));
    scratch_.write("sets/sets.frag", R"(#version 460
#include "material_set.glsl"
layout(location = 2) in vec2 surface_uv;
layout(location = 0) out vec4 color;
void main() {
    color = material.base_color * texture(base_color_texture, transformed(material.base_color_uv, surface_uv));
}
)");
    scratch_.write("sets.json", R"({
  "version": 1, "include": ["fog.json"], "resources": { "albedo": "rgba16f", "near": "d32f" },
  "passes": {
    "colors":  { "type": "raster", "shader": "sets", "draws": ["opaque"], "out": { "color": "albedo" }, "depth": "near",
                 "state": { "cull": "none" } },
    "deliver": { "type": "readback", "in": ["albedo"] }
  }
})");
    expect_silence(render("sets"));
    expect_silence(render("indexed"));
    const std::string picture = read_text(scratch_ / "sets.pfm");
    EXPECT_TRUE(read_text(scratch_ / "indexed.pfm") == picture) << "the pictures differ";
    std::set<std::string> colors;
    for (size_t at = picture.size() % 12; at < picture.size(); at += 12)
        colors.insert(picture.substr(at, 12));
    EXPECT_GT(colors.size(), 100u) << "a plain picture proves nothing";
}

// The packaged driver has no tables of textures, so it skips most of these tests.
TEST_P(Drivers, PassTheTestsOfTables) {
    const RunResult result =
        run_program({WEFT_RENDER_TESTS, "--gtest_filter=Tables.*:SceneTables.*"}, environment(GetParam()));
    EXPECT_EQ(result.exit_code, 0) << result.text();
    EXPECT_NE(result.out.find("OK ] SceneTables.ATableGivesThePictureOfTheMaterialSets"), std::string::npos)
        << result.text();
}

// The packaged driver draws no multiview, and SwiftShader has no vertex shaders that select the layer.
// Together they run each lowering of views.
TEST_P(Drivers, PassTheTestsOfLoweredViews) {
    const RunResult result =
        run_program({WEFT_RENDER_TESTS, "--gtest_filter=Lowerings.*"}, environment(GetParam()));
    EXPECT_EQ(result.exit_code, 0) << result.text();
    const bool is_mesa = std::string(GetParam().folder) == kMesa.folder;
    const std::string test = is_mesa ? "GiveTheSameBytesWithLayerOutput" : "GiveTheSameBytesWithMultiview";
    EXPECT_NE(result.out.find("OK ] Lowerings." + test), std::string::npos) << result.text();
}

// Tests of drivers that round vertices and filter textures like the packaged driver.
class DriversLikeThePackagedOne : public Drivers {};
// Tests of drivers that round vertices or filter textures differently. They render modified graphs; see
// snapped_graphs.h.
class DriversOfTheirOwn : public Drivers {};

TEST_P(DriversLikeThePackagedOne, DrawTheGoldens) {
    for (const GoldenView& view : golden_views()) {
        const DriverDifference found = difference(view, view.picture(), kGraphs);
        EXPECT_TRUE(is_within_bounds(found)) << view.name() << ": " << to_text(found);
    }
}

TEST_P(DriversOfTheirOwn, DrawWhatThePackagedDriverDraws) {
    if (!has_device()) GTEST_SKIP() << "no packaged driver to compare with";
    const fs::path graphs = snapped(Triangles::whole);
    for (const GoldenView& view : golden_views()) {
        const DriverDifference found = difference(view, reference(view, graphs), graphs);
        EXPECT_TRUE(is_within_bounds(found)) << view.name() << ": " << to_text(found);
    }
}

// Triangles that extend beyond the picture are drawn in this test. Clipping moves their edges, so only texels
// away from edges are compared.
TEST_P(DriversOfTheirOwn, ShadeWhatReachesBeyondThePicture) {
    if (!has_device()) GTEST_SKIP() << "no packaged driver to compare with";
    const fs::path graphs = snapped(Triangles::all);
    for (const GoldenView& view : golden_views()) {
        if (view.graph != "forward") continue;
        const DriverDifference found = difference(view, reference(view, graphs), graphs);
        EXPECT_TRUE(is_same_off_edges(found)) << view.name() << ": " << to_text(found);
    }
}

// Inserts faults into shaders. The difference must then exceed the bounds, which shows that the bounds are
// narrow enough.
TEST_P(DriversOfTheirOwn, DifferByMoreWithAFault) {
    if (!has_device()) GTEST_SKIP() << "no packaged driver to compare with";
    const fs::path graphs = snapped(Triangles::whole);
    const std::vector<GoldenView> views = golden_views();
    for (const Fault& fault : kFaults) {
        const GoldenView view = *std::ranges::find(views, fault.graph, &GoldenView::graph);
        const fs::path faulty = scratch_ / "faulty";
        fs::remove_all(faulty);
        fs::copy(graphs, faulty, fs::copy_options::recursive);
        ASSERT_TRUE(replace_in(faulty / fault.file, fault.text, fault.faulty)) << fault.file;
        const DriverDifference found = difference(view, reference(view, graphs), faulty);
        EXPECT_FALSE(is_within_bounds(found)) << fault.file << ": " << to_text(found);
    }
}

std::string name_of(const testing::TestParamInfo<Driver>& row) {
    return row.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, Drivers, testing::Values(kMesa, kSwiftShader), name_of);
INSTANTIATE_TEST_SUITE_P(All, DriversLikeThePackagedOne, testing::Values(kMesa), name_of);
INSTANTIATE_TEST_SUITE_P(All, DriversOfTheirOwn, testing::Values(kSwiftShader), name_of);

}  // namespace
}  // namespace weft::test
