// Tests every kind of question to `weft explain`, mostly about a shipped graph. The answers must contain
// lines and columns of the graph file.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

// The shipped graph and those of its modules that declare what the tests ask about.
const std::string kFiles[] = {kDeferredGraph, WEFT_SOURCE_DIR "/graphs/modules/gbuffer.json",
                              WEFT_SOURCE_DIR "/graphs/modules/forward_layers.json",
                              WEFT_SOURCE_DIR "/graphs/modules/tonemap.json"};

// Returns the first place of `text` after the first occurrence of `after`, as "file:line:column". The files
// are searched in the order of kFiles.
std::string place_of(const std::string& text, const std::string& after = "") {
    for (const std::string& file : kFiles) {
        std::ifstream in(file);
        std::ostringstream content;
        content << in.rdbuf();
        const std::string all = content.str();
        const size_t begin = all.find(after);
        const size_t at = begin == std::string::npos ? begin : all.find(text, begin);
        if (at == std::string::npos) continue;
        const auto line = 1 + std::count(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        const size_t line_start = at == 0 ? 0 : all.rfind('\n', at - 1) + 1;
        return file + ":" + std::to_string(line) + ":" + std::to_string(at - line_start + 1);
    }
    return "no " + text;
}

std::string ask(std::vector<std::string> question) {
    question.insert(question.begin(), {"explain", kDeferredGraph});
    const RunResult run = run_weft(question);
    EXPECT_EQ(run.exit_code, 0) << run.text();
    EXPECT_TRUE(run.err.empty()) << run.text();
    return run.out;
}

std::string pass_place(const std::string& name) {
    return place_of("\"" + name + "\":", "\"passes\"");
}

std::string port_place(const std::string& pass, const std::string& port) {
    return place_of("\"" + port + "\"", "\"" + pass + "\":");
}

// Returns the place of the resource that an input of a pass reads. The pass writes its inputs as "port":
// "resource".
std::string input_place(const std::string& pass, const std::string& port) {
    const std::string key = "\"" + port + "\": ";
    const std::string place = place_of(key, "\"" + pass + "\":");
    const size_t column = place.rfind(':') + 1;
    return place.substr(0, column) + std::to_string(std::stoul(place.substr(column)) + key.size());
}

TEST(Explain, ALivePassNamesWhoNeedsIt) {
    expect_parts(ask({"culled", "gbuffer"}),
                 {"\"gbuffer\" (" + pass_place("gbuffer") + ") is not culled",
                  "\"lighting\" (" + pass_place("lighting") + ") needs its result: port \"albedo\" (" +
                      input_place("lighting", "albedo") + ") reads \"albedo\"",
                  "The chain of readers ends at \"tonemap\" (" + pass_place("tonemap") + ")",
                  "writes \"backbuffer\", the output"});
}

// No pass reads the output of pass "second", so it is culled. Only "second" reads the output of pass "first",
// so "first" is culled too.
TEST(Explain, ACulledPassNamesItsReasonAndItsReaders) {
    const ScratchFolder scratch;
    scratch.write("graph.json", R"({
  "version": 1, "name": "extra",
  "imports": { "backbuffer": "output" },
  "resources": { "a": "rgba8", "b": "rgba8", "c": "rgba8" },
  "passes": {
    "first":  { "type": "clear", "out": ["a"] },
    "second": { "type": "copy", "in": { "src": "a" }, "out": { "dst": "b" } },
    "shown":  { "type": "clear", "out": ["c"] },
    "show":   { "type": "blit", "in": { "src": "c" }, "out": { "dst": "backbuffer" } }
  }
})");
    const std::string graph = scratch / "graph.json";
    const RunResult second = run_weft({"explain", graph, "culled", "second"});
    ASSERT_EQ(second.exit_code, 0) << second.text();
    expect_parts(second.out,
                 {"\"second\" (" + graph + ":7:5) is culled: no pass reads \"b\"", "port \"dst\" (" + graph});
    const RunResult first = run_weft({"explain", graph, "culled", "first"});
    expect_parts(first.out, {"is culled: \"a\" is read only by \"second\", which is culled too",
                             "\"second\" (" + graph + ":7:5) would read its result", "no pass reads \"b\""});
    const RunResult alias = run_weft({"explain", graph, "alias", "a", "c"});
    expect_parts(alias.out,
                 {"They share no memory", "has no memory, because no running pass uses this resource"});
    const RunResult barrier = run_weft({"explain", graph, "barrier", "first", "second"});
    expect_parts(barrier.out, {"There is no barrier", "is culled"});
}

