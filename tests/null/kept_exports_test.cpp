// Tests plans whose program reads resources between frames that keep their content (GraphRequest::exports):
// in random graphs with history, kept images and buffers, passes at rest, groups and switches, on one to
// three queues, the program sees what the frame has left, and the next frame waits for its reads.
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "null/null_executor.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_groups.h"
#include "tests/graph/samples/random_rest.h"
#include "tests/graph/samples/random_switches.h"
#include "tests/graph/samples/random_text.h"
#include "tests/null/mutant_judge.h"
#include "tests/null/profile_plans.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

// Returns an access that reads and that the resource allows.
ExportUse random_use(const ResourceDecl& decl, std::mt19937& random) {
    std::vector<ExportUse> uses{{Access::copy_read}};
    if (decl.kind == ResourceKind::buffer) {
        uses.push_back({Access::storage_read, stage_bit(ShaderStage::vertex)});
    } else {
        const FormatInfo& format = format_info(decl.format);
        uses.push_back({Access::sampled_read});
        uses.push_back({Access::sampled_read, stage_bit(ShaderStage::vertex)});
        if (!format.depth && !format.stencil && !format.srgb && decl.samples == 1)
            uses.push_back({Access::storage_read, stage_bit(ShaderStage::compute)});
    }
    return uses[random() % uses.size()];
}

// Returns up to two resources that keep their content and that passes write.
std::map<std::string, ExportUse> kept_exports(const ResolvedGraph& graph, uint32_t seed) {
    std::vector<ResourceId> kept;
    for (const PassDecl& pass : graph.passes)
        for (const UseDecl& use : pass.uses)
            if (writes(use.access) && graph.resources[use.resource].ring == use.resource)
                kept.push_back(use.resource);
    std::mt19937 random(seed);
    std::map<std::string, ExportUse> exports;
    for (uint32_t i = 0; i <= seed % 2 && !kept.empty(); ++i) {
        const ResourceDecl& decl = graph.resources[kept[random() % kept.size()]];
        exports[decl.name] = random_use(decl, random);
    }
    return exports;
}

class KeptExports : public ResolveTest {
 protected:
    // Counts what the random graphs contain.
    struct Coverage {
        uint32_t exports = 0, rings = 0, buffers = 0, by_units = 0, general = 0;
    };

    KeptExports() {
        ResourceDecl& noise = imports.imports["noise"].resource;
        noise.format = Format::rgba16f;
        noise.import->entry = {stage::kComputeShader, access::kSampledRead, Layout::shader_read_only};
        noise.import->exit = noise.import->entry;
        noise.import->concurrent = true;
    }

    // All units and switches are on in frame 0. In the other frames, random ones are.
    static NullOptions random_options(const FramePlan& plan, uint32_t seed) {
        NullOptions options{.frames = 5, .seed = seed};
        options.order = seed % 3 == 0 ? NullOrder::delayed : NullOrder::shuffled;
        std::mt19937 random(seed);
        for (uint32_t frame = 0; frame < options.frames; ++frame) {
            std::vector<uint8_t>& rests = options.resting.emplace_back(plan.graph.rest_unit_count);
            for (uint8_t& unit : rests) unit = frame > 0 && random() % 2 == 0 ? 1 : 0;
            options.switches.push_back(frame == 0 ? kAllSwitchesOn : random() % kCombinationCount);
        }
        return options;
    }

