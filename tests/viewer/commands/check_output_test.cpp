// Tests the output of `weft check`: colours for users on a terminal, and SARIF for programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;
const std::string kBad = WEFT_SOURCE_DIR "/tests/diagnostics/W103_port.json";
constexpr const char* kEscape = "\x1b[";

// Returns the environment variables of a run. Variables that control colours get fixed values, so that the
// result does not depend on the environment of the test.
Environment colors(Environment more) {
    Environment all{{"NO_COLOR", ""}, {"FORCE_COLOR", ""}, {"CLICOLOR_FORCE", ""}, {"TERM", "xterm"}};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

// Runs `weft` on a pseudo-terminal. The result contains stdout and stderr together.
RunResult on_terminal(const std::string& arguments, const Environment& more = {}) {
    return run_program({"script", "-qec", "'" WEFT_PROGRAM "' " + arguments, "/dev/null"}, colors(more));
}

std::string without_colors(std::string text) {
    for (size_t at = text.find(kEscape); at != std::string::npos; at = text.find(kEscape, at))
        text.erase(at, text.find('m', at) - at + 1);
    return text;
}

TEST(CheckColors, AreThereOnATerminalOnly) {
    const RunResult terminal = on_terminal("check '" + kBad + "'");
    EXPECT_NE(terminal.out.find("\x1b[1;31merror\x1b[0m\x1b[1m[W103]\x1b[0m: pass"), std::string::npos)
        << terminal.text();
    EXPECT_NE(terminal.out.find("^\x1b[0m"), std::string::npos) << terminal.text();
    const RunResult pipe = run_weft({"check", kBad}, colors({}));
    EXPECT_EQ(pipe.exit_code, 3);
    EXPECT_EQ(pipe.err.find(kEscape), std::string::npos) << pipe.text();
}

TEST(CheckColors, WarningsAreYellow) {
    const RunResult run =
        on_terminal("check '" + std::string(kDeferredGraph) + "' --profile integrated --size 3840x2160");
    EXPECT_NE(run.out.find("\x1b[1;33mwarning\x1b[0m\x1b[1m[W142]"), std::string::npos) << run.text();
}

TEST(CheckColors, EnvironmentsCanForbidAndForceThem) {
    const std::string command = "check '" + kBad + "'";
    EXPECT_EQ(on_terminal(command, {{"NO_COLOR", "1"}}).out.find(kEscape), std::string::npos);
    EXPECT_EQ(on_terminal(command, {{"TERM", "dumb"}}).out.find(kEscape), std::string::npos);
    const std::string plain = run_weft({"check", kBad}, colors({})).err;
    for (const char* name : {"FORCE_COLOR", "CLICOLOR_FORCE"}) {
        const RunResult forced = run_weft({"check", kBad}, colors({{name, "1"}}));
        EXPECT_NE(forced.err.find(kEscape), std::string::npos) << name;
        EXPECT_EQ(without_colors(forced.err), plain) << "colours change no word";
        EXPECT_EQ(run_weft({"check", kBad}, colors({{name, "0"}})).err, plain) << name;
    }
}

TEST(CheckColors, OtherCommandsHaveThemToo) {
    const Environment forced = colors({{"FORCE_COLOR", "1"}});
    for (const std::vector<std::string>& command : {std::vector<std::string>{"plan", kBad},
                                                    {"render", "--graph", kBad, "-o", "/nonexistent/a.png"},
                                                    {"explain", kBad, "wait", "x"}})
        EXPECT_NE(run_weft(command, forced).err.find("\x1b[1;31merror"), std::string::npos) << command[0];
}

// The graph file contains control characters. `weft` must not pass them to the terminal.
TEST(CheckColors, AFileCannotBringItsOwn) {
    const ScratchFolder folder;
    folder.write("a.json", "{ \"version\": 1, \"\x1b[31mx\": 1 }");
    const RunResult run = run_weft({"check", folder / "a.json"}, colors({{"FORCE_COLOR", "1"}}));
    EXPECT_EQ(run.err.find("\x1b[31m"), std::string::npos) << run.text();
}

// Expects that a location in a SARIF log has a URI without invalid characters, line and column numbers from
// 1, and JSON pointers that begin with "/".
void expect_location(const Json& location, const Json& run) {
    if (location.contains("physicalLocation")) {
        const Json& physical = location.at("physicalLocation");
        const std::string uri = physical.at("artifactLocation").at("uri");
        EXPECT_FALSE(uri.empty());
        EXPECT_EQ(uri.find_first_of(" \"<>\\^`{|}"), std::string::npos) << uri;
        if (physical.contains("region")) {
            const Json& region = physical.at("region");
            EXPECT_GE(region.at("startLine"), 1);
            if (region.contains("startColumn")) {
                EXPECT_GE(region.at("startColumn"), 1);
                EXPECT_GT(region.at("endColumn"), region.at("startColumn"));
                EXPECT_EQ(run.at("columnKind"), "utf16CodeUnits");
            }
        }
    }
    for (const Json& logical : location.value("logicalLocations", Json::array()))
        EXPECT_TRUE(logical.at("fullyQualifiedName").get<std::string>().starts_with("/"));
}

void expect_result(const Json& result, const Json& run) {
    const Json& rules = run.at("tool").at("driver").at("rules");
    EXPECT_TRUE(result.at("message").at("text").is_string());
    const std::string level = result.at("level");
    EXPECT_TRUE(level == "error" || level == "warning") << level;
    EXPECT_EQ(rules.at(result.at("ruleIndex").get<size_t>()).at("id"), result.at("ruleId"));
    for (const char* list : {"locations", "relatedLocations"})
        for (const Json& location : result.value(list, Json::array())) expect_location(location, run);
    for (const Json& related : result.value("relatedLocations", Json::array())) {
        EXPECT_TRUE(related.at("id").is_number_unsigned());
        EXPECT_TRUE(related.at("message").at("text").is_string());
    }
}

Json expect_log(const std::string& text) {
    const Json log = Json::parse(text);
    EXPECT_EQ(log.at("version"), "2.1.0");
    EXPECT_EQ(log.at("$schema"), "https://json.schemastore.org/sarif-2.1.0.json");
    EXPECT_EQ(log.at("runs").size(), 1u);
    const Json& run = log.at("runs")[0];
    const Json& driver = run.at("tool").at("driver");
    EXPECT_EQ(driver.at("name"), "weft");
    EXPECT_FALSE(driver.at("version").get<std::string>().empty());
    EXPECT_TRUE(run.at("invocations")[0].at("executionSuccessful").get<bool>());
    std::vector<std::string> ids;
    for (const Json& rule : driver.at("rules")) {
        ids.push_back(rule.at("id"));
        EXPECT_FALSE(rule.at("shortDescription").at("text").get<std::string>().empty()) << ids.back();
        const std::string help = rule.at("help").at("text");
        EXPECT_NE(help.find("docs/diagnostics.md, section \""), std::string::npos) << help;
        // A link to the local documentation would be invalid on another machine, so no rule has a `helpUri`.
        EXPECT_FALSE(rule.contains("helpUri"));
    }
    EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end()) << "a rule twice";
    for (const Json& result : run.at("results")) expect_result(result, run);
    return log;
}

