#include "viewer/commands/swap_run.h"

#include <chrono>
#include <iterator>
#include <string_view>
#include <utility>

#include "viewer/output/report.h"

namespace weft::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

constexpr std::string_view kGraphFile = ".json";

}  // namespace

GraphRequest swap_request(GraphRequest running, const std::string& target) {
    const size_t file = target.find(kGraphFile);
    if (file == std::string::npos) {
        running.tier = target;
        return running;
    }
    running.path = target.substr(0, file + kGraphFile.size());
    const size_t colon = target.find(':', file);
    running.tier = colon == std::string::npos ? "" : target.substr(colon + 1);
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
