// Tests which graphs with `perFrame` passes are accepted. Such passes are divided into frame slices, and each
// slice runs only in some frames. resolve() and the checker are compared with a brute-force search over every
// set of slices that may run in a frame. A graph is wrong if a pass can read another version of an image
// layer than the one that its reference names. Exception: if all writers of a layer modify it in place, a
// read of the layer is never wrong. Then a reference means the content that the layer has when the pass runs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <random>

#include "null/null_executor.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

struct SliceGraph {
    // Text of the graph with `perFrame`.
    std::string text;
    // Text of the same graph without `perFrame`.
    std::string steady;
    // For each pass with `perFrame`, by name: the value of `perFrame`, which is the largest number of
    // iterations per frame.
    std::map<std::string, uint32_t> at_once;
    // For each pass with `perFrame`, by name: the number of iterations of its repeat.
    std::map<std::string, uint32_t> rounds;
};

// Makes random graphs in which chains of passes read and write the layers of two kept images.
class SliceGenerator {
 public:
    explicit SliceGenerator(uint32_t seed) : random_(seed) {}

    SliceGraph run() {
        const uint32_t passes = 2 + below(4);
        for (uint32_t p = 0; p < passes; ++p) add(p);
        passes_.push_back(R"j("see0": {"type": "readback", "in": ["k0"]})j");
        passes_.push_back(R"j("see1": {"type": "readback", "in": ["k1"]})j");
        const std::string head = R"j("resources": {
          "k0": {"format": "rgba16f", "layers": 2, "keep": true}, "k1": {"format": "rgba16f", "layers": 2, "keep": true}},
          "passes": {)j";
        graph_.text = head + joined_passes(true) + "}";
        graph_.steady = head + joined_passes(false) + "}";
        return std::move(graph_);
    }

 private:
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    std::string some_layers() {
        constexpr const char* kLayers[] = {"", ".layer(0)", ".layer(1)", ".layer(i % 2)", ".layer(i % 2)"};
        return kLayers[below(5)];
    }

    void add(uint32_t p) {
        const std::string name = "p" + std::to_string(p);
        const uint32_t rounds = 1 + below(3);
        std::string text = "\"" + name + "\": {\"type\": \"compute\", \"shader\": \"";
        const std::string target = "k" + std::to_string(below(2)), layer = some_layers();
        const bool arrayed = layer.empty();
        const uint32_t kind = below(4);
        std::string in;
        if (kind == 1) {
            const std::string from = "k" + std::to_string(below(2)), part = some_layers();
            const std::string pin = p > 0 && below(3) > 0 ? "@p" + std::to_string(below(p + 1)) : "";
            in = "\"a\": \"" + from + pin + part + "\"";
            text += part.empty() ? "read_all.comp" : "read.comp";
        } else {
            text += kind == 2 ? "change.comp" : "make.comp";
        }
        // The suffix "+" selects the variant of the shader that writes image arrays.
        text += arrayed ? "+" : "";
        text += "\", \"threads\": 8, \"repeat\": {\"i\": \"0.." + std::to_string(rounds - 1) + "\"}";
        if (!in.empty()) text += ", \"in\": {" + in + "}";
        text += ", \"out\": {\"dst\": \"" + target + layer + "\"}";
        if (kind == 3) text += ", \"partial\": true";
        if (p > 0 && below(5) > 0) text += ", \"after\": [\"p" + std::to_string(p - 1) + "\"]";
        if (below(4) > 0) {
            graph_.at_once[name] = 1 + below(2);
            graph_.rounds[name] = rounds;
        }
        passes_.push_back(std::move(text));
        names_.push_back(name);
    }

    std::string joined_passes(bool slices) {
        std::string all;
        for (size_t i = 0; i < passes_.size(); ++i) {
            all += (i == 0 ? "" : ",\n") + passes_[i];
            if (i >= names_.size()) continue;
            const auto found = graph_.at_once.find(names_[i]);
            if (slices && found != graph_.at_once.end())
                all += ", \"perFrame\": " + std::to_string(found->second);
            all += "}";
        }
        return all;
    }

    std::mt19937 random_;
    SliceGraph graph_;
    std::vector<std::string> passes_, names_;
};

void set_slices(const SliceGraph& made, ResolvedGraph& graph) {
    for (PassDecl& pass : graph.passes) {
        const size_t mark = pass.name.find('#');
        const auto found = made.at_once.find(pass.name.substr(0, mark));
        if (found == made.at_once.end()) continue;
        const uint32_t rounds = made.rounds.at(found->first);
        pass.frame_slices = (rounds + found->second - 1) / found->second;
        pass.frame_slice = static_cast<uint32_t>(std::stoul(pass.name.substr(mark + 1))) / found->second;
    }
}

