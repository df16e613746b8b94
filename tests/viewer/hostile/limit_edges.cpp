#include "tests/viewer/hostile/limit_edges.h"

#include <algorithm>
#include <array>

namespace weft::test {
namespace {

using Text = std::string;

// Returns the text of a graph with these sections. The text `more` comes before the resources; it is empty or
// ends with a comma.
Text graph(const Text& more, const Text& resources, const Text& passes) {
    return "{ \"version\": 1, \"imports\": { \"backbuffer\": \"output\" },\n" + more + "\"resources\": { " +
           resources + " },\n\"passes\": { " + passes + (passes.empty() ? "" : ", ") +
           "\"show\": { \"type\": \"clear\", \"out\": [\"backbuffer\"] } } }";
}

void write_graph(const ScratchFolder& folder, const Text& more, const Text& resources = "",
                 const Text& passes = "") {
    folder.write("graph.json", graph(more, resources, passes));
}

template <class F>
Text joined(uint64_t count, F item) {
    Text text;
    for (uint64_t i = 0; i < count; ++i) text += (i == 0 ? Text() : Text(",\n")) + item(i);
    return text;
}

Text numbered(const char* prefix, uint64_t i) {
    return "\"" + Text(prefix) + std::to_string(i) + "\"";
}

Text clear_of(uint64_t first, uint64_t count) {
    return "\"type\": \"clear\", \"out\": [" +
           joined(count, [&](uint64_t i) { return numbered("r", first + i); }) + "]";
}

void json_bytes(const ScratchFolder& folder, uint64_t count) {
    Text text = graph("", "", "");
    text.resize(count, '\n');
    folder.write("graph.json", text);
}

void json_depth(const ScratchFolder& folder, uint64_t count) {
    folder.write("graph.json", "{ \"a\": " + Text(count - 1, '[') + Text(count - 1, ']') + " }");
}

void json_values(const ScratchFolder& folder, uint64_t count) {
    // Number of JSON values in the file besides the elements of "enum": those of graph() and of the
    // parameter.
    constexpr uint64_t kOthers = 14;
    write_graph(folder, "\"params\": { \"p\": { \"default\": 0, \"enum\": [" +
                            joined(count - kOthers, [](uint64_t) { return Text("0"); }) + "] } },\n");
}

void string_bytes(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder, "\"name\": \"" + Text(count, 'x') + "\",\n");
}

void name_bytes(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder, "", "\"" + Text(count, 'x') + "\": \"rgba8\"");
}

void include_files(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder, "\"include\": [" + joined(count, [](uint64_t i) {
                            return "\"" + std::to_string(i) + ".json\"";
                        }) + "],\n");
    for (uint64_t i = 0; i < count; ++i)
        folder.write(std::to_string(i) + ".json", "{ \"consts\": { \"c" + std::to_string(i) + "\": 1 } }");
}

void tiers(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder,
                "\"tiers\": { " +
                    joined(count,
                           [](uint64_t i) {
                               return numbered("t", i) +
                                      ": { \"patch\": { \"resources\": { \"x\": \"rgba8|r8\" } } }";
                           }) +
                    " },\n",
                "\"x\": \"rgba8\"", "\"p\": { \"type\": \"clear\", \"out\": [\"x\"] }");
}

// Writes a graph with `count` constants, each of which depends on the next one.
void constants(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder, "\"consts\": { " + joined(count, [&](uint64_t i) {
                            return numbered("c", i) + ": " +
                                   (i + 1 == count ? Text("1") : "\"c" + std::to_string(i + 1) + "+1\"");
                        }) + " },\n");
}

// Returns an expression with `parts` parts: "1+1+1…", with a minus sign in front if the number of parts is
// even. Each number and each operator is one part, so "-1+1" has four.
Text sum_of(uint64_t parts) {
    Text sum = parts % 2 == 0 ? "-1" : "1";
    for (uint64_t i = 0; i < (parts - 1) / 2; ++i) sum += "+1";
    return "\"" + sum + "\"";
}

void expression_parts(const ScratchFolder& folder, uint64_t count) {
    constexpr uint64_t kEach = 1001;
    const uint64_t rest = count % kEach;
    write_graph(
        folder,
        "\"consts\": { " +
            joined(count / kEach, [](uint64_t i) { return numbered("c", i) + ": " + sum_of(kEach); }) +
            (rest > 0 ? (count > kEach ? ", \"rest\": " : "\"rest\": ") + sum_of(rest) : "") + " },\n");
}

