#include "viewer/bench/frame_bench.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "viewer/output/group_times.h"
#include "viewer/output/port_bytes.h"

namespace weft::viewer {
namespace {

// Returns the properties of a pass as one text: name, type, shader, ports and resources. Two passes of
// different graphs count as the same pass if their texts are equal.
std::string key_of(const ResolvedGraph& graph, const PassDecl& pass) {
    std::string key = pass.name + " " + pass.type + " " + pass.shader;
    for (const UseDecl& use : pass.uses) key += " " + use.port + "=" + graph.resources[use.resource].name;
    return key;
}

double median_of(std::vector<double> values) {
    return spread_of(std::move(values)).median;
}

double median_ratio(const std::vector<double>& above, const std::vector<double>& below) {
    std::vector<double> ratios;
    for (size_t i = 0; i < std::min(above.size(), below.size()); ++i) ratios.push_back(above[i] / below[i]);
    return median_of(std::move(ratios));
}

// Returns the number of lights at which the difference of two frame times is zero. The function draws a
// straight line through the differences `before` (measured at `from` lights) and `after` (measured at `to`
// lights). The axis of the lights is logarithmic, as in the plot.
double crossing_at(double from, double to, double before, double after) {
    const double part = before / (before - after);
    return std::exp(std::log(from) + part * (std::log(to) - std::log(from)));
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const auto quantile = [&](double q) {
        const double place = q * static_cast<double>(values.size() - 1);
        const auto below = static_cast<size_t>(place);
        const size_t above = std::min(below + 1, values.size() - 1);
        return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
    };
    return {values.front(), quantile(0.25), quantile(0.5), quantile(0.75), quantile(0.99)};
}

double Yardsticks::limit_ms(double bytes, double flops) const {
    constexpr double kDispatchMs = 0.003;  // Assumed minimum time of a pass (ms), even if it does nothing.
    return std::max({bytes / bytes_per_s * 1e3, flops / flops_per_s * 1e3, kDispatchMs});
}

std::vector<double> GraphResult::frame_ms(bool with_common) const {
    std::vector<double> sums(trivial_ms.size(), 0.0);
    for (const PassResult& pass : passes)
        for (size_t round = 0; round < pass.ms.size() && (with_common || !pass.common); ++round)
            sums[round] += pass.ms[round];
    return sums;
}

double FrameBench::ratio_to_first(size_t light, size_t graph, bool with_common) const {
    return median_ratio(at(light, graph).frame_ms(with_common), at(light, 0).frame_ms(with_common));
}

double FrameBench::ratio_to_trivial(size_t light, size_t graph, bool with_common) const {
    return median_ratio(at(light, graph).frame_ms(with_common), at(light, graph).trivial_ms);
}

std::vector<Crossing> FrameBench::crossings() const {
    std::vector<Crossing> found;
    for (size_t a = 0; a < graphs.size(); ++a)
        for (size_t b = a + 1; b < graphs.size(); ++b)
            for (size_t i = 0; i + 1 < lights.size(); ++i) {
                const auto difference = [&](size_t light) {
                    return median_of(at(light, a).frame_ms(false)) - median_of(at(light, b).frame_ms(false));
                };
                const double before = difference(i), after = difference(i + 1);
                if ((before > 0) == (after > 0)) continue;
                const double where = crossing_at(lights[i], lights[i + 1], before, after);
                found.push_back({graphs[after > 0 ? a : b],
                                 graphs[after > 0 ? b : a],
                                 where,
                                 {lights[i], lights[i + 1]}});
            }
    return found;
}

std::vector<PassResult> pass_results(const FramePlan& plan) {
    std::vector<PassResult> passes;
    for (Position position(0); position < plan.schedule.order.size(); ++position) {
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[position]];
        const bool in_group = std::ranges::any_of(
            plan.graph.groups, [&](const GroupDecl& group) { return group.has_unit(pass.rest_unit); });
        const std::string name = in_group ? name_without_round(pass.name) : pass.name;
        if (in_group && std::ranges::find(passes, name, &PassResult::name) != passes.end()) continue;
        PassResult& result = passes.emplace_back();
        result.name = name;
        result.in_group = in_group;
        result.queue = plan.schedule.queue[position];
        result.key = key_of(plan.graph, pass);
        result.bytes = port_bytes(plan.graph, pass);
        result.flops = pass.flops;
        result.rests = pass.rest_unit != kNoId;
    }
    return passes;
}

bool add_round(const vk::FrameTiming& timing, std::vector<PassResult>& passes) {
    std::map<std::string, double, std::less<>> times, of_groups;
    for (const vk::PassTiming& pass : timing.passes) {
        if (pass.gpu_ms < 0) return false;
        times.emplace(pass.pass, pass.rested ? 0 : pass.gpu_ms);
        if (!pass.rested) of_groups[name_without_round(pass.pass)] += pass.gpu_ms;
    }
    for (PassResult& pass : passes) {
        const auto timed = times.find(pass.name);
        if (!pass.in_group && timed == times.end()) return false;
        pass.ms.push_back(pass.in_group ? of_groups[pass.name] : timed->second);
    }
    return true;
}

std::vector<RoundCost> round_costs(const FramePlan& plan, const std::vector<vk::FrameTiming>& timings) {
    std::vector<RoundCost> costs;
    for (const GroupTimes& group : group_times(plan, timings))
        for (const auto& [pass, ms] : group.pass_ms) {
            const uint64_t rounds = group.all_ran();
            if (ms >= 0 && rounds > 0) costs.push_back({pass, rounds, ms / static_cast<double>(rounds)});
        }
    return costs;
}

void find_common(FrameBench& bench) {
    const size_t graphs = bench.graphs.size();
    for (size_t light = 0; graphs > 1 && light < bench.lights.size(); ++light) {
        std::multiset<std::string> keys;
        for (size_t graph = 0; graph < graphs; ++graph)
            for (const PassResult& pass : bench.at(light, graph).passes) keys.insert(pass.key);
        for (size_t graph = 0; graph < graphs; ++graph)
            for (PassResult& pass : bench.results[light * graphs + graph].passes)
                pass.common = keys.count(pass.key) == graphs;
    }
}

}  // namespace weft::viewer
