// Purpose: the results of `weft bench frame`. The command measures the frame times of graphs for several
// numbers of lights, and reference times of trivial passes in the same run. Times on the device are in ms;
// other units are part of the names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "viewer/options/options.h"
#include "weft/plan.h"
#include "weft/result.h"
#include "weft/vulkan/frame_results.h"

namespace weft::viewer {

// Minimum, quartiles, median and 99th percentile of a value that was measured once per round. In one round,
// every graph renders one frame.
struct Spread {
    double min = 0, quarter = 0, median = 0, three_quarters = 0, p99 = 0;
};
[[nodiscard]] Spread spread_of(std::vector<double> values);

// Reference measurements of the device: the time of a nearly empty pass, the speed of copying and of
// arithmetic. Each value is the median over all rounds.
struct Yardsticks {
    double trivial_ms = 0;
    double bytes_per_s = 0;
    double flops_per_s = 0;

    // Returns a lower bound (ms) for the time of a pass that transfers `bytes` and does `flops` operations.
    [[nodiscard]] double limit_ms(double bytes, double flops) const;
};

struct PassResult {
    // For a pass of a group: the name without the number of the round, because the result is the sum over all
    // rounds.
    std::string name;
    bool in_group = false;
    uint32_t queue = 0;
    // Describes the work of the pass. Passes of different graphs with equal keys count as the same pass.
    std::string key;
    // Time of the pass on the device in each round; 0 if the pass rests (does not run).
    std::vector<double> ms;
    // For a pass that can rest (that does not run while its inputs stay the same): its time in each round in
    // a frame in which all passes run. Empty for all other passes.
    std::vector<double> awake_ms;
    uint64_t bytes = 0;  // Number of bytes that the pass reads and writes through its ports.
    // Number of floating-point operations that the graph file declares for the pass; 0 if the file declares
    // none.
    double flops = 0;
    bool common = false;  // True if all measured graphs have this pass.
    bool rests = false;   // True if the pass has `rest`, or is in a group.

    // Returns the times of the pass in the frames in which it runs.
    [[nodiscard]] const std::vector<double>& running_ms() const { return awake_ms.empty() ? ms : awake_ms; }
};

// The time of one pass of a group, measured in the frames that lit the light probes before the first frame.
struct RoundCost {
    std::string pass;
    uint64_t rounds = 0;  // Number of rounds that ran.
    double round_ms = 0;  // Mean time of one round.
};

// The measured times of one graph, rendered with one number of lights.
struct GraphResult {
    std::string graph;
    uint32_t lights = 0;
    std::vector<PassResult> passes;  // The passes in the order in which the plan runs them.
    std::vector<double> trivial_ms;  // Time of the trivial reference pass in each round.
    // Frame time of each round if all passes run, also those that can rest. Empty if no pass can rest.
    std::vector<double> awake_ms;
    std::vector<RoundCost> warm_up;  // Empty without light probes.

    // Returns the frame time of each round, as the sum of the times of the passes. If `with_common` is false,
    // the sum leaves out the passes that all graphs have.
    [[nodiscard]] std::vector<double> frame_ms(bool with_common) const;
};

// The number of lights at which one graph becomes faster than another one. The number is computed from the
// median times without the common passes.
struct Crossing {
    // Names of two graphs. With more lights than `lights`, the graph `slower` takes more time than the graph
    // `faster`.
    std::string slower, faster;
    // The number of lights at the crossing. It is interpolated on a logarithmic axis between the two measured
    // numbers of lights in `between`.
    double lights = 0;
    std::array<uint32_t, 2> between{};
};

struct FrameBench {
    std::string scene, device, driver;
    Extent3D size;
    uint32_t rounds = 0;
    std::vector<std::string> graphs;
    std::vector<uint32_t> lights;
    Yardsticks yardsticks;
    // Results of all graphs with the first number of lights, then with the second, and so on.
    std::vector<GraphResult> results;

    // In these functions, `light` is an index into `lights`, and `graph` is an index into `graphs`.
    [[nodiscard]] const GraphResult& at(size_t light, size_t graph) const {
        return results[light * graphs.size() + graph];
    }
    // Divides the frame time of the graph in each round by the frame time of the first graph in the same
    // round. Returns the median of these ratios.
    [[nodiscard]] double ratio_to_first(size_t light, size_t graph, bool with_common) const;
    // Like ratio_to_first(), but divides the frame time by the time of the trivial reference pass.
    [[nodiscard]] double ratio_to_trivial(size_t light, size_t graph, bool with_common) const;
    [[nodiscard]] std::vector<Crossing> crossings() const;
};

[[nodiscard]] std::vector<PassResult> pass_results(const FramePlan& plan);
// Appends the times of one frame to the results of its passes. Returns false if a pass has no time, because
// the device has no timestamps.
[[nodiscard]] bool add_round(const vk::FrameTiming& timing, std::vector<PassResult>& passes);
// Returns the costs of the rounds that ran in these frames. Returns nothing for passes without a time.
[[nodiscard]] std::vector<RoundCost> round_costs(const FramePlan& plan,
                                                 const std::vector<vk::FrameTiming>& timings);
// Sets `common` to true for each pass that all graphs have (with the same number of lights). If there is only
// one graph, `common` stays false.
void find_common(FrameBench& bench);

[[nodiscard]] std::string bench_text(const FrameBench& bench);
[[nodiscard]] std::string bench_json(const FrameBench& bench);
// Returns the plot as SVG. Both axes are logarithmic: if the time is proportional to the number of lights,
// the curve is a straight line.
[[nodiscard]] std::string bench_svg(const FrameBench& bench);

}  // namespace weft::viewer
