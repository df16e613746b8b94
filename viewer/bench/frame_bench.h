// Purpose: what `weft bench frame` measures: how long graphs take for a frame, over numbers of lights, next
// to yardsticks of the same run. Units: times in ms of the device, and as the names say.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "viewer/options/options.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::viewer {

// Of a number that was measured in each round.
struct Spread {
    double min = 0, quarter = 0, median = 0, three_quarters = 0, p99 = 0;
};
[[nodiscard]] Spread spread_of(std::vector<double> values);

// How fast the device is, and what a pass costs that does next to nothing: medians over all rounds.
struct Yardsticks {
    double trivial_ms = 0;
    double bytes_per_s = 0;
    double flops_per_s = 0;

    // What a pass of so many bytes and operations takes at least.
    [[nodiscard]] double limit_ms(double bytes, double flops) const;
};

struct PassResult {
    std::string name;
    uint32_t queue = 0;
    std::string key;         // passes of equal keys do the same in all graphs
    std::vector<double> ms;  // by round
    uint64_t bytes = 0;      // of its ports
    double flops = 0;        // declared; 0: not
    bool common = false;     // all graphs have it
};

// One graph with one number of lights.
struct GraphResult {
    std::string graph;
    uint32_t lights = 0;
    std::vector<PassResult> passes;  // in the order of the plan
    std::vector<double> trivial_ms;  // the trivial pass's, by round

    // By round; without the common passes: what the graphs differ in.
    [[nodiscard]] std::vector<double> frame_ms(bool with_common) const;
};

// Where one graph becomes faster than another, as their medians without the common passes say.
struct Crossing {
    std::string slower, faster;  // beyond the crossing
    double lights = 0;           // between two numbers that were measured, on logarithmic scales
    std::array<uint32_t, 2> between{};
};

struct FrameBench {
    std::string scene, device, driver;
    Extent3D size;
    uint32_t rounds = 0;
    std::vector<std::string> graphs;
    std::vector<uint32_t> lights;
    Yardsticks yardsticks;
    std::vector<GraphResult> results;  // by lights, then graphs

    [[nodiscard]] const GraphResult& at(size_t light, size_t graph) const {
        return results[light * graphs.size() + graph];
    }
    // The median over the rounds of the ratio to the first graph's, in the same round.
    [[nodiscard]] double ratio_to_first(size_t light, size_t graph, bool with_common) const;
    [[nodiscard]] double ratio_to_trivial(size_t light, size_t graph, bool with_common) const;
    [[nodiscard]] std::vector<Crossing> crossings() const;
};

[[nodiscard]] std::vector<PassResult> pass_results(const FramePlan& plan);
// Says which passes all graphs of the same number of lights have.
void find_common(FrameBench& bench);

[[nodiscard]] std::string bench_text(const FrameBench& bench);
[[nodiscard]] std::string bench_json(const FrameBench& bench);
// Both axes are logarithmic: a graph whose time grows as the lights do is a line of slope 1.
[[nodiscard]] std::string bench_svg(const FrameBench& bench);

}  // namespace weft::viewer