void repeat_indices(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder, "", "\"x\": \"rgba8\"",
                "\"p\": { \"type\": \"clear\", \"out\": [\"x\"], \"repeat\": { " +
                    joined(count, [](uint64_t i) { return numbered("i", i) + ": \"0..0\""; }) + " } }");
}

void debug_views(const ScratchFolder& folder, uint64_t count) {
    write_graph(
        folder,
        "\"debug\": { " + joined(count, [](uint64_t i) { return numbered("v", i) + ": \"x\""; }) + " },\n",
        "\"x\": \"rgba8\"", "\"p\": { \"type\": \"clear\", \"out\": [\"x\"] }");
}

void test_runs(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder,
                "\"tests\": [" + joined(count, [](uint64_t) { return Text("{ \"frames\": 1 }"); }) + "],\n");
}

void test_frames(const ScratchFolder& folder, uint64_t count) {
    constexpr uint64_t kEach = 1000;
    write_graph(folder, "\"tests\": [" + joined((count + kEach - 1) / kEach, [&](uint64_t i) {
                            return "{ \"frames\": " + std::to_string(std::min(kEach, count - i * kEach)) +
                                   " }";
                        }) + "],\n");
}

// Writes a graph with a test whose picture needs `count` bytes, rounded up to whole rows. The picture has 8
// bytes per texel.
void test_bytes(const ScratchFolder& folder, uint64_t count) {
    const uint64_t width = count >= (1u << 20) ? 8192 : 64;
    const uint64_t height = (count + width * 8 - 1) / (width * 8);
    write_graph(folder, "\"tests\": [{ \"size\": [" + std::to_string(width) + ", " + std::to_string(height) +
                            "] }],\n");
}

// Writes a graph with `count` passes. All except "show" form a chain, in which each pass copies the result of
// the previous pass.
void passes(const ScratchFolder& folder, uint64_t count) {
    // The pass "show" of graph() is one more pass.
    const uint64_t chain = count - 1;
    write_graph(
        folder, "",
        joined(chain, [](uint64_t i) { return numbered("r", i) + ": { \"format\": \"r8\", \"size\": 4 }"; }),
        joined(chain, [](uint64_t i) {
            return numbered("p", i) + ": { " +
                   (i == 0 ? clear_of(0, 1)
                           : "\"type\": \"copy\", \"in\": [" + numbered("r", i - 1) + "], \"out\": [" +
                                 numbered("r", i) + "]") +
                   " }";
        }));
}

void pass_ports(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder, "", joined(count, [](uint64_t i) { return numbered("r", i) + ": \"rgba8\""; }),
                "\"p\": { " + clear_of(0, count) + " }");
}

// Writes a graph with `count` ports in total. Iteration i of pass "p" has kEach ports and writes layer i of
// kEach images. If many passes wrote the same layer, the graph would exceed the limit graph.steps first.
void ports(const ScratchFolder& folder, uint64_t count) {
    constexpr uint64_t kEach = 128;
    // The pass "show" of graph() has one more port.
    const uint64_t others = count - 1;
    const uint64_t rounds = others / kEach, rest = others % kEach;
    const auto layer = [](uint64_t i) { return "\"r" + std::to_string(i) + ".layer(i)\""; };
    write_graph(folder, "",
                joined(kEach,
                       [&](uint64_t i) {
                           return numbered("r", i) + ": { \"format\": \"r8\", \"size\": 1, \"layers\": " +
                                  std::to_string(rounds) + " }";
                       }),
                "\"p\": { \"type\": \"clear\", \"out\": [" + joined(kEach, layer) +
                    "], \"repeat\": { \"i\": \"0.." + std::to_string(rounds - 1) + "\" } }" +
                    (rest > 0 ? ", \"q\": { " + clear_of(0, rest) + ", \"after\": [\"p\"] }" : ""));
}

void resources(const ScratchFolder& folder, uint64_t count) {
    // The output image is one more resource.
    write_graph(folder, "", joined(count - 1, [](uint64_t i) { return numbered("r", i) + ": \"rgba8\""; }));
}