TEST(CheckSarif, OfAGoodGraphHoldsNoResults) {
    const RunResult run = run_weft({"check", "--sarif", kDeferredGraph});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_TRUE(run.err.empty()) << run.text();
    const Json log = expect_log(run.out);
    EXPECT_TRUE(log.at("runs")[0].at("results").is_array());
    EXPECT_TRUE(log.at("runs")[0].at("results").empty());
}

TEST(CheckSarif, SaysWhatJsonSays) {
    const RunResult run = run_weft({"check", "--sarif", kBad});
    EXPECT_EQ(run.exit_code, 3) << run.text();
    const Json log = expect_log(run.out);
    ASSERT_EQ(log.at("runs")[0].at("results").size(), 1u);
    const Json result = log.at("runs")[0].at("results")[0];
    const Json fault = Json::parse(run_weft({"check", "--json", kBad}).out)[0];
    EXPECT_EQ(result.at("ruleId"), fault.at("code"));
    const std::string text = result.at("message").at("text");
    EXPECT_TRUE(text.starts_with(fault.at("message").get<std::string>())) << text;
    EXPECT_NE(text.find("help: " + fault.at("help")[0].get<std::string>()), std::string::npos) << text;
    const Json& location = result.at("locations")[0];
    EXPECT_EQ(location.at("physicalLocation").at("region").at("startLine"), fault.at("line"));
    EXPECT_EQ(location.at("physicalLocation").at("region").at("startColumn"), fault.at("column"))
        << "all is ASCII";
    EXPECT_EQ(location.at("logicalLocations")[0].at("fullyQualifiedName"), fault.at("pointer"));
}

