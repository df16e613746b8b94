#include "viewer/commands/swap_run.h"

#include <chrono>
#include <iterator>
#include <utility>

#include "viewer/options/graph_name.h"
#include "viewer/output/report.h"

namespace weft::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

}  // namespace

GraphRequest swap_request(GraphRequest running, const std::string& target) {
    const GraphName name = read_graph_name(target);
    if (!name.graph.ends_with(".json")) {
        running.tier = target;
        return running;
    }
    running.path = name.graph;
    running.tier = name.tier;
    return running;
}

Status SwapRun::before_frame(uint32_t frame, uint32_t frames) {
    if (targets_.size() < 2) return Unit{};
    if (frame > 0 && frame % every_ == 0)
        if (Status s = end(frame); !s) return s;
    const bool swaps_later = frame % every_ == 0 && frames - frame > every_;
    if (swaps_later) begin(targets_[next_++ % targets_.size()]);
    return Unit{};
}

void SwapRun::begin(const std::string& target) {
    records_.push_back({.to = target});
    render::Selection selection = session_.selection();
    selection.request = swap_request(selection.request, target);
    preparing_ = std::async(std::launch::async, [this, selection] {
        const Clock::time_point begin = Clock::now();
        render::PrepareResult made = session_.prepare(selection);
        return Prepared{std::move(made), ms_since(begin)};
    });
}

Status SwapRun::end(uint32_t frame) {
    const Clock::time_point begin = Clock::now();
    preparing_.wait();
    SwapRecord& record = records_.back();
    record.wait_ms = ms_since(begin);
    Prepared prepared = preparing_.get();
    record.frame = frame + 1;
    record.prepare_ms = prepared.ms;
    report(prepared.made.warnings);
    if (!prepared.made.result) {
        record.failed = true;
        Diagnostics found = prepared.made.result.take_errors();
        report(found);
        errors_.insert(errors_.end(), std::make_move_iterator(found.begin()),
                       std::make_move_iterator(found.end()));
        return Unit{};
    }
    record.rebuilt = render::to_text(prepared.made.result->rebuilt());
    const Result<bool> swapped = session_.swap_in(std::move(*prepared.made.result));
    record.swap_ms = ms_since(begin);
    return swapped ? Status(Unit{}) : Status(swapped.errors());
}

}  // namespace weft::viewer
