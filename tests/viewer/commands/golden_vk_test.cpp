// Compares rendered pictures with the pictures in tests/golden. They must be equal in every bit on the driver
// that made the stored pictures, and visually equal on other drivers.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/golden/golden_views.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

const std::filesystem::path kFolder = WEFT_SOURCE_DIR "/tests/golden";
// Limit for the FLIP difference of two pictures. A mean difference of 0.005 is invisible.
constexpr const char* kSame = "0.005";

class Golden : public testing::TestWithParam<GoldenView> {};

TEST_P(Golden, LooksAsItDid) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const GoldenView& view = GetParam();
    // Other tests compare forward shading with deferred shading.
    if (view.graph == "forward" && view.scene != "lights" && !extended())
        GTEST_SKIP() << "only with WEFT_EXTENDED";
    const ScratchFolder folder;
    const RunResult run =
        run_weft(view.render(WEFT_SOURCE_DIR "/graphs/" + view.graph + ".json", folder / "now.png"));
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const auto stats = nlohmann::json::parse(read_text(folder / "now.png.json"));
    const std::string driver =
        stats.at("device").get<std::string>() + "\n" + stats.at("driver").get<std::string>() + "\n";
    const bool same_driver = driver == read_text(kFolder / "driver.txt");
    const std::string golden = view.picture().string();
    const RunResult compared = run_weft({"compare", golden, folder / "now.png", "--metric",
                                         same_driver ? "max" : "flip", "--max", same_driver ? "0" : kSame});
    EXPECT_EQ(compared.exit_code, 0)
        << compared.text() << "driver: " << driver
        << "if the new picture is right, tests/golden/bless.sh makes it the one to compare with";
}

INSTANTIATE_TEST_SUITE_P(All, Golden, testing::ValuesIn(golden_views()), [](const auto& view) {
    std::string name = view.param.name();
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
});

}  // namespace
}  // namespace weft::test