    void note(const FramePlan& plan) {
        for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
            const ResourceDecl& decl = plan.graph.resources[id];
            if (!decl.between) continue;
            EXPECT_TRUE(plan.live.live_resources[id]) << decl.name;
            bool by_unit = false;
            for (PassId pass(0); pass < plan.graph.passes.size(); ++pass)
                for (const UseDecl& use : plan.graph.passes[pass].uses) {
                    if (use.resource != id || !writes(use.access)) continue;
                    EXPECT_TRUE(plan.live.live_passes[pass]) << plan.graph.passes[pass].name;
                    by_unit |= plan.graph.passes[pass].rest_unit != kNoId;
                }
            for (const BoundaryState& state : plan.boundary) {
                if (state.resource != id || decl.history > 0) continue;
                EXPECT_EQ(state.state.layout, decl.between->layout) << decl.name;
            }
            found_.exports += 1;
            found_.rings += decl.history > 0 ? 1 : 0;
            found_.buffers += decl.kind == ResourceKind::buffer ? 1 : 0;
            found_.by_units += by_unit ? 1 : 0;
            found_.general += by_unit && decl.between->layout == Layout::general ? 1 : 0;
        }
    }

    void judge(const ResolvedGraph& graph, uint32_t seed, uint32_t mutants_every) {
        DeviceProfile device;
        // The queues are of one family, or each of another one.
        if (seed % 4 > 1)
            device.queue_families = {
                {QueueKind::graphics, 1}, {QueueKind::compute, 1}, {QueueKind::transfer, 1}};
        CompileOptions options;
        options.queues = logical_queues(device, 1 + seed % 3);
        const FramePlan plan = compile(graph, content_needs(graph), options);
        ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
        note(plan);
        for (const uint32_t run : {seed, seed + 1}) {
            const NullOptions choice = random_options(plan, run);
            const NullRun wanted = run_reference(plan.graph, plan.live, choice.frames, choice.resting,
                                                 choice.inputs, choice.rounds, choice.switches);
            const NullRun found = run_null(plan, choice);
            const std::vector<std::string> different = differences(plan.graph, wanted, found);
            ASSERT_TRUE(different.empty()) << different.front() << "\n"
                                           << (found.faults.empty() ? "" : found.faults.front());
        }
        if (seed % mutants_every == 0) judge_mutants(plan, extended() ? 4 : 16, tallies_);
    }

    // Makes a graph of the text, once without exports to find what can be exported, and once with them.
    void judge_text(const std::string& text, uint32_t seed, uint32_t mutants_every) {
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
        exports.clear();
        const Result<ResolvedGraph> plain = run(text);
        if (!plain) return;
        exports = kept_exports(*plain, seed);
        if (!exports.empty()) judge(good(text), seed, mutants_every);
    }

    void finish() const {
        std::cout << found_.exports << " exports: " << found_.rings << " with history, " << found_.buffers
                  << " buffers, " << found_.by_units << " that units write, " << found_.general
                  << " of them in layout general\n";
        print(tallies_);
        for (const Tally& tally : tallies_) EXPECT_EQ(tally.missed, 0u);
    }

    Coverage found_;
    Tallies tallies_{};
};

// The oldest copy of a history is used again for the new frame. Its layers that no pass writes still have
// their first value, although the program reads them in another layout.
TEST_F(KeptExports, LayersThatNoPassWritesKeepTheirFirstValue) {
    shaders = rest_shaders();
    exports = {{"h", {Access::copy_read}}};
    const ResolvedGraph graph = good(R"j("resources": {
            "h": {"format": "rgba16f", "size": 64, "layers": 2, "history": 1},
            "x": {"format": "rgba16f", "size": 64}},
        "passes": {
            "make": {"type": "compute", "shader": "s0.comp", "out": {"dst": "h.layer(0)"}},
            "look": {"type": "compute", "shader": "s1.comp", "in": {"a": "h[-1].layer(1)"}, "out": {"dst": "x"}},
            "see": {"type": "readback", "in": ["x"]}})j");
    for (const uint32_t queues : {0u, 1u, 2u}) judge(graph, queues, 1);
    EXPECT_EQ(found_.rings, 3u);
}

TEST_F(KeptExports, TheProgramSeesHistoryAndKeptContent) {
    const uint32_t seeds = extended() ? 1500 : 60;
    for (uint32_t seed = 0; seed < seeds && !HasFailure(); ++seed) {
        const RandomText text = random_text(seed, fake_profile());
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Result<ResolvedGraph> plain = resolve_text(text.text, text.params, fake_profile());
        ASSERT_TRUE(plain) << to_text(plain.errors());
        const auto chosen = kept_exports(*plain, seed);
        if (chosen.empty()) continue;
        const Result<ResolvedGraph> graph = resolve_text(text.text, text.params, fake_profile(), 64, chosen);
        ASSERT_TRUE(graph) << to_text(graph.errors());
        judge(*graph, seed, 10);
    }
    finish();
    EXPECT_GE(found_.exports * 2, seeds);
    EXPECT_GE(found_.rings * 10, seeds);
}

TEST_F(KeptExports, TheProgramSeesWhatPassesAtRestHaveLeft) {
    const uint32_t seeds = extended() ? 1000 : 60;
    shaders = rest_shaders();
    for (uint32_t seed = 0; seed < seeds && !HasFailure(); ++seed) {
        const RandomRest made = random_rest(seed, RestShaders::fake, seed % 2 == 0);
        observed = made.observed;
        judge_text(made.text, seed, 10);
    }
    finish();
    EXPECT_GE(found_.by_units * 2, seeds);
    EXPECT_GE(found_.general * 10, seeds);
}

TEST_F(KeptExports, TheProgramSeesWhatGroupsAndSwitchesHaveLeft) {
    const uint32_t seeds = extended() ? 500 : 30;
    for (uint32_t seed = 0; seed < seeds && !HasFailure(); ++seed) {
        shaders = group_shaders();
        const RandomGroups made = random_groups(seed);
        observed = made.observed;
        judge_text(made.text, seed, 10);
        shaders = switch_shaders();
        observed.clear();
        judge_text(random_switches(seed).text, seed, 10);
    }
    finish();
    EXPECT_GE(found_.exports * 2, seeds);
}

}  // namespace
}  // namespace weft::test
