#include "viewer/output/stats.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "check/needed_barriers.h"
#include "viewer/output/group_times.h"
#include "viewer/output/port_bytes.h"
#include "weft/compile.h"

namespace weft::viewer {
namespace {

using Json = nlohmann::ordered_json;

// Ignores negative values: these times were not measured. Returns null if no value remains.
Json distribution(std::vector<double> values) {
    std::erase_if(values, [](double v) { return v < 0; });
    if (values.empty()) return nullptr;
    std::sort(values.begin(), values.end());
    const auto quantile = [&](double q) {
        return values[std::min(values.size() - 1,
                               static_cast<size_t>(q * static_cast<double>(values.size())))];
    };
    return {{"min", values.front()}, {"median", quantile(0.5)}, {"p99", quantile(0.99)}};
}

// Adds the numbers of draws that a pass left out in one frame. `all` gets the number of the whole pass, and
// `views` gets the number of each view.
void add_draws_left_out(const vk::PassTiming& timing, std::vector<double>& all,
                        std::vector<std::vector<double>>& views) {
    all.push_back(timing.draws_left_out);
    views.resize(timing.view_draws_left_out.size());
    for (size_t view = 0; view < views.size(); ++view)
        views[view].push_back(timing.view_draws_left_out[view]);
}

Json passes_json(const StatsInput& input) {
    Json passes = Json::array();
    const ResolvedGraph& graph = input.plan.graph;
    for (Position p(0); p < input.plan.schedule.order.size(); ++p) {
        const PassDecl& pass = graph.passes[input.plan.schedule.order[p]];
        std::vector<double> times;
        std::vector<double> left_out;
        std::vector<std::vector<double>> view_left_out;
        uint32_t rested = 0, switched_off = 0;
        Json woken = Json::object();
        for (const vk::FrameTiming& frame : input.timings) {
            // The times of a frame are in the order of the plan, so `p` is an index into them.
            if (p >= frame.passes.size()) continue;
            const vk::PassTiming& timing = frame.passes[p];
            switched_off += timing.switched_off ? 1 : 0;
            if (timing.switched_off) continue;
            if (!timing.rested) times.push_back(timing.gpu_ms);
            if (!timing.rested) add_draws_left_out(timing, left_out, view_left_out);
            rested += timing.rested ? 1 : 0;
            if (!timing.woken_by.empty()) woken[timing.woken_by] = woken.value(timing.woken_by, 0u) + 1;
        }
        passes.push_back({{"name", pass.name},
                          {"queue", uint32_t{input.plan.schedule.queue[p]}},
                          {"gpu_ms", distribution(std::move(times))},
                          {"bytes", port_bytes(graph, pass)},
                          {"flops", pass.flops > 0 ? Json(pass.flops) : Json(nullptr)}});
        if (pass.culls_draws) passes.back()["draws_left_out"] = distribution(std::move(left_out));
        for (size_t view = 0; pass.culls_draws && view < view_left_out.size(); ++view)
            passes.back()["views"].push_back(
                {{"name", pass.views[view]},
                 {"draws_left_out", distribution(std::move(view_left_out[view]))}});
        if (pass.switch_id != kNoId) passes.back()["switched_off_frames"] = switched_off;
        if (pass.rest_unit == kNoId) continue;
        passes.back()["rested_frames"] = rested;
        passes.back()["woken_by"] = std::move(woken);
    }
    return passes;
}

Json groups_json(const StatsInput& input) {
    Json groups = Json::array();
    for (GroupTimes& group : group_times(input.plan, input.timings))
        groups.push_back({{"name", group.name},
                          {"rounds", group.rounds},
                          {"rounds_run", distribution({group.ran.begin(), group.ran.end()})},
                          {"gpu_ms", distribution(std::move(group.gpu_ms))}});
    return groups;
}

// Returns the number of probes and the cost of lighting them before the first frame; null without probes.
Json probes_json(const StatsInput& input) {
    if (input.probes == 0) return nullptr;
    Json groups = Json::array();
    for (const GroupTimes& group : group_times(input.plan, input.warm_up)) {
        const double ms = group.all_gpu_ms();
        groups.push_back({{"name", group.name},
                          {"rounds_run", group.all_ran()},
                          {"gpu_ms", ms < 0 ? Json(nullptr) : Json(ms)}});
    }
    double frame_ms = 0;
    for (const vk::FrameTiming& t : input.warm_up) frame_ms += t.record_ms + t.submit_ms + t.wait_ms;
    return {
        {"irradiance", input.probes},
        {"warm_up", {{"frames", input.warm_up.size()}, {"cpu_ms", frame_ms}, {"groups", std::move(groups)}}}};
}

Json cpu_json(const std::vector<vk::FrameTiming>& timings) {
    std::vector<double> record, submit, frame;
    for (const vk::FrameTiming& t : timings) {
        record.push_back(t.record_ms);
        submit.push_back(t.submit_ms);
        frame.push_back(t.record_ms + t.submit_ms + t.wait_ms);
    }
    return {
        {"record", distribution(record)}, {"submit", distribution(submit)}, {"frame", distribution(frame)}};
}

// Returns how many entries of the lists of --turns (rounds of groups to run) were ignored, summed over all
// frames.
uint64_t dropped_turns(const std::vector<vk::FrameTiming>& timings) {
    uint64_t dropped = 0;
    for (const vk::FrameTiming& frame : timings) dropped += frame.dropped_turns;
    return dropped;
}

Json swaps_json(const std::vector<SwapRecord>& swaps) {
    Json list = Json::array();
    for (const SwapRecord& swap : swaps)
        list.push_back({{"to", swap.to},
                        {"frame", swap.frame},
                        {"prepare_ms", swap.prepare_ms},
                        {"swap_ms", swap.swap_ms},
                        {"wait_ms", swap.wait_ms},
                        {"rebuilt", swap.rebuilt},
                        {"failed", swap.failed}});
    return list;
}

Json validation_json(vk::Device& device) {
    Json validation{{"messages", device.messages().count()}, {"layers", Json::array()}};
    for (const vk::LayerInfo& layer : device.info().layers)
        validation["layers"].push_back({{"name", layer.name}, {"version", layer.version}});
    return validation;
}

const ResourceDecl* resource_behind(const FramePlan& plan, const std::string& reference) {
    const ResourceId id = find_resource(plan.graph, reference.substr(0, reference.find_first_of("@[.")));
    return id == kNoId ? nullptr : &plan.graph.resources[id];
}

}  // namespace

std::string stats_json(const StatsInput& input) {
    const FramePlan& plan = input.plan;
    const std::optional<uint32_t> needed = count_needed_barriers(plan);
    Json stats{
        {"graph", plan.graph.name},
        {"tier", input.tier.empty() ? Json(nullptr) : Json(input.tier)},
        {"device", input.device.info().name},
        {"driver", input.device.info().driver},
        {"size", {plan.graph.output_extent.width, plan.graph.output_extent.height}},
        {"frames", input.frames},
        {"plan_hash", plan_hash(plan)},
        {"output_sha256", sha256(input.output.bytes)},
        {"validation", validation_json(input.device)},
        {"passes", passes_json(input)},
        {"groups", groups_json(input)},
        {"probes", probes_json(input)},
        {"cpu_ms", cpu_json(input.timings)},
        {"memory",
         {{"sum_bytes", plan.memory.sum_bytes},
          {"peak_live_bytes", plan.memory.peak_live_bytes},
          {"heap_bytes", plan.memory.heap_bytes}}},
        {"barriers",
         {{"emitted", plan.barriers.emitted}, {"needed", needed ? Json(*needed) : Json(nullptr)}}},
        {"submissions", plan.submissions.batches.size()},
        {"dropped_turns", dropped_turns(input.timings)},
        {"pipelines_built_on_frame_thread", input.pipelines_built_on_frame_thread},
    };
    if (!input.swaps.empty()) stats["swaps"] = swaps_json(input.swaps);
    return stats.dump(2) + "\n";
}

bool is_pre_exposed(const FramePlan& plan, const std::string& reference) {
    const ResourceDecl* resource = resource_behind(plan, reference);
    return resource && resource->pre_exposed;
}

bool is_buffer(const FramePlan& plan, const std::string& reference) {
    const ResourceDecl* resource = resource_behind(plan, reference);
    return resource && resource->kind == ResourceKind::buffer;
}

std::string sha256(const std::vector<std::byte>& bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
    std::string text;
    for (unsigned int i = 0; i < length; ++i) {
        constexpr const char* kHex = "0123456789abcdef";
        text += kHex[digest[i] >> 4];
        text += kHex[digest[i] & 15];
    }
    return text;
}

}  // namespace weft::viewer
