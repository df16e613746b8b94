// Tests the help of all commands: it names the value of each option and shows defaults after the description.
#include <gtest/gtest.h>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

TEST(Help, NamesTheValueOfEachOption) {
    const std::vector<std::vector<std::string>> commands{
        {"render"},  {"view"}, {"check"},  {"plan"},  {"schema"},         {"explain"},
        {"compare"}, {"diff"}, {"doctor"}, {"scene"}, {"bench", "frame"}, {"bench", "compile"},
    };
    for (std::vector<std::string> command : commands) {
        command.emplace_back("--help");
        const std::string help = run_weft(command).out;
        EXPECT_FALSE(help.empty());
        EXPECT_EQ(help.find("TEXT"), std::string::npos) << help;
        EXPECT_EQ(help.find("=1280x720"), std::string::npos) << help;
    }
}

TEST(Help, ShowsDefaultsAfterTheDescription) {
    const std::string help = run_weft({"plan", "--help"}).out;
    EXPECT_NE(help.find("--queues 1 to 4 "), std::string::npos) << help;
    EXPECT_NE(help.find("second compute queue [default: 1]"), std::string::npos) << help;
}

}  // namespace
}  // namespace weft::test
