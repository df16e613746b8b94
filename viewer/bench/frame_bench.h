// Purpose: the measurement of `weft bench frame`: frame times of graphs for several numbers of lights,
// together with reference measurements of the same run. Units: device times in ms; others as the names say.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "viewer/options/options.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::viewer {

// Statistics of a number that was measured in each round.
struct Spread {
    double min = 0, quarter = 0, median = 0, three_quarters = 0, p99 = 0;
};
[[nodiscard]] Spread spread_of(std::vector<double> values);

// Reference measurements: the speed of the device and the cost of a nearly empty pass; medians over all
// rounds.
struct Yardsticks {
    double trivial_ms = 0;
    double bytes_per_s = 0;
    double flops_per_s = 0;

    // Lower bound for the time of a pass with this many bytes and operations.
    [[nodiscard]] double limit_ms(double bytes, double flops) const;
};

struct PassResult {
    std::string name;
    uint32_t queue = 0;
    std::string key;         // passes with equal keys do the same work in all graphs
    std::vector<double> ms;  // index: round
    uint64_t bytes = 0;      // bytes of its ports
    double flops = 0;        // as declared; 0: not declared
    bool common = false;     // true if all graphs have this pass
};

// One graph with one number of lights.
struct GraphResult {
    std::string graph;
    uint32_t lights = 0;
    std::vector<PassResult> passes;  // in the order of the plan
    std::vector<double> trivial_ms;  // time of the trivial pass, by round

    // By round. Without the common passes, only the passes in which the graphs differ are counted.
    [[nodiscard]] std::vector<double> frame_ms(bool with_common) const;
};

// The number of lights at which one graph becomes faster than another, computed from the medians without
// common passes.
struct Crossing {
    std::string slower, faster;  // which graph is slower or faster above `lights`
    double lights = 0;           // interpolated between two measured numbers, on logarithmic scales
    std::array<uint32_t, 2> between{};
};

struct FrameBench {
    std::string scene, device, driver;
    Extent3D size;
    uint32_t rounds = 0;
    std::vector<std::string> graphs;
    std::vector<uint32_t> lights;
    Yardsticks yardsticks;
    std::vector<GraphResult> results;  // ordered by lights, then graphs

    [[nodiscard]] const GraphResult& at(size_t light, size_t graph) const {
        return results[light * graphs.size() + graph];
    }
    // The median over the rounds of this graph's time divided by the first graph's time in the same round.
    [[nodiscard]] double ratio_to_first(size_t light, size_t graph, bool with_common) const;
    [[nodiscard]] double ratio_to_trivial(size_t light, size_t graph, bool with_common) const;
    [[nodiscard]] std::vector<Crossing> crossings() const;
};

[[nodiscard]] std::vector<PassResult> pass_results(const FramePlan& plan);
// Sets `common` for the passes that all graphs with the same number of lights have.
void find_common(FrameBench& bench);

[[nodiscard]] std::string bench_text(const FrameBench& bench);
[[nodiscard]] std::string bench_json(const FrameBench& bench);
// Both axes are logarithmic: a time proportional to the number of lights is a line of slope 1.
[[nodiscard]] std::string bench_svg(const FrameBench& bench);

}  // namespace weft::viewer
