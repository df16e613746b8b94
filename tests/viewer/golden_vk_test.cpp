// The pictures of tests/golden: to the bit on the driver that made them, and by eye on any other.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "viewer/program.h"

namespace weft::test {
namespace {

const std::filesystem::path kFolder = WEFT_SOURCE_DIR "/tests/golden";
// Of FLIP, whose 0.005 nobody sees.
constexpr const char* kSame = "0.005";

struct View {
    std::string graph, scene, camera;
    std::vector<std::string> options;
    [[nodiscard]] std::string name() const { return graph + "-" + scene + "-" + camera; }
};

std::vector<View> views() {
    std::ifstream file(kFolder / "views.txt");
    std::vector<View> found;
    for (std::string line; std::getline(file, line);) {
        View view;
        std::istringstream words(line);
        if (line.starts_with("#") || !(words >> view.graph >> view.scene >> view.camera)) continue;
        for (std::string option; words >> option;) view.options.push_back(option);
        found.push_back(view);
    }
    return found;
}

class Golden : public testing::TestWithParam<View> {};

TEST_P(Golden, LooksAsItDid) {
    if (!has_device()) GTEST_SKIP() << "no Vulkan device";
    const View& view = GetParam();
    const ScratchFolder folder;
    std::vector<std::string> arguments{"render",   "builtin:" + view.scene,
                                       "--graph",  WEFT_SOURCE_DIR "/graphs/" + view.graph + ".json",
                                       "--camera", view.camera,
                                       "--size",   "320x180",
                                       "-o",       folder / "now.png",
                                       "--stats",  folder / "stats.json"};
    arguments.insert(arguments.end(), view.options.begin(), view.options.end());
    const RunResult run = run_weft(arguments);
    ASSERT_EQ(run.exit_code, 0) << run.text();
    const auto stats = nlohmann::json::parse(read_text(folder / "stats.json"));
    const std::string driver =
        stats.at("device").get<std::string>() + "\n" + stats.at("driver").get<std::string>() + "\n";
    const bool same_driver = driver == read_text(kFolder / "driver.txt");
    const std::string golden = (kFolder / (view.name() + ".png")).string();
    const RunResult compared = run_weft({"compare", golden, folder / "now.png", "--metric",
                                         same_driver ? "max" : "flip", "--max", same_driver ? "0" : kSame});
    EXPECT_EQ(compared.exit_code, 0)
        << compared.text() << "driver: " << driver
        << "if the new picture is right, tests/golden/bless.sh makes it the one to compare with";
}

INSTANTIATE_TEST_SUITE_P(All, Golden, testing::ValuesIn(views()), [](const auto& view) {
    std::string name = view.param.name();
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
});

}  // namespace
}  // namespace weft::test