// Simulates three frames and searches for a pass that reads a wrong version. Frame 0 runs all frame slices.
// For frames 1 and 2, the search tries every subset of the slices.
class BruteForce {
 public:
    explicit BruteForce(const ResolvedGraph& graph) : graph_(graph) {
        sort();
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> numbers;
        for (const PassDecl& pass : graph.passes) {
            const bool always = pass.frame_slices <= 1;
            const auto key = std::pair(pass.frame_slices, pass.frame_slice);
            slice_of_.push_back(
                always ? kNoId : numbers.emplace(key, static_cast<uint32_t>(numbers.size())).first->second);
        }
        slices_ = static_cast<uint32_t>(numbers.size());
        find_changing_cells();
    }

    uint32_t slices() const { return slices_; }

    bool is_wrong() {
        for (uint32_t one = 0; one < 1u << slices_; ++one)
            for (uint32_t two = 0; two < 1u << slices_; ++two)
                if (is_wrong({~0u, one, two})) return true;
        return false;
    }

 private:
    // Last writer of each layer, by resource and layer.
    using Memory = std::map<std::pair<ResourceId, uint32_t>, PassId>;

    void sort() {
        std::vector<uint32_t> waits(graph_.passes.size(), 0);
        for (const EdgeDecl& edge : graph_.edges) ++waits[edge.to];
        for (size_t done = 0; done < graph_.passes.size(); ++done)
            for (PassId pass(0); pass < graph_.passes.size(); ++pass) {
                if (waits[pass] != 0) continue;
                waits[pass] = kNoId;
                order_.push_back(pass);
                for (const EdgeDecl& edge : graph_.edges)
                    if (edge.from == pass) --waits[edge.to];
                break;
            }
    }

    static const VersionSource* source_of(const UseDecl& use, uint32_t layer) {
        for (const VersionSource& source : use.sources)
            if (source.range.layer <= layer && layer < source.range.layer + source.range.layers)
                return &source;
        return nullptr;
    }

    template <class Visit>
    void for_each_layer(PassId pass, Visit visit) const {
        for (const UseDecl& use : graph_.passes[pass].uses)
            for (uint32_t l = use.range.layer; l < use.range.layer + use.range.layers; ++l) visit(use, l);
    }

    void find_changing_cells() {
        for (PassId pass(0); pass < graph_.passes.size(); ++pass)
            for_each_layer(pass, [&](const UseDecl& use, uint32_t layer) {
                if (writes(use.access) && !source_of(use, layer)) overwritten_[{use.resource, layer}] = true;
            });
    }

    bool is_wrong(std::array<uint32_t, 3> runs) {
        Memory memory, first;
        for (size_t frame = 0; frame < runs.size(); ++frame) {
            for (const PassId pass : order_) {
                if (slice_of_[pass] != kNoId && !(runs[frame] >> slice_of_[pass] & 1)) continue;
                bool wrong = false;
                for_each_layer(pass, [&](const UseDecl& use, uint32_t layer) {
                    const VersionSource* source = source_of(use, layer);
                    if (!source || !overwritten_.contains({use.resource, layer})) return;
                    const std::pair cell(use.resource, layer);
                    if (source->producer != kNoId)
                        wrong |= !memory.contains(cell) || memory.at(cell) != source->producer;
                    // Without a producer, the reference names the content from before the frame. All passes
                    // run in frame 0, so in later frames the last writer must be the same as after frame 0.
                    else if (frame > 0)
                        wrong |= memory[cell] != first[cell];
                });
                if (wrong) return true;
                for_each_layer(pass, [&](const UseDecl& use, uint32_t layer) {
                    if (writes(use.access)) memory[{use.resource, layer}] = pass;
                });
            }
            if (frame == 0) first = memory;
        }
        return false;
    }

    const ResolvedGraph& graph_;
    std::vector<PassId> order_;
    std::vector<uint32_t> slice_of_;
    uint32_t slices_ = 0;
    std::map<std::pair<ResourceId, uint32_t>, bool> overwritten_;
};

class FrameSliceRule : public ResolveTest {
 protected:
    FrameSliceRule() {
        const auto both = [&](const char* name, const ShaderProgram& program) {
            shaders[name] = program;
            ShaderProgram arrays = program;
            for (ShaderBinding& binding : arrays.interface.bindings)
                if (binding.writes) binding.arrayed = true;
            shaders[std::string(name) + "+"] = arrays;
        };
        ShaderBinding all = sampled("a");
        all.arrayed = true;
        both("make.comp", compute({image_out("dst")}));
        both("change.comp", compute({image_in_out("dst")}));
        both("read.comp", compute({sampled("a"), image_out("dst")}));
        both("read_all.comp", compute({all, image_out("dst")}));
    }
};

