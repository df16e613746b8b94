// Purpose: collects the errors and warnings of resolving one graph, and counts its steps. It is the only
// object that the stages modify; they return everything else. Every stage reports each fault that it finds
// and continues. Facts that are unknown because of a fault are marked in Suspects, and later stages report
// nothing about them: one cause, one message.
#pragma once

#include <string>

#include "weft/graph_desc.h"
#include "weft/result.h"

namespace weft {

// Thrown by Reporter if there are too many errors or the steps are used up, after it has added the message
// for that; only resolve() catches it. An exception stops a stage immediately, inside any loop, so that no
// graph, however large or faulty, takes much time.
struct ResolveStopped {};

class Reporter {
 public:
    static constexpr size_t kMostErrors = 100;
    static constexpr size_t kMostWarnings = 100;

    // `steps` is the limit graph.steps, which all tiers of the graph share. Warnings are added to `warnings`.
    Reporter(const GraphDesc& graph, uint64_t steps, Diagnostics& warnings);

    // Each of these throws ResolveStopped if there are too many errors.
    Diagnostic& error(SourceLoc loc, std::string code, std::string message);
    Diagnostic& add(Diagnostic fault);
    // Does nothing if the same code was reported at the same place.
    void add_once(Diagnostic fault);
    // For the later passes of a repeat: a known fault is not reported again, and the result is a diagnostic
    // that is discarded. The caller still searches for a similar name to suggest; `search_steps` are spent
    // for that.
    Diagnostic& add_once(Diagnostic fault, SourceLoc loc, uint64_t search_steps);

    void warn(SourceLoc loc, std::string code, std::string message, std::string help);

    // Counts work before it is done, where the file determines its amount: a step is about 100 ns or 32
    // bytes. Throws ResolveStopped beyond the limit.
    void spend(uint64_t count, SourceLoc loc);
    // The part of graph.steps that one tier may use.
    [[nodiscard]] uint64_t most_steps() const;

    [[nodiscard]] bool has_errors() const { return !errors_.empty(); }
    [[nodiscard]] size_t error_count() const { return errors_.size(); }
    // Sorts the errors from the index `first` on by their place in the file.
    void sort_errors(size_t first);
    // All errors. Call it once, at the end: it also reports the number of omitted warnings.
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
