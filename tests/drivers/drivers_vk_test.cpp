// The shipped graphs on other Vulkan drivers than the packaged one, under the newest validation layer: no message, and
// pictures that differ as little as drivers may. tests/drivers/fetch.sh puts drivers and layer below build/drivers.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "drivers/edge_mask.h"
#include "drivers/snapped_graphs.h"
#include "golden/golden_views.h"
#include "scene/image_decode.h"
#include "viewer/program.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;
const fs::path kDrivers = WEFT_SOURCE_DIR "/build/drivers";
const fs::path kGraphs = WEFT_SOURCE_DIR "/graphs";

struct Driver {
    const char* name;
    const char* folder;  // below build/drivers
    bool same_edges;     // it rounds vertices as the packaged driver does
};

constexpr Driver kMesa{"MesaOfBackports", "mesa-backports", true};
constexpr Driver kSwiftShader{"SwiftShader", "swiftshader", false};

void PrintTo(const Driver& driver, std::ostream* out) {
    *out << driver.name;
}

// What drivers may differ by.
struct Bounds {
    double edge_share = 0.001;
    double mean_flip = 0.005;
};

// On the same grid some 50 texels of the atrium still show another surface, where an edge goes through the middle of a
// texel. Three effects make more of them: `bloom` and `dof` spread a lamp that only one of the two pictures shows, and
// `edges` decides by thresholds which texels it blends along an edge.
Bounds bounds_of(const GoldenView& view) {
    if (view.graph == "bloom") return {0.006, 0.0075};
    if (view.graph == "dof") return {0.002, 0.005};
    if (view.graph == "edges") return {0.003, 0.0075};
    return {};
}

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

    // Why it is not there; empty when it is.
    static std::string absent(const std::string& folder) {
        if (fs::exists(kDrivers / folder / "icd.json")) return "";
        const std::string reason = read_text(kDrivers / (folder + ".skipped"));
        return reason.empty() ? "tests/drivers/fetch.sh has not been run" : reason;
    }
    static Environment environment(const Driver& driver) {
        Environment all{{"VK_DRIVER_FILES", (kDrivers / driver.folder / "icd.json").string()}};
        const fs::path layer = kDrivers / "validation";
        // Without it the packaged layer judges.
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

    ScratchFolder scratch_;
};

TEST_P(Drivers, SayNothingOfTheShippedGraphs) {
    for (const GoldenView& view : golden_views()) {
        SCOPED_TRACE(view.name());
        std::vector<std::string> words{"render", "builtin:" + view.scene, "--graph",
                                       (kGraphs / (view.graph + ".json")).string(), "--camera", view.camera,
                                       "--size", "320x180", "-o", scratch_ / "now.png"};
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

// Otherwise nothing said that the layer listens.
TEST_P(Drivers, NameABarrierThatIsLeftOut) {
    const RunResult result =
        run({"render", "builtin:spheres", "--validate", "--size", "64x36", "--frames", "2", "-o",
             scratch_ / "a.png", "--test-drop-barriers", "lighting"});
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

TEST_P(Drivers, DrawWhatThePackagedDriverDraws) {
    const Driver& driver = GetParam();
    const fs::path snapped = scratch_.path() / "snapped";
    if (!has_device()) GTEST_SKIP() << "no packaged driver to compare with";
    if (!driver.same_edges) {
        ASSERT_GE(write_snapped_graphs(snapped), 4);
    }
    for (const GoldenView& view : golden_views()) {
        SCOPED_TRACE(view.name());
        const fs::path graph = (driver.same_edges ? kGraphs : snapped) / (view.graph + ".json");
        const fs::path now = scratch_.path() / "now.png";
        fs::path wanted = view.picture();
        if (!driver.same_edges) {
            // The golden as it would be on the grid.
            wanted = scratch_.path() / "wanted.png";
            const RunResult reference = run_weft(view.render(graph, wanted));
            ASSERT_EQ(reference.exit_code, 0) << reference.text();
        }
        const RunResult result = run(view.render(graph, now));
        ASSERT_EQ(result.exit_code, 0) << result.text();
        const DriverDifference found = compare_drivers(read_picture(wanted), read_picture(now));
        const Bounds bounds = driver.same_edges ? Bounds{} : bounds_of(view);
        std::printf("%s, %s: %s\n", driver.name, view.name().c_str(), to_text(found).c_str());
        EXPECT_LE(found.off_edges_steps, kSameSteps + 0.01f) << to_text(found);
        EXPECT_LE(found.edge_share, bounds.edge_share) << to_text(found);
        EXPECT_LE(found.mean_flip, bounds.mean_flip) << to_text(found);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Drivers, testing::Values(kMesa, kSwiftShader),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace weft::test
