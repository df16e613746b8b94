#include "graph/resolve/reporter.h"

#include <algorithm>
#include <tuple>

#include "weft/limits.h"

namespace weft {

Reporter::Reporter(const GraphDesc& graph, uint64_t steps, Diagnostics& warnings)
    : graph_(graph), steps_limit_(steps), warnings_(warnings) {}

Diagnostic& Reporter::error(SourceLoc loc, std::string code, std::string message) {
    return add(sources().error(loc, std::move(code), std::move(message)));
}

Diagnostic& Reporter::add(Diagnostic fault) {
    if (errors_.size() < kMostErrors) return errors_.emplace_back(std::move(fault));
    errors_.back().help.push_back("only the first " + std::to_string(errors_.size()) + " errors are shown");
    throw ResolveStopped{};
}

void Reporter::add_once(Diagnostic fault) {
    if (!is_known(fault)) add(std::move(fault));
}

Diagnostic& Reporter::add_once(Diagnostic fault, SourceLoc loc, uint64_t search_steps) {
    if (!is_known(fault)) return add(std::move(fault));
    spend(search_steps, loc);
    return unseen_ = std::move(fault);
}

void Reporter::warn(SourceLoc loc, std::string code, std::string message, std::string help) {
    if (warnings_.size() >= kMostWarnings) {
        ++hidden_warnings_;
        return;
    }
    Diagnostic warning = sources().error(loc, std::move(code), std::move(message));
    warning.severity = Severity::warning;
    warning.help.push_back(std::move(help));
    warnings_.push_back(std::move(warning));
}

void Reporter::spend(uint64_t count, SourceLoc loc) {
    const uint64_t most = most_steps();
    if (count > most || steps_ > most - count) stop_for_steps(loc);
    steps_ += count;
}

uint64_t Reporter::most_steps() const {
    return std::max<uint64_t>(1, steps_limit_ / (graph_.tiers.size() + 1));
}

void Reporter::sort_errors(size_t first) {
    const auto place = [](const Diagnostic& d) { return std::tie(d.file, d.line, d.column); };
    std::stable_sort(errors_.begin() + static_cast<std::ptrdiff_t>(first), errors_.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return place(a) < place(b); });
}

Diagnostics Reporter::finish() {
    if (hidden_warnings_ > 0)
        warnings_.back().help.push_back("and " + std::to_string(hidden_warnings_) + " more warnings");
    return std::move(errors_);
}

bool Reporter::is_known(const Diagnostic& fault) const {
    return std::ranges::any_of(errors_, [&](const Diagnostic& d) {
        return d.code == fault.code && d.file == fault.file && d.line == fault.line &&
               d.column == fault.column;
    });
}

// Reports that the steps are used up and stops resolving. This error is added even if there are already
// kMostErrors errors.
void Reporter::stop_for_steps(SourceLoc loc) {
    Diagnostic& d = errors_.emplace_back(sources().error(
        loc, "W125",
        "the graph needs more than " + std::to_string(most_steps()) +
            " steps to resolve; the limit was exceeded here" +
            (graph_.tiers.empty() ? "" : ": all tiers together may take " + std::to_string(steps_limit_))));
    d.help.push_back("use fewer passes and ports, wider ranges of mips and layers, or shorter expressions, " +
                     raise_limit_text("graph.steps"));
    throw ResolveStopped{};
}

}  // namespace weft
