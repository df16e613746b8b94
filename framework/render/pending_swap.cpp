#include "weft/render/pending_swap.h"

#include <utility>

#include "render/swap_parts.h"

namespace weft::render {
namespace {

std::string count_part(uint32_t some, uint32_t all, const char* what) {
    return std::to_string(some) + " of " + std::to_string(all) + " " + what + (all == 1 ? "" : "s");
}

}  // namespace

std::string to_text(const Rebuilt& rebuilt) {
    if (rebuilt.nothing()) return "nothing changed";
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (rebuilt.changed_shaders > 0) add(count_part(rebuilt.changed_shaders, rebuilt.shaders, "shader"));
    if (rebuilt.made_pipelines > 0) add(count_part(rebuilt.made_pipelines, rebuilt.pipelines, "pipeline"));
    if (rebuilt.plan) add("a new plan");
    if (rebuilt.values) add("new values");
    return text;
}

PendingSwap::PendingSwap(std::unique_ptr<SwapParts> parts) : parts_(std::move(parts)) {}
PendingSwap::~PendingSwap() = default;
PendingSwap::PendingSwap(PendingSwap&& other) noexcept = default;
PendingSwap& PendingSwap::operator=(PendingSwap&& other) noexcept = default;

const Rebuilt& PendingSwap::rebuilt() const {
    return parts_->rebuilt;
}

const FramePlan* PendingSwap::new_plan() const {
    return parts_->stage ? &parts_->stage->executor->plan() : nullptr;
}

}  // namespace weft::render
