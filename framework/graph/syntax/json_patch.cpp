#include "graph/syntax/json_patch.h"

#include <algorithm>
#include <unordered_map>

namespace weft {
namespace {

class Patcher {
 public:
    Patcher(NullMeaning nulls, PatchLog& log) : nulls_(nulls), log_(log) {}

    void apply(JsonNode& target, JsonNode patch) {
        if (target.kind == JsonKind::object && patch.kind == JsonKind::object)
            return apply_members(target, std::move(patch));
        check_nulls(patch);
        log_.sources.add_replacement({patch.loc, target.loc});
        target = std::move(patch);
    }

 private:
    // Returns true while the current path is inside "/tiers/NAME/patch" and nulls must be kept there as
    // values.
    [[nodiscard]] bool keeps_nulls() const {
        return nulls_ == NullMeaning::remove_outside_tiers && path_.size() >= 3 && path_[0] == "tiers" &&
               path_[2] == "patch";
    }

    void apply_members(JsonNode& target, JsonNode patch) {
        // Members are looked up by hash, because a file may contain very many keys.
        std::unordered_map<std::string_view, size_t> index;
        for (size_t i = 0; i < target.members.size(); ++i) index.emplace(target.members[i].key, i);
        std::vector<bool> removed(target.members.size(), false);
        std::vector<JsonMember> added;
        for (JsonMember& member : patch.members) {
            const auto found = index.find(member.key);
            path_.push_back(member.key);
            if (found == index.end()) {
                check_nulls(member.value);
                if (member.value.kind != JsonKind::null || keeps_nulls()) added.push_back(std::move(member));
            } else if (member.value.kind == JsonKind::null && !keeps_nulls()) {
                removed[found->second] = true;
            } else {
                apply(target.members[found->second].value, std::move(member.value));
            }
            path_.pop_back();
        }
        size_t i = 0;
        std::erase_if(target.members, [&](const JsonMember&) { return removed[i++]; });
        std::ranges::move(added, std::back_inserter(target.members));
    }

    // Reports each null inside a value that is added or that replaces another value. A null removes a member
    // of the target. Here the target has no such member, so the null is an error.
    void check_nulls(JsonNode& node) {
        if (keeps_nulls()) return;
        if (node.kind == JsonKind::null) {
            Diagnostic& d = log_.errors.emplace_back(log_.sources.error(
                node.loc, "W128", "null removes a key, but the object has no key of this name"));
            d.help.emplace_back("correct the name, or remove this line");
        }
        for (JsonMember& member : node.members) {
            path_.push_back(member.key);
            check_nulls(member.value);
            path_.pop_back();
        }
    }

    NullMeaning nulls_;
    PatchLog& log_;
    std::vector<std::string> path_;
};

}  // namespace

void apply_patch(JsonNode& target, JsonNode patch, NullMeaning nulls, PatchLog& log) {
    Patcher(nulls, log).apply(target, std::move(patch));
}

}  // namespace weft