TEST(Explain, ABarrierSaysWhoWaitsForWhomAndWhy) {
    expect_parts(ask({"barrier", "gbuffer", "lighting"}),
                 {"\"albedo\": a barrier before \"lighting\" (" + pass_place("lighting") +
                      ") waits for \"gbuffer\" (" + pass_place("gbuffer") + ")",
                  "a read after a write", "port \"albedo\" (" + port_place("gbuffer", "albedo") + ") writes",
                  "port \"albedo\" (" + input_place("lighting", "albedo") + ") reads",
                  "from    color_output color_write color_attachment",
                  "to      compute_shader sampled_read shader_read_only"});
}

TEST(Explain, WithoutABarrierItSaysWhyThereIsNone) {
    expect_parts(ask({"barrier", "lightUpload", "tonemap"}),
                 {"There is no barrier", "They use no common resource"});
    expect_parts(
        ask({"barrier", "gbuffer", "tonemap"}),
        {"There is no barrier between", "\"hdr\": the barrier before \"lighting\" (" + pass_place("lighting"),
         "has already waited for the first pass; that pass also writes this resource"});
    expect_parts(ask({"barrier", "lighting", "gbuffer"}),
                 {"\"lighting\"", "of the previous frame", "memory passes from one resource to another"});
}

TEST(Explain, AliasSaysWhoHoldsWhichBytesAndWhen) {
    expect_parts(ask({"alias", "hdr", "albedo"}),
                 {"They share no memory", "\"hdr\" (" + place_of("\"hdr\":"), "has bytes ",
                  "Both are alive from ", " \"gbuffer\" to ", " \"lighting\""});
    expect_parts(ask({"alias", "velocity", "lights"}),
                 {"They share memory", "\"lights\" (" + place_of("\"lights\":"),
                  "takes over the memory from \"velocity\""});
    expect_parts(ask({"alias", "hdr", "backbuffer"}),
                 {"They share no memory", "\"backbuffer\"", "is an import"});
    expect_parts(ask({"alias", "albedo", "lights", "--profile", "hostile"}),
                 {"They share no memory", "Buffers and images have separate heaps"});
    expect_parts(ask({"alias", "albedo", "depth", "--profile", "hostile"}),
                 {"They need different types of memory"});
}

TEST(Explain, WaitSpeaksOfOtherQueues) {
    expect_parts(ask({"wait", "lighting"}),
                 {"\"lighting\" (" + pass_place("lighting"), "the plan has only one queue"});
    expect_parts(ask({"wait", "lighting", "--queues", "3", "--profile", "discrete"}),
                 {"\"lighting\" (" + pass_place("lighting"), "runs in this submission: queue 0"});
}