void write_image(const ScratchFolder& folder, const Text& image) {
    write_graph(folder, "", "\"x\": { \"format\": \"r8\", " + image + " }",
                "\"p\": { \"type\": \"readback\", \"in\": [\"x\"] }, \"q\": { \"type\": \"clear\", \"out\": "
                "[\"x\"] }");
}

void image_side(const ScratchFolder& folder, uint64_t count) {
    write_image(folder, "\"size\": [" + std::to_string(count) + ", 1]");
}

void mips(const ScratchFolder& folder, uint64_t count) {
    write_image(folder,
                "\"mips\": \"full\", \"size\": [" + std::to_string(uint64_t{1} << (count - 1)) + ", 1]");
}

void layers(const ScratchFolder& folder, uint64_t count) {
    write_image(folder, "\"size\": 4, \"mips\": \"full\", \"layers\": " + std::to_string(count));
}

void buffer_pieces(const ScratchFolder& folder, uint64_t count) {
    write_graph(folder, "", "\"x\": { \"buffer\": \"u32\", \"count\": " + std::to_string(count) + " }",
                "\"p\": { \"type\": \"clear\", \"out\": [\"x.range(i)\"], \"repeat\": { \"i\": \"0.." +
                    std::to_string(count - 1) + "\" } }");
}

void transient_bytes(const ScratchFolder& folder, uint64_t count) {
    const uint64_t width = std::min<uint64_t>(count, 16'384);
    const uint64_t height = std::min<uint64_t>((count + width - 1) / width, 16'384);
    const uint64_t layers = (count + width * height - 1) / (width * height);
    write_image(folder, "\"size\": [" + std::to_string(width) + ", " + std::to_string(height) +
                            "], \"layers\": " + std::to_string(layers));
}

// Writes a graph that needs about `count` steps. Each pair of an iteration of "p" and an iteration of "q"
// costs about four steps.
void steps(const ScratchFolder& folder, uint64_t count) {
    constexpr uint64_t kStepsPerPair = 4;
    uint64_t each = 1;
    while (kStepsPerPair * each * each < count && each < 2047) ++each;
    const Text range = "\"repeat\": { \"i\": \"1.." + std::to_string(each) + "\" }";
    write_graph(
        folder, "", "\"x\": { \"format\": \"r8\", \"size\": 4 }, \"y\": { \"format\": \"r8\", \"size\": 4 }",
        "\"p\": { \"type\": \"clear\", \"out\": [\"x\"], " + range +
            " }, \"q\": { \"type\": \"clear\", \"out\": [\"y\"], \"after\": [\"p\"], " + range + " }");
}

constexpr std::array kEdges{
    LimitEdge{"graph.jsonBytes", 20'000, true, json_bytes},
    LimitEdge{"graph.jsonDepth", 20, false, json_depth},
    LimitEdge{"graph.jsonValues", 200, true, json_values},
    LimitEdge{"graph.stringBytes", 100, true, string_bytes},
    LimitEdge{"graph.nameBytes", 50, true, name_bytes},
    LimitEdge{"graph.includeFiles", 5, true, include_files},
    LimitEdge{"graph.tiers", 3, true, tiers},
    LimitEdge{"graph.constants", 300, true, constants},
    LimitEdge{"graph.expressionParts", 3000, true, expression_parts},
    LimitEdge{"graph.repeatIndices", 3, true, repeat_indices},
    LimitEdge{"graph.debugViews", 10, true, debug_views},
    LimitEdge{"graph.testRuns", 20, true, test_runs},
    LimitEdge{"graph.testFrames", 20, true, test_frames},
    LimitEdge{"graph.testBytes", 64 * 64 * 8, true, test_bytes},
    LimitEdge{"graph.passes", 40, true, passes},
    LimitEdge{"graph.passPorts", 20, true, pass_ports},
    LimitEdge{"graph.ports", 400, true, ports},
    LimitEdge{"graph.steps", 0, false, steps},
    LimitEdge{"graph.resources", 50, true, resources},
    LimitEdge{"graph.imageSidePx", 128, true, image_side},
    LimitEdge{"graph.mips", 5, true, mips},
    LimitEdge{"graph.layers", 16, true, layers},
    LimitEdge{"graph.bufferPieces", 16, true, buffer_pieces},
    LimitEdge{"graph.transientBytes", 4096, true, transient_bytes},
};

}  // namespace

std::span<const LimitEdge> limit_edges() {
    return kEdges;
}

}  // namespace weft::test
