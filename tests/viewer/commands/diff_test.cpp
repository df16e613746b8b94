// Tests the output of `weft diff` for two plans.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;

// Returns the text of the shipped graph deferred.json with the text `what` replaced by `by`.
std::string changed_graph(const std::string& what, const std::string& by) {
    std::ifstream in(kDeferredGraph);
    std::ostringstream content;
    content << in.rdbuf();
    std::string text = content.str();
    const size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

// Returns a graph that includes deferred.json and gives its image `albedo` another format.
std::string with_format_of_albedo(const std::string& format) {
    return R"({ "version": 1, "name": "deferred", "include": ["deferred.json"], "resources": { "albedo": ")" +
           format + R"(" } })";
}

TEST(Diff, APlanAndItselfAreTheSame) {
    const RunResult run = run_weft({"diff", kDeferredGraph, kDeferredGraph});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_EQ(run.out, "the two plans are identical\n");
    const RunResult json = run_weft({"diff", kDeferredGraph, kDeferredGraph, "--json"});
    EXPECT_TRUE(Json::parse(json.out).at("same").get<bool>()) << json.text();
}

TEST(Diff, AnotherFormatIsAChangeOfItsResource) {
    const ScratchFolder scratch;
    scratch.write("exact.json", with_format_of_albedo("rgb10a2"));
    const RunResult run = run_weft({"diff", kDeferredGraph, scratch / "exact.json"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    expect_parts(run.out, {"~ albedo\n      - format rgba8\n", "      + format rgb10a2\n"});
    EXPECT_EQ(run.out.find("~ gbuffer"), std::string::npos) << "its passes are as they were\n" << run.out;
    const RunResult back = run_weft({"diff", scratch / "exact.json", kDeferredGraph, "--json"});
    const Json json = Json::parse(back.out);
    EXPECT_FALSE(json.at("same").get<bool>());
    EXPECT_EQ(json.at("resources").at("changed")[0].at("name"), "albedo");
    EXPECT_TRUE(json.at("passes").at("changed").empty()) << back.out;
}

TEST(Diff, ALargerFormatIsAChangeOfMemory) {
    const ScratchFolder scratch;
    scratch.write("wide.json", with_format_of_albedo("rgba16f"));
    const RunResult run = run_weft({"diff", kDeferredGraph, scratch / "wide.json"});
    expect_parts(run.out,
                 {"+3600.0 KiB heap", "~ albedo\n      - format rgba8\n", "      + format rgba16f\n"});
    const RunResult back = run_weft({"diff", scratch / "wide.json", kDeferredGraph, "--json"});
    const Json json = Json::parse(back.out);
    EXPECT_GT(json.at("counts").at("heap_bytes").at("from"), json.at("counts").at("heap_bytes").at("to"));
}

TEST(Diff, PassesComeAndGo) {
    const ScratchFolder scratch;
    scratch.write("more.json", changed_graph("\"lightUpload\": {",
                                             "\"snapshot\": { \"type\": \"readback\", \"in\": { \"src\": "
                                             "\"hdr@lighting\" } },\n    \"lightUpload\": {"));
    const RunResult run = run_weft({"diff", kDeferredGraph, scratch / "more.json"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    expect_parts(run.out, {"+1 pass", "  + snapshot\n"});
    const RunResult back = run_weft({"diff", scratch / "more.json", kDeferredGraph});
    expect_parts(back.out, {"-1 pass", "  - snapshot\n"});
}

TEST(Diff, AFaultInEitherFileIsReported) {
    const RunResult run = run_weft({"diff", kDeferredGraph, "no_such_graph.json"});
    EXPECT_EQ(run.exit_code, 3) << run.text();
    expect_parts(run.err, {"no_such_graph.json", "error[W002]"});
}

}  // namespace
}  // namespace weft::test
