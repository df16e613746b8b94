#include <nlohmann/json.hpp>

#include "viewer/bench/frame_bench.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const std::vector<double>& values) {
    const Spread s = spread_of(values);
    return {{"min", s.min},
            {"quarter", s.quarter},
            {"median", s.median},
            {"three_quarters", s.three_quarters},
            {"p99", s.p99}};
}

// Null if no pass rests.
Json awake_json(const std::vector<double>& ms) {
    return ms.empty() ? Json(nullptr) : spread_json(ms);
}

Json pass_json(const FrameBench& bench, const PassResult& pass) {
    const double limit_ms = bench.yardsticks.limit_ms(static_cast<double>(pass.bytes), pass.flops);
    const double median_ms = spread_of(pass.running_ms()).median;
    return {{"name", pass.name},
            {"queue", pass.queue},
            {"gpu_ms", spread_json(pass.ms)},
            {"awake_ms", awake_json(pass.awake_ms)},
            {"bytes", pass.bytes},
            {"flops", pass.flops > 0 ? Json(pass.flops) : Json(nullptr)},
            {"limit_ms", limit_ms},
            {"over_limit", median_ms / limit_ms},
            {"over_trivial", median_ms / bench.yardsticks.trivial_ms},
            {"common", pass.common}};
}

Json result_json(const FrameBench& bench, size_t light, size_t graph) {
    const GraphResult& result = bench.at(light, graph);
    Json passes = Json::array();
    for (const PassResult& pass : result.passes) passes.push_back(pass_json(bench, pass));
    Json json{{"graph", result.graph}, {"lights", result.lights}};
    for (const bool with_common : {true, false})
        json[with_common ? "frame" : "not_common"] = {
            {"gpu_ms", spread_json(result.frame_ms(with_common))},
            {"over_first", bench.ratio_to_first(light, graph, with_common)},
            {"over_trivial", bench.ratio_to_trivial(light, graph, with_common)}};
    json["awake_ms"] = awake_json(result.awake_ms);
    json["passes"] = std::move(passes);
    Json warm_up = Json::array();
    for (const RoundCost& cost : result.warm_up)
        warm_up.push_back({{"pass", cost.pass},
                           {"rounds", cost.rounds},
                           {"round_ms", cost.round_ms},
                           {"over_trivial", cost.round_ms / bench.yardsticks.trivial_ms}});
    json["warm_up"] = std::move(warm_up);
    return json;
}

}  // namespace

std::string bench_json(const FrameBench& bench) {
    Json results = Json::array(), crossings = Json::array();
    for (size_t light = 0; light < bench.lights.size(); ++light)
        for (size_t graph = 0; graph < bench.graphs.size(); ++graph)
            results.push_back(result_json(bench, light, graph));
    for (const Crossing& c : bench.crossings())
        crossings.push_back(
            {{"faster", c.faster}, {"slower", c.slower}, {"from_lights", c.lights}, {"between", c.between}});
    const Json json{{"scene", bench.scene},
                    {"size", {bench.size.width, bench.size.height}},
                    {"device", bench.device},
                    {"driver", bench.driver},
                    {"rounds", bench.rounds},
                    {"graphs", bench.graphs},
                    {"lights", bench.lights},
                    {"trivial_ms", bench.yardsticks.trivial_ms},
                    {"bytes_per_s", bench.yardsticks.bytes_per_s},
                    {"flops_per_s", bench.yardsticks.flops_per_s},
                    {"crossings", crossings},
                    {"results", results}};
    return json.dump(1) + "\n";
}

}  // namespace weft::viewer
