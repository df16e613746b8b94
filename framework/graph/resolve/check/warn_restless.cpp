// Warns about passes with "rest" that run in every frame, because their shader reads a value that changes in
// every frame.
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

#include "graph/resolve/checks.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

// The members of FrameConstants that change in every frame.
constexpr std::array<std::string_view, 3> kChangingMembers{"frame_index", "time_s", "delta_time_s"};

bool changes(Builtin builtin) {
    return builtin == Builtin::frame_index || builtin == Builtin::time_s || builtin == Builtin::delta_time_s;
}

// Returns the name of a member that the shader reads and that changes in every frame; empty if there is none.
std::string changing_member(const ShaderInterface& shader) {
    for (const ShaderBinding& block : shader.bindings) {
        if (block.set != 0 || block.members.empty()) continue;
        for (const BlockMember& member : block.members.front().members) {
            if (std::ranges::find(kChangingMembers, member.name) == kChangingMembers.end()) continue;
            const bool is_read = std::ranges::any_of(shader.frame_ranges, [&](const FrameRange& range) {
                return range.binding == block.binding && range.offset_bytes <= member.offset_bytes &&
                       member.offset_bytes < range.offset_bytes + range.size_bytes;
            });
            if (is_read) return block.name + "." + member.name;
        }
    }
    return {};
}

}  // namespace

void warn_restless(const Declared& declared, const ResolvedGraph& graph, Reporter& reporter) {
    std::set<const PassDesc*> known;
    for (PassId id(0); id < graph.passes.size(); ++id) {
        const PassDecl& pass = graph.passes[id];
        const PassDraft& draft = declared.expansion.passes[id];
        if (pass.rest_unit == kNoId || draft.shader == nullptr || known.contains(draft.desc)) continue;
        const bool in_group = draft.group != kNoId;
        if (in_group && !declared.expansion.groups[draft.group].rests) continue;
        const auto param =
            std::ranges::find_if(pass.params, [](const ParamWrite& p) { return changes(p.builtin); });
        const std::string member =
            param != pass.params.end() ? "Params." + param->member : changing_member(*draft.shader);
        if (member.empty()) continue;
        known.insert(draft.desc);
        reporter.warn(
            in_group ? declared.input.graph.groups.at(draft.desc->group).rest_loc : draft.desc->rest_loc,
            "W138",
            "pass " + quote(draft.desc->name) +
                (in_group ? " belongs to a group with \"rest\"" : " has \"rest\"") +
                ", but never rests: its shader reads " + member + ", which changes in every frame",
            in_group ? "remove \"rest\" from the group, or let the shader do without this value"
                     : "remove \"rest\", or let the shader do without this value");
    }
}

}  // namespace weft
