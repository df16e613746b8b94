// Tests that graphs and profiles which are too large, nested too deeply or request too much are refused
// before they cost much memory or time.
#include <gtest/gtest.h>

#include "tests/viewer/hostile/hostile_run.h"

namespace weft::test {
namespace {

class HostileGraph : public testing::Test {
 protected:
    RunResult check(const std::string& text, const std::vector<std::string>& more = {}) const {
        scratch_.write("graph.json", text);
        std::vector<std::string> arguments{"check", scratch_ / "graph.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_weft(arguments);
    }

    static std::string graph(const std::string& resources, const std::string& passes) {
        return R"({ "version": 1, "imports": { "backbuffer": "output" },
  "resources": { )" +
               resources + R"( },
  "passes": { )" +
               passes +
               R"( }
})";
    }
    static std::string clears_x(const std::string& more) {
        return graph(R"("x": "rgba8")", R"("p": { "type": "clear", "out": ["x"], )" + more + " }");
    }

    ScratchFolder scratch_;
};

TEST_F(HostileGraph, DeepJson) {
    for (const char* open : {"[", "{\"a\":", "[{\"a\":"})
        for (const char* before : {"", "{ \"version\": 1, \"passes\": "}) {
            std::string text = before;
            for (int i = 0; i < 100'000; ++i) text += open;
            expect_refused_cheaply(check(text),
                                   {"graph.json:1:", "error[W004]", "64 levels deep", "graph.jsonDepth"});
        }
}

TEST_F(HostileGraph, DuplicateKeysByTheHundredThousand) {
    std::string text = "{ \"version\": 1";
    for (int i = 0; i < 200'000; ++i) text += ", \"a\": 1";
    expect_refused_cheaply(check(text + "}"),
                           {"graph.json:1:25: error[W003]", "the key \"a\" occurs twice in this object"});
}

TEST_F(HostileGraph, UnknownKeysByTheHundredThousand) {
    std::string text = "{ \"version\": 1";
    for (int i = 0; i < 200'000; ++i) text += ", \"k" + std::to_string(i) + "\": 1";
    expect_refused_cheaply(check(text + "}"), {"graph.json:1:17: error[W101]", "unknown key \"k0\""});
}

TEST_F(HostileGraph, LargeFiles) {
    expect_refused_cheaply(check("{ \"name\": \"" + std::string(9u << 20, 'x') + "\" }"),
                           {"graph.json: error[W004]", "more than 8 MiB", "graph.jsonBytes"});
    // This sparse file has 2 GiB. `weft` must refuse the file because of its size, without reading it.
    scratch_.write("graph.json", "{");
    std::filesystem::resize_file(scratch_ / "graph.json", uint64_t{2} << 30);
    const RunResult run = run_weft({"check", scratch_ / "graph.json"});
    expect_refused_cheaply(run, {"error[W004]"});
    EXPECT_LE(run.max_rss_bytes, uint64_t{128} << 20);
    expect_refused_cheaply(check("[" + std::string(600'000, '\n') + "1" +
                                 [] {
                                     std::string many;
                                     for (int i = 0; i < 300'000; ++i) many += ",1";
                                     return many;
                                 }() +
                                 "]"),
                           {"error[W004]", "262144 values"});
}

TEST_F(HostileGraph, TooManyPasses) {
    const auto refused = [&](const std::string& repeat) {
        expect_refused_cheaply(check(clears_x(repeat)),
                               {"graph.json:3:", "error[W125]", "more than 4096 passes",
                                "at /passes/p/repeat/i", "graph.passes"});
    };
    refused(R"("repeat": { "i": "0..4096" })");
    refused(R"("repeat": { "i": "0..99", "j": "0..99" })");
    refused(R"("repeat": { "i": "0..1000000000" }, "if": "0")");
    refused(R"("repeat": { "i": "0..1000000000", "j": "1..0" })");
    expect_refused_cheaply(
        check(clears_x(R"("repeat": { "i": "0..9007199254740992 * 9007199254740992" }, "if": "0")")),
        {"graph.json:3:", "error[W109]", "a repeat needs whole numbers", "at /passes/p/repeat/i"});
    const RunResult most = check(
        graph(R"("x": "rgba8")", R"("p": { "type": "clear", "out": ["x"], "repeat": { "i": "0..4094" } },
    "z": { "type": "clear", "out": ["backbuffer"] })"));
    EXPECT_EQ(most.exit_code, 0) << "4,096 are fine\n" << most.text();
    std::string many;
    for (int i = 0; i < 5; ++i)
        many += (i == 0 ? "" : ", ") + std::string("\"p") + std::to_string(i) +
                R"(": { "type": "clear", "out": ["x"], "repeat": { "i": "0..999" } })";
    expect_refused_cheaply(check(graph(R"("x": "rgba8")", many)),
                           {"error[W125]", "with pass \"p4\" the graph has more than 4096 passes"});
}

TEST_F(HostileGraph, TooManyPorts) {
    std::string ports;
    for (int i = 0; i < 200; ++i) ports += (i == 0 ? "\"p" : ", \"p") + std::to_string(i) + "\": \"x\"";
    expect_refused_cheaply(
        check(graph(R"("x": "rgba8")",
                    R"("r": { "type": "readback", "repeat": { "i": "0..4000" }, "in": { )" + ports + " } }")),
        {"error[W125]", "more than 262144 ports", "graph.ports"});
}

TEST_F(HostileGraph, TooManyResources) {
    std::string names;
    for (int i = 0; i < 17'000; ++i)
        names += (i == 0 ? "\"r" : ", \"r") + std::to_string(i) + "\": \"rgba8\"";
    expect_refused_cheaply(check(graph(names, "")),
                           {"graph.json:2:", "error[W125]", "17001 resources", "graph.resources"});
    std::string rings;
    for (int i = 0; i < 1000; ++i)
        rings +=
            (i == 0 ? "\"r" : ", \"r") + std::to_string(i) + R"(": { "format": "rgba8", "history": 16 })";
    expect_refused_cheaply(check(graph(rings, "")), {"error[W125]", "17001 resources"});
}

TEST_F(HostileGraph, ImagesBeyondTheLimits) {
    const auto refused = [&](const std::string& image, const std::string& message) {
        expect_refused_cheaply(
            check(graph("\"x\": { " + image + " }", R"("p": { "type": "clear", "out": ["x"] })"),
                  {"--profile", scratch_ / "big.json"}),
            {"graph.json:2:", "at /resources/x", message});
    };
    // This profile describes a device with practically unlimited image sizes, so that only the limits of
    // `weft` apply.
    std::string profile = run_weft({"doctor", "--json"}).out;
    if (profile.empty()) profile = read_text(WEFT_SOURCE_DIR "/framework/profiles/lavapipe.json");
    const auto raised = [&](const char* key) {
        const size_t at = profile.find(':', profile.find(key)) + 1;
        profile.replace(at, profile.find_first_of(",}\n", at) - at, " 4294967295");
    };
    raised("\"maxImage2dPx\"");
    raised("\"maxImageLayers\"");
    scratch_.write("big.json", profile);
    refused(R"("format": "rgba8", "size": [65536, 1])", "the limit is 16384 px for each side");
    refused(R"("format": "rgba8", "size": [1e30, 1e30], "mips": "full")",
            "the limit is 16384 px for each side");
    refused(R"("format": "rgba8", "size": [65536, 65536], "mips": "full")", "17 mips; the limit is 15 mips");
    refused(R"("format": "rgba8", "size": [1, 1], "layers": 2049)", "2049 layers; the limit is 2048 layers");
    refused(R"("format": "rgba32f", "size": [16384, 16384], "layers": 2048, "mips": "full")",
            "\"x\" needs more than 4 GiB of memory");
    refused(R"("buffer": "mat4", "count": "1e30 * 1e30")", "W1");
}

TEST_F(HostileGraph, MemoryBeyondTheBudget) {
    std::string images, clears, reads;
    for (int i = 0; i < 20; ++i) {
        const std::string n = std::to_string(i);
        images += (i == 0 ? "\"x" : ", \"x") + n +
                  R"(": { "format": "rgba32f", "size": [8192, 8192], "keep": true })";
        clears += "\"c" + n + R"(": { "type": "clear", "out": ["x)" + n + R"("] }, )";
        reads += "\"r" + n + R"(": { "type": "readback", "in": ["x)" + n + R"("] }, )";
    }
    const std::string text =
        graph(images, clears + reads + R"("z": { "type": "clear", "out": ["backbuffer"] })");
    expect_refused_cheaply(
        check(text),
        {"graph.json: error[W143]", "20480.0 MiB of memory; the limit is 4 GiB", "graph.transientBytes"});
    if (!has_device()) return;
    const RunResult run = run_weft({"render", "builtin:spheres", "--size", "16x16", "--graph",
                                    scratch_ / "graph.json", "-o", scratch_ / "a.png"});
    expect_refused_cheaply(run, {"error[W143]", "graph.transientBytes"});
}

TEST_F(HostileGraph, Profiles) {
    const std::string good = graph("", R"("z": { "type": "clear", "out": ["backbuffer"] })");
    scratch_.write("deep.json", "{ \"name\": " + std::string(400'000, '['));
    scratch_.write("closed.json",
                   "{ \"name\": " + std::string(400'000, '[') + std::string(400'000, ']') + "}");
    scratch_.write("large.json", std::string(2u << 20, ' '));
    for (const char* file : {"deep.json", "closed.json", "large.json"})
        expect_refused_cheaply(check(good, {"--profile", scratch_ / file}), {file, "error[W140]"});
}

TEST_F(HostileGraph, MessagesCannotSteerATerminal) {
    const RunResult run = check(
        "{ \"version\": 1, \"\xE2\x80\xAE"
        "evil\\u001b[2J\xC2\x9B"
        "1m\": 1 }");
    EXPECT_EQ(run.exit_code, 3) << run.text();
    EXPECT_NE(run.err.find("?evil?[2J?1m"), std::string::npos) << run.text();
    for (const char* part : {"\x1b", "\xC2\x9B", "\xE2\x80\xAE"})
        EXPECT_EQ(run.err.find(part), std::string::npos) << run.text();
}

}  // namespace
}  // namespace weft::test