TEST_F(FrameSliceRule, RefusesWhatBruteForceFindsWrongAndNothingElse) {
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 60000 : 4000;
    uint32_t sound = 0, wrong = 0, slices = 0;
    for (uint32_t seed = 0; seed < seeds; ++seed) {
        const SliceGraph made = SliceGenerator(seed).run();
        Result<ResolvedGraph> steady = run(made.steady);
        // Skip a random graph that resolve() rejects, because it has a cycle or unordered writers.
        if (!steady) continue;
        ResolvedGraph graph = std::move(*steady);
        set_slices(made, graph);
        BruteForce brute(graph);
        if (brute.slices() == 0 || brute.slices() > 5) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + made.text);
        const bool is_wrong = brute.is_wrong();
        ++(is_wrong ? wrong : sound);
        slices += brute.slices();

        const Result<ResolvedGraph> judged = run(made.text);
        ASSERT_EQ(judged.ok(), !is_wrong) << (judged ? "accepted" : to_text(judged.errors()));
        for (const Diagnostic& d : judged ? Diagnostics{} : judged.errors())
            ASSERT_EQ(d.code, "W124") << to_text(d);

        // The checker must reach the same result. It judges a plan that keeps all passes, so that culling
        // hides no fault.
        CompileOptions options;
        options.keep_all_passes = true;
        const Diagnostics faults = check_plan(compile(graph, content_needs(graph), options));
        ASSERT_EQ(faults.empty(), !is_wrong) << to_text(faults);
    }
    std::cout << "seeds 0.." << seeds - 1 << ": " << sound << " sound, " << wrong << " wrong, " << slices
              << " slices\n";
    EXPECT_GE(sound * 15, seeds);
    EXPECT_GE(wrong * 15, seeds);
}

// Culling must not change results: the null executor runs the plan, which may leave out passes. The content
// must be the same as in the reference run, which keeps all passes.
TEST_F(FrameSliceRule, WhatIsAcceptedGivesWhatTheWholeGraphMeans) {
    uint32_t compared = 0, culled = 0;
    for (uint32_t seed = 0; seed < 1000; ++seed) {
        const SliceGraph made = SliceGenerator(seed).run();
        const Result<ResolvedGraph> judged = run(made.text);
        if (!judged) continue;
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + made.text);
        CompileOptions options;
        options.queues = logical_queues({}, 1 + seed % 3);
        const FramePlan plan = compile(*judged, content_needs(*judged), options);
        const Diagnostics faults = check_plan(plan);
        ASSERT_TRUE(faults.empty()) << to_text(faults);
        LiveGraph all = plan.live;
        all.live_passes.assign(all.live_passes.size(), 1);
        all.live_resources.assign(all.live_resources.size(), 1);
        const std::vector<std::string> different = differences(
            plan.graph, run_reference(plan.graph, all, 7), run_null(plan, {7, seed, NullOrder::shuffled}));
        ASSERT_TRUE(different.empty()) << different.front();
        ++compared;
        culled += plan.schedule.order.size() < plan.graph.passes.size() ? 1 : 0;
    }
    std::cout << "seeds 0..999: " << compared << " compared, " << culled << " with culled passes\n";
    EXPECT_GE(compared, 200u);
    EXPECT_GE(culled, 30u);
}

// A repeat of four iterations, one per frame, writes the kept image `scratch`, and a second repeat stores
// each result. Culling removes three of the four writers, so the checker must reject the plan.
TEST_F(FrameSliceRule, TheCheckerDoesNotProveAChainThatCullingBroke) {
    const char* graph_text = R"j("resources": {
        "scratch": {"format": "rgba16f", "keep": true}, "stored": {"format": "rgba16f", "layers": 4, "keep": true}},
      "passes": {
        "bake": {"type": "compute", "shader": "make.comp", "repeat": {"m": "0..3"}, "out": {"dst": "scratch"}},
        "store": {"type": "compute", "shader": "read.comp", "repeat": {"m": "0..3"}, "in": {"a": "scratch"},
                  "out": {"dst": "stored.layer(m)"}},
        "see": {"type": "readback", "in": ["stored"]}})j";
    ResolvedGraph graph = good(graph_text);
    for (PassDecl& pass : graph.passes) {
        if (pass.kind != PassKind::compute) continue;
        pass.frame_slices = 4;
        pass.frame_slice = static_cast<uint32_t>(pass.name.back() - '0');
    }
    const FramePlan plan = compile(graph, content_needs(graph), {});
    EXPECT_EQ(plan.schedule.order.size(), 6u) << "three rounds of the bake are culled";
    const Diagnostics faults = check_plan(plan);
    ASSERT_FALSE(faults.empty());
    EXPECT_EQ(faults.front().code, "C332") << to_text(faults);
}

}  // namespace
}  // namespace weft::test