TEST(CheckSarif, IsWellFormedForEveryBadFile) {
    std::vector<std::string> arguments{"check", "--sarif"};
    for (const auto& entry : std::filesystem::directory_iterator(WEFT_SOURCE_DIR "/tests/diagnostics"))
        if (entry.path().extension() == ".json") arguments.push_back(entry.path().string());
    std::sort(arguments.begin() + 2, arguments.end());
    const RunResult run = run_weft(arguments);
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_GT(expect_log(run.out).at("runs")[0].at("results").size(), 5u);
}

// The output of --json counts columns in bytes of UTF-8; the output of --sarif counts them in UTF-16 units.
// The letter é has 2 bytes and 1 unit; 🎈 has 4 bytes and 2 units. So the columns after both differ by 3.
TEST(CheckSarif, ColumnsAreUtf16AndPathsAreUris) {
    const ScratchFolder folder;
    folder.write("a b%ü.json", "{ \"version\": 1, /* \xC3\xA9 \xF0\x9F\x8E\x88 */ \"nmae\": 1 }\n");
    const RunResult json = run_weft({"check", "--json", "a b%ü.json"}, {}, folder.path());
    const RunResult run = run_weft({"check", "--sarif", "a b%ü.json"}, {}, folder.path());
    const Json log = expect_log(run.out);
    const Json faults = Json::parse(json.out), results = log.at("runs")[0].at("results");
    const auto fault =
        std::find_if(faults.begin(), faults.end(), [](const Json& f) { return f.at("code") == "W101"; });
    ASSERT_NE(fault, faults.end()) << json.text();
    const Json& physical =
        results[static_cast<size_t>(fault - faults.begin())].at("locations")[0].at("physicalLocation");
    EXPECT_EQ(physical.at("artifactLocation").at("uri"), "a%20b%25%C3%BC.json");
    EXPECT_EQ(fault->at("column").get<int>() - physical.at("region").at("startColumn").get<int>(), 3);
    EXPECT_EQ(
        physical.at("region").at("endColumn").get<int>() - physical.at("region").at("startColumn").get<int>(),
        6);
}

// The notes of a message become related locations in SARIF. An example is a note that names the file which
// includes a faulty shader.
TEST(CheckSarif, NotesAreRelatedLocations) {
    const ScratchFolder folder;
    folder.write("x/x.comp",
                 "#version 460\n#include \"part.glsl\"\nlayout(local_size_x = 8) in;\nvoid main() {}\n");
    folder.write("x/part.glsl", "float broken() { return nothing; }\n");
    folder.write(
        "a.json",
        R"({ "version": 1, "name": "a", "imports": { "backbuffer": "output" }, "resources": { "r": "rgba8" },
        "passes": { "p": { "type": "compute", "shader": "x/x.comp", "out": ["r"] } } })");
    const RunResult run = run_weft({"check", "--sarif", folder / "a.json"});
    const Json log = expect_log(run.out);
    size_t related = 0;
    for (const Json& result : log.at("runs")[0].at("results"))
        related += result.value("relatedLocations", Json::array()).size();
    EXPECT_GT(related, 0u) << run.text();
}

}  // namespace
}  // namespace weft::test
