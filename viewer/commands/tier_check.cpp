#include "viewer/commands/tier_check.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "graph/syntax/merge.h"
#include "weft/load/load_graph.h"

namespace weft::viewer {
namespace {

class Findings {
 public:
    void add(Diagnostics found) {
        ++variants_;
        for (Diagnostic& d : found) {
            const auto [it, is_new] = seen_.try_emplace(std::tuple(d.code, d.file, d.line, d.column),
                                                        Seen{all_.size(), variants_, variants_, 1});
            // Two messages of one variant with the same code and place are two faults, so both are kept. The
            // same message in a later variant is the same fault, so it is only counted.
            if (is_new || it->second.first == variants_) {
                all_.push_back(std::move(d));
            } else if (it->second.last != variants_) {
                it->second.last = variants_;
                ++it->second.variants;
            }
        }
    }

    // Returns the messages that all variants of the file have. A variant is the file with one tier, or
    // without a tier.
    Diagnostics take_common() {
        Diagnostics kept;
        for (const auto& [place, seen] : seen_)
            if (seen.variants == variants_) kept.push_back(std::move(all_[seen.index]));
        return kept;
    }

    // Returns all messages. A warning that something is unused is left out if it is not reported for all
    // variants, because another tier may use the same resource.
    Diagnostics take() {
        std::vector<bool> used(all_.size(), false);
        for (const auto& [place, seen] : seen_) {
            used[seen.index] = says_unused(all_[seen.index]) && seen.variants < variants_;
        }
        Diagnostics kept;
        for (size_t i = 0; i < all_.size(); ++i)
            if (!used[i]) kept.push_back(std::move(all_[i]));
        return kept;
    }

 private:
    struct Seen {
        size_t index;
        // Number of the first variant (file with one tier, or without a tier) that has the message.
        size_t first;
        size_t last;      // Number of the last variant of the file that has the message.
        size_t variants;  // Number of variants of the file that have the message.
    };
    Diagnostics all_;
    std::map<std::tuple<std::string, std::string, uint32_t, uint32_t>, Seen> seen_;
    size_t variants_ = 0;
};

}  // namespace

CheckedGraph check_tiers(const std::string& file, const OfflineOptions& options) {
    CheckedGraph checked;
    const Result<JsonDoc> document = read_offline(file, options);
    if (!document) {
        checked.found = document.errors();
        return checked;
    }
    std::vector<std::string> tiers{options.request.tier};
    if (options.request.tier.empty()) {
        for (const std::string& name : tier_names(*document)) tiers.push_back(name);
        checked.tiers = tiers.size() - 1;
    }
    Findings findings, views;
    SharedByTiers shared;
    for (const std::string& tier : tiers) {
        OfflineOptions of_tier = options;
        of_tier.request.tier = tier;
        Diagnostics found;
        Result<OfflinePlan> made =
            compile_offline(*document, of_tier, found, tiers.size() > 1 ? &shared : nullptr);
        if (!made) found.insert(found.end(), made.errors().begin(), made.errors().end());
        if (made) views.add(std::move(made->view_faults));
        if (made && !checked.plan) checked.plan = std::move(made->plan);
        findings.add(std::move(found));
    }
    checked.found = findings.take();
    // Report a fault in a debug view only if all tiers have the fault. A view may show a resource that only
    // some tiers have; in the other tiers the view is listed as unavailable.
    for (Diagnostic& d : views.take_common()) checked.found.push_back(std::move(d));
    return checked;
}

}  // namespace weft::viewer
