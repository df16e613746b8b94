// Parses a graph's own tests, which say what to render and which results to expect.
#include <algorithm>

#include "graph/diagnostics/quantity_text.h"
#include "graph/parse/parse_context.h"
#include "graph/parse/reference.h"

namespace weft {
namespace {

constexpr int64_t kMostFrames = 10'000;
constexpr int64_t kMostSide_px = 16'384;

struct TestDraft {
    const GraphDesc& graph;
    GraphTestDesc test;
    // Names of tiers: `names` are tiers that each get a separate run, and `swaps` are the tiers that one run
    // switches between.
    std::vector<std::string> names, swaps;
    std::vector<SourceLoc> name_locs, swap_locs;
    // True for "tiers": "*": one run for each tier of the graph, and one run without a tier.
    bool all_tiers = false;
};

// Checks that a reference such as "hdr" or "bloom.mip(1)" is valid and that its resource exists. If not,
// reports an error and returns false.
bool check_ref(ParseContext& context, const TestDraft& draft, const std::string& text, SourceLoc loc) {
    Result<RefDesc> ref = parse_reference({text, loc}, context.sources());
    if (!ref) {
        context.add(ref.take_errors());
        return false;
    }
    if (!context.complete(*ref)) return false;
    if (draft.graph.resources.contains(ref->name) || draft.graph.imports.contains(ref->name)) return true;
    std::vector<std::string> known;
    for (const auto& [name, unused] : draft.graph.resources) known.push_back(name);
    const std::string near = did_you_mean_text(ref->name, known);
    context.error(loc, "W103", "the test checks the unknown resource \"" + ref->name + "\"",
                  near.empty() ? "name a resource of \"resources\"" : near);
    return false;
}

constexpr const char* kValidation = "validation";
constexpr const char* kPasses = "passes";
constexpr const char* kBarriers = "barriers";
constexpr const char* kSubmissions = "submissions";
constexpr const char* kTransientBytes = "transientBytes";
constexpr const char* kBlackFrames = "blackFrames";
constexpr const char* kPipelines = "pipelinesOnFrameThread";
constexpr const char* kFinite = "finite";
constexpr const char* kKept = "kept";
constexpr const char* kRange = "range";
constexpr const char* kMean = "mean";

template <char const* const& What>
void read_refs(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    std::vector<std::string> refs;
    std::vector<SourceLoc> locs;
    read_names(context, node, refs, locs);
    for (size_t i = 0; i < refs.size(); ++i)
        if (check_ref(context, draft, refs[i], locs[i]))
            draft.test.expect.push_back({What, refs[i], 0, 0, locs[i]});
}

template <char const* const& What>
void read_bounds(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    if (!expect(context, node, JsonKind::object)) return;
    for (const JsonMember& member : node.members) {
        const PointerScope scope(context, member.key);
        std::array<double, 2> bounds{};
        if (!check_ref(context, draft, member.key, member.key_loc)) continue;
        if (!read_numbers(context, member.value, bounds)) continue;
        if (bounds[0] > bounds[1])
            context.error(member.value.loc, "W109", "the lower bound is greater than the upper bound",
                          "write [lower bound, upper bound]");
        draft.test.expect.push_back({What, member.key, bounds[0], bounds[1], member.key_loc});
    }
}

template <char const* const& What>
void read_most(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    double most = 0;
    if (!read_number(context, node, most)) return;
    if (most < 0)
        return context.error(node.loc, "W109", "found " + node.string + ", wanted a maximum",
                             "write 0 or a greater number");
    draft.test.expect.push_back({What, "", 0, most, node.loc});
}

constexpr std::array kExpectKeys{KeyRule<TestDraft>{kValidation, read_most<kValidation>},
                                 KeyRule<TestDraft>{kPasses, read_most<kPasses>},
                                 KeyRule<TestDraft>{kBarriers, read_most<kBarriers>},
                                 KeyRule<TestDraft>{kSubmissions, read_most<kSubmissions>},
                                 KeyRule<TestDraft>{kTransientBytes, read_most<kTransientBytes>},
                                 KeyRule<TestDraft>{kBlackFrames, read_most<kBlackFrames>},
                                 KeyRule<TestDraft>{kPipelines, read_most<kPipelines>},
                                 KeyRule<TestDraft>{kFinite, read_refs<kFinite>},
                                 KeyRule<TestDraft>{kKept, read_refs<kKept>},
                                 KeyRule<TestDraft>{kRange, read_bounds<kRange>},
                                 KeyRule<TestDraft>{kMean, read_bounds<kMean>}};

void read_expect(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    read_object(context, node, "the expectations of a test", kExpectKeys, draft);
}

void read_test_tiers(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    draft.all_tiers = node.kind == JsonKind::string && node.string == "*";
    if (!draft.all_tiers) read_names(context, node, draft.names, draft.name_locs);
}

void read_swap(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    read_names(context, node, draft.swaps, draft.swap_locs);
    if (node.kind == JsonKind::array && node.items.size() < 2)
        context.error(node.loc, "W109", "a test that changes tiers needs two or more tiers",
                      "write for example [\"low\", \"high\", \"low\"]");
}

void read_positive_count(ParseContext& context, const JsonNode& node, uint32_t& out) {
    int64_t count = 0;
    if (read_integer(context, node, 1, kMostFrames, count)) out = static_cast<uint32_t>(count);
}

void read_test_size(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    if (!expect_items(context, node, 2, "two", "write a size as [width, height]")) return;
    std::array<int64_t, 2> size{};
    for (size_t i = 0; i < size.size(); ++i)
        if (!read_integer(context, node.items[i], 1, kMostSide_px, size[i])) return;
    // Bytes per texel that a test needs: 4 for the picture and 4 for the copy of the picture in readback
    // memory.
    constexpr uint64_t kBytesPerTexel = 8;
    const auto bytes = static_cast<uint64_t>(size[0] * size[1]) * kBytesPerTexel;
    if (bytes > context.limits().test_bytes)
        return context.error(node.loc, "W125",
                             "a picture of " + node.items[0].string + "x" + node.items[1].string +
                                 " px needs more memory than the limit for a test, which is " +
                                 limit_bytes_text(context.limits().test_bytes),
                             "make the picture smaller, " + raise_limit_text("graph.testBytes"));
    draft.test.size = {static_cast<uint32_t>(size[0]), static_cast<uint32_t>(size[1]), 1};
}

void read_scene(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    if (!read_string(context, node, draft.test.scene) || draft.test.scene.starts_with("builtin:")) return;
    context.error(node.loc, "W109", "\"" + draft.test.scene + "\" is not a built-in scene",
                  "name a built-in scene, for example \"builtin:spheres\": a test uses no scene files");
}

void read_test_params(ParseContext& context, const JsonNode& node, TestDraft& draft) {
    if (!expect(context, node, JsonKind::object)) return;
    for (const JsonMember& member : node.members) {
        const PointerScope scope(context, member.key);
        double value = member.value.boolean ? 1 : 0;
        if (!draft.graph.params.contains(member.key))
            context.error(member.key_loc, "W120", "the graph has no parameter \"" + member.key + "\"",
                          "name a parameter of \"params\"");
        else if (member.value.kind == JsonKind::boolean || read_number(context, member.value, value))
            draft.test.params[member.key] = value;
    }
}

void check_tier_names(ParseContext& context, const TestDraft& draft, const std::vector<std::string>& names,
                      const std::vector<SourceLoc>& locs) {
    std::vector<std::string> known;
    for (const TierDesc& tier : draft.graph.tiers) known.push_back(tier.name);
    for (size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::find(known, names[i]) != known.end()) continue;
        const std::string near = did_you_mean_text(names[i], known);
        context.error(locs[i], "W129", "the graph has no tier \"" + names[i] + "\"",
                      !near.empty()   ? near
                      : known.empty() ? "this graph has no tiers: remove the tier name"
                                      : "choose one of its tiers: " + quoted_list(known));
    }
}

GraphTestDesc finished(ParseContext& context, TestDraft draft) {
    check_tier_names(context, draft, draft.names, draft.name_locs);
    check_tier_names(context, draft, draft.swaps, draft.swap_locs);
    draft.test.swap = std::move(draft.swaps);
    draft.test.tiers = std::move(draft.names);
    if (draft.all_tiers)
        for (const TierDesc& tier : draft.graph.tiers) draft.test.tiers.push_back(tier.name);
    if (draft.all_tiers || draft.test.tiers.empty()) draft.test.tiers.emplace_back();
    return std::move(draft.test);
}

// Returns the total number of frames of all runs of a test. If a test gives no number of frames, the graph's
// number applies. The graph's number may be an expression that has no value yet, so such a run counts as one
// frame here.
size_t stated_frames(const GraphTestDesc& test) {
    return test.swap.empty() ? test.tiers.size() * std::max(1u, test.frames)
                             : test.swap.size() * size_t{test.every};
}

constexpr std::array kTestKeys{
    KeyRule<TestDraft>{"tiers", read_test_tiers},
    KeyRule<TestDraft>{"swap", read_swap},
    KeyRule<TestDraft>{"every", [](ParseContext& c, const JsonNode& n,
                                   TestDraft& d) { read_positive_count(c, n, d.test.every); }},
    KeyRule<TestDraft>{"scene", read_scene},
    KeyRule<TestDraft>{"size", read_test_size},
    KeyRule<TestDraft>{"frames", [](ParseContext& c, const JsonNode& n,
                                    TestDraft& d) { read_positive_count(c, n, d.test.frames); }},
    KeyRule<TestDraft>{"params", read_test_params},
    KeyRule<TestDraft>{"expect", read_expect}};

}  // namespace

void list_test_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "test", kTestKeys);
    list_keys(lists, "expectation", kExpectKeys);
}

void parse_tests(ParseContext& context, const JsonNode& node, GraphDesc& graph) {
    if (!expect(context, node, JsonKind::array)) return;
    size_t runs = 0, frames = 0;
    for (size_t i = 0; i < node.items.size() && !context.is_full(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        TestDraft draft{graph, {}, {}, {}, {}, {}, false};
        draft.test.loc = node.items[i].loc;
        if (read_object(context, node.items[i], "a test", kTestKeys, draft))
            graph.tests.push_back(finished(context, std::move(draft)));
        else
            continue;
        const GraphTestDesc& test = graph.tests.back();
        runs += test.swap.empty() ? test.tiers.size() : test.swap.size();
        if (!context.within(runs, context.limits().test_runs, test.loc, "test runs, counted for each tier",
                            "graph.testRuns", "remove tests, or run them with fewer tiers"))
            return;
        frames += stated_frames(test);
        if (!context.within(frames, context.limits().test_frames, test.loc, "frames in its tests",
                            "graph.testFrames", "reduce the frames of its tests"))
            return;
    }
}

}  // namespace weft
