// Tests that two built-in scenes and a glTF file render at several sizes without a message of the validation
// layer. To prove that the layer is active, one test removes the barriers of a pass and expects a message.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "tests/viewer/gltf_file.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;
constexpr const char* kForeign = "foreign glTF";

struct ValidationRun {
    const char* scene;
    const char* size;
    const char* name;
    // True if the test also runs without WEFT_EXTENDED, with two frames instead of ten.
    bool quick;
};

void PrintTo(const ValidationRun& run, std::ostream* out) {
    *out << run.scene << " at " << run.size;
}

constexpr ValidationRun kRuns[] = {
    {"builtin:atrium", "1x1", "Atrium1x1", false},
    {"builtin:atrium", "320x180", "Atrium320x180", true},
    {"builtin:atrium", "641x361", "Atrium641x361", false},
    {"builtin:atrium", "1280x720", "Atrium1280x720", false},
    {"builtin:spheres", "1x1", "Spheres1x1", true},
    {"builtin:spheres", "320x180", "Spheres320x180", false},
    {"builtin:spheres", "641x361", "Spheres641x361", true},
    {"builtin:spheres", "1280x720", "Spheres1280x720", false},
    {kForeign, "1x1", "Foreign1x1", false},
    {kForeign, "320x180", "Foreign320x180", true},
    {kForeign, "641x361", "Foreign641x361", false},
    {kForeign, "1280x720", "Foreign1280x720", false},
};

class ValidationTest : public testing::TestWithParam<ValidationRun> {};

TEST_P(ValidationTest, SaysNothing) {
    const ValidationRun& wanted = GetParam();
    if (!wanted.quick && !extended()) GTEST_SKIP() << "only with WEFT_EXTENDED";
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    folder.write("square.gltf", square_gltf());
    const std::string scene = wanted.scene == std::string(kForeign) ? folder / "square.gltf" : wanted.scene;
    const RunResult run =
        run_weft({"render", scene, "--validate", "--size", wanted.size, "--frames", extended() ? "10" : "2",
                  "-o", folder / "a.png", "--stats", folder / "stats.json"});
    ASSERT_EQ(run.exit_code, 0) << run.text();
    EXPECT_EQ(run.err.find("validation:"), std::string::npos) << run.text();
    const Json validation = Json::parse(read_text(folder / "stats.json")).at("validation");
    EXPECT_EQ(validation.at("messages"), 0);
    ASSERT_EQ(validation.at("layers").size(), 1u);
    EXPECT_EQ(validation.at("layers")[0].at("name"), "VK_LAYER_KHRONOS_validation");
    EXPECT_FALSE(validation.at("layers")[0].at("version").get<std::string>().empty());
}

INSTANTIATE_TEST_SUITE_P(All, ValidationTest, testing::ValuesIn(kRuns),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Validation, ADroppedBarrierIsExitCode5AndNamesThePass) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const ScratchFolder folder;
    const RunResult run = run_weft({"render", "builtin:spheres", "--validate", "--size", "64x36", "--frames",
                                    "2", "-o", folder / "a.png", "--test-drop-barriers", "lighting"});
    EXPECT_EQ(run.exit_code, 5) << run.text();
    EXPECT_NE(run.err.find("pass lighting"), std::string::npos) << run.text();
}

}  // namespace
}  // namespace weft::test