TEST(Explain, WaitNamesTheOtherQueueAndThePortsBehindIt) {
    std::ifstream in(kDeferredGraph);
    std::ostringstream content;
    content << in.rdbuf();
    std::string text = content.str();
    const std::string lighting = "\"lighting\": {";
    const size_t at = text.find(lighting);
    ASSERT_NE(at, std::string::npos);
    const auto line = 1 + std::ranges::count(text.substr(0, at), '\n');
    text.insert(at + lighting.size(), " \"queue\": \"async\",");
    const ScratchFolder scratch;
    scratch.write("async.json", text);
    const std::string graph = scratch / "async.json";
    const RunResult run =
        run_weft({"explain", graph, "wait", "lighting", "--queues", "2", "--profile", "discrete"});
    EXPECT_EQ(run.exit_code, 0) << run.text();
    expect_parts(run.out,
                 {"runs in this submission: queue 1, ",
                  "Before the submission begins, it waits for queue 0, ", "must not start before",
                  "\"sunShadows#3\" (", "): port \"depth\" (", "writes \"sunShadow.mip(0).layer(3)\"",
                  "\"lighting\" (" + graph + ":" + std::to_string(line) + ":5): port \"",
                  "This submission must end before queue 0, "});
    const RunResult barrier = run_weft(
        {"explain", graph, "barrier", "gbuffer", "lighting", "--queues", "2", "--profile", "discrete"});
    EXPECT_EQ(barrier.exit_code, 0) << barrier.text();
    expect_parts(barrier.out, {"queue family 0 to 1"});
}

TEST(Explain, AResourceIsDescribedWithItsUsers) {
    expect_parts(ask({"resource", "hdr"}),
                 {"\"hdr\" (" + place_of("\"hdr\":") + ") is an image, rgba16f, 1280x720 (d2), transient",
                  "It needs 7200.0 KiB: bytes ", " of heap 0", " \"gbuffer\" to ", " \"tonemap\"",
                  " \"lighting\": port \"hdr\" (" + port_place("lighting", "hdr") + ") reads and writes",
                  "No other resource shares this memory"});
    expect_parts(ask({"resource", "hdr", "--size", "64x32"}), {"64x32", "It needs 16.0 KiB"});
}

TEST(Explain, AnUnknownNameIsGuessedAt) {
    const RunResult pass = run_weft({"explain", kDeferredGraph, "culled", "gbufer"});
    EXPECT_EQ(pass.exit_code, 3) << pass.text();
    expect_parts(pass.err, {"error[W104]", "no pass \"gbufer\"", "did you mean \"gbuffer\"?"});
    const RunResult both = run_weft({"explain", kDeferredGraph, "alias", "albdo", "hrd"});
    EXPECT_EQ(both.exit_code, 3) << both.text();
    expect_parts(both.err, {"error[W103]", "did you mean \"albedo\"?", "did you mean \"hdr\"?"});
}

TEST(Explain, TheNameOfARepeatStandsForAllItsRounds) {
    const std::string bloom = WEFT_SOURCE_DIR "/graphs/bloom.json";
    const auto answer = [&](std::vector<std::string> question) {
        question.insert(question.begin(), {"explain", bloom});
        return run_weft(question);
    };
    for (const char* question : {"culled", "wait"}) {
        const RunResult all = answer({question, "down"});
        EXPECT_EQ(all.exit_code, 0) << all.text();
        for (const char* round : {"down#1", "down#2", "down#3"})
            EXPECT_NE(all.out.find(answer({question, round}).out), std::string::npos) << round << all.text();
    }
    const RunResult pair = answer({"barrier", "down", "down#2"});
    EXPECT_EQ(pair.exit_code, 3) << pair.text();
    EXPECT_NE(pair.err.find("this name has several iterations: write one of \"down#1\", \"down#2\""),
              std::string::npos)
        << pair.text();
}

TEST(Explain, RestTellsWhatMakesAPassRun) {
    const std::string shadows = ask({"rest", "sunShadows#1"});
    for (const char* part : {"\"sunShadows#1\"", " rests", "draw list \"opaque\"", "draw list \"masked\"",
                             "view \"sun(1)\"", "shader \"sun_shadow\""})
        EXPECT_NE(shadows.find(part), std::string::npos) << shadows;
    EXPECT_NE(ask({"rest", "gbuffer"}).find("runs in every frame"), std::string::npos);
    const RunResult run =
        run_weft({"explain", WEFT_SOURCE_DIR "/tests/render/rest/rest.json", "rest", "halve"});
    for (const char* part : {"runs only together with \"blurred\"", "\"table\", if pass \"base\""})
        EXPECT_NE(run.out.find(part), std::string::npos) << run.text();
}

}  // namespace
}  // namespace weft::test
