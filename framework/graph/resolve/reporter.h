// Purpose: collects the errors and warnings of resolving one graph, and counts the steps of work. The
// Reporter is the only object that all stages modify; a stage returns all its other results. Each stage
// reports all errors that it finds and continues. Results that are unknown because of an error are marked in
// Suspects, and later stages report nothing about them, so that one mistake causes one message.
#pragma once

#include <algorithm>
#include <string>

#include "weft/graph_desc.h"
#include "weft/result.h"

namespace weft {

// If there are too many errors or too many steps, Reporter adds a message and then throws this exception.
// Only resolve() and change_values() catch it. The exception stops a stage immediately, inside any loop, so
// that even a huge or very faulty graph takes little time.
struct ResolveStopped {};

class Reporter {
 public:
    static constexpr size_t kMostErrors = 100;
    static constexpr size_t kMostWarnings = 100;

    // `steps` is the limit graph.steps, which all tiers of the graph share. Warnings are added to `warnings`.
    Reporter(const GraphDesc& graph, uint64_t steps, Diagnostics& warnings);

    // Adds an error at a location and returns it. Throws ResolveStopped if there are too many errors.
    Diagnostic& error(SourceLoc loc, std::string code, std::string message);
    Diagnostic& add(Diagnostic fault);
    // Adds an error, unless an error with the same code was already reported at the same location.
    void add_once(Diagnostic fault);
    // Adds an error of a pass that is not the first pass of its repeat, and returns the error, so that the
    // caller can add help texts. If the error is already known, it is not added, and the returned diagnostic
    // is never shown. The caller still searches for similar names for its help text. So the cost of this
    // search, `search_steps`, is then counted with spend().
    Diagnostic& add_once(Diagnostic fault, SourceLoc loc, uint64_t search_steps);

    // Adds a help text to the last error. Adds nothing if there are at most `count` errors. The caller has
    // counted the errors earlier, so only a newer error gets the text.
    void help_last(size_t count, std::string help) {
        if (errors_.size() > count) errors_.back().help.push_back(std::move(help));
    }

    void warn(SourceLoc loc, std::string code, std::string message, std::string help);

    // Counts steps of work. Called before the work is done, wherever the content of the graph file determines
    // the amount of work. One step is about 100 ns of time or 32 bytes of memory. Throws ResolveStopped if
    // the steps exceed the limit.
    void spend(uint64_t count, SourceLoc loc);
    // Returns the number of steps that resolving one tier may take: the limit graph.steps, divided by the
    // number of tiers + 1.
    [[nodiscard]] uint64_t most_steps() const;

    [[nodiscard]] bool has_errors() const { return !errors_.empty(); }
    [[nodiscard]] size_t error_count() const { return errors_.size(); }
    [[nodiscard]] size_t warning_count() const { return warnings_.size(); }
    // Removes the warnings from index `first` to the end, before a stage runs again.
    void drop_warnings(size_t first) { warnings_.resize(std::min(first, warnings_.size())); }
    // Sorts the errors from index `first` to the end by their location in the files.
    void sort_errors(size_t first);
    // Returns all errors. Must be called once, at the end, because it also adds the number of omitted
    // warnings.
    [[nodiscard]] Diagnostics finish();

    [[nodiscard]] const SourceMap& sources() const { return graph_.sources; }

 private:
    [[nodiscard]] bool is_known(const Diagnostic& fault) const;
    [[noreturn]] void stop_for_steps(SourceLoc loc);

    const GraphDesc& graph_;
    uint64_t steps_limit_;
    Diagnostics& warnings_;
    Diagnostics errors_;
    Diagnostic unseen_;
    uint64_t steps_ = 0;
    size_t hidden_warnings_ = 0;
};

}  // namespace weft
