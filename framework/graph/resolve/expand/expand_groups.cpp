#include "graph/resolve/expand/expand_groups.h"

#include <algorithm>

#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

constexpr double kMostRounds = 100000;

using Indices = std::map<std::string, double>;

// Lists the values of the indices of a group, one entry for each round. The passes of the group have the same
// loops and were made earlier. So an error in the range of an index was already reported, and the number of
// rounds is limited.
class RoundLister {
 public:
    RoundLister(const Evaluator& evaluator, const GroupDesc& desc) : evaluator_(evaluator), desc_(desc) {}

    std::map<Indices, uint32_t> run() {
        descend(0);
        return std::move(rounds_);
    }

 private:
    void descend(size_t level) {
        if (level == desc_.repeat.size()) {
            rounds_.emplace(indices_, static_cast<uint32_t>(rounds_.size()));
            return;
        }
        const RepeatDesc& repeat = desc_.repeat[level];
        const double first = number(repeat.first), last = number(repeat.last);
        const double step = repeat.step.empty() ? 1 : number(repeat.step);
        if (step == 0) return;
        for (double i = first; step > 0 ? i <= last : i >= last; i += step) {
            indices_[repeat.index] = i;
            descend(level + 1);
        }
        indices_.erase(repeat.index);
    }

    double number(const Expr& expression) const {
        const std::optional<ExprValue> value = evaluator_.in_repeat(indices_, true).value(expression);
        return value ? value->x : 0;
    }

    const Evaluator& evaluator_;
    const GroupDesc& desc_;
    Indices indices_;
    std::map<Indices, uint32_t> rounds_;
};

// Returns a number of rounds: the value of the key `key` of the group, or `absent` if the key is absent or
// has an error.
uint32_t count(const Evaluator& evaluator, const GroupDesc& desc, const Expr& value, const char* key,
               uint32_t absent) {
    if (value.empty()) return absent;
    const std::optional<double> found =
        evaluator.number(value, quote(key) + " of group " + quote(desc.name), 0, kMostRounds);
    return found ? static_cast<uint32_t>(*found) : absent;
}

GroupDecl declare(const ResolveInput& input, const Evaluator& evaluator, const GroupDesc& desc) {
    GroupDecl group;
    group.name = desc.name;
    group.per_frame = count(evaluator, desc, desc.per_frame, "perFrame", GroupDecl::kAll);
    group.warm_up = count(evaluator, desc, desc.warm_up, "warmUp", GroupDecl::kAll);
    group.settle = count(evaluator, desc, desc.settle, "settle", 0);
    group.rests = desc.rests && input.request.rests;
    group.turns = desc.turns;
    group.loc = desc.loc;
    return group;
}

}  // namespace

void expand_groups(const ResolveInput& input, const Evaluator& evaluator, Expansion& expansion) {
    for (const auto& [name, desc] : input.graph.groups) {
        const auto index = static_cast<uint32_t>(expansion.groups.size());
        GroupDecl& group = expansion.groups.emplace_back(declare(input, evaluator, desc));
        const bool faulty = std::ranges::any_of(expansion.faulty, [&](const std::string& pass) {
            return input.graph.passes.contains(pass) && input.graph.passes.at(pass).group == name;
        });
        if (faulty || expansion.too_large) continue;
        const std::map<Indices, uint32_t> rounds = RoundLister(evaluator, desc).run();
        group.rounds = static_cast<uint32_t>(rounds.size());
        for (PassDraft& draft : expansion.passes) {
            if (draft.desc->group != name) continue;
            Indices own;
            for (const RepeatDesc& repeat : desc.repeat)
                own.emplace(repeat.index, draft.indices.at(repeat.index));
            draft.group = index;
            draft.round = rounds.at(own);
        }
    }
}

}  // namespace weft
