#include "render/render_stage.h"

#include <algorithm>

#include "weft/compile.h"

namespace weft::render {
namespace {

// True if `a` and `b` have shader programs with the same names, and programs with the same name have the same
// descriptor bindings and Params blocks. The code of the programs may differ.
bool same_bindings(const StageFingerprint& a, const StageFingerprint& b) {
    return std::ranges::equal(a.programs, b.programs, [](const auto& left, const auto& right) {
        return left.first == right.first && left.second.bindings == right.second.bindings &&
               left.second.params == right.second.params;
    });
}

}  // namespace

StageFingerprint take_fingerprint(const FramePlan& plan, const ShaderCatalog& shaders, VkImage output) {
    StageFingerprint fingerprint;
    fingerprint.structure_hash = structure_hash(plan);
    fingerprint.values_hash = values_hash(plan.graph);
    fingerprint.output = output;
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id)
        if (plan.graph.resources[id].shared && plan.live.live_resources[id])
            fingerprint.shared.push_back(plan.graph.resources[id]);
    for (const auto& [reference, program] : shaders) {
        const ShaderInterface& interface = program.interface;
        fingerprint.programs[reference] = {
            program.content_hash, interface.bindings,
            interface.has_params ? std::optional(interface.params) : std::nullopt};
    }
    return fingerprint;
}

bool can_amend(const StageFingerprint& from, const StageFingerprint& to) {
    return from.structure_hash == to.structure_hash && from.output == to.output &&
           from.imports == to.imports && from.files == to.files && same_bindings(from, to);
}

uint32_t count_changed_programs(const StageFingerprint& from, const StageFingerprint& to) {
    return static_cast<uint32_t>(std::ranges::count_if(to.programs, [&](const auto& item) {
        const auto found = from.programs.find(item.first);
        return found == from.programs.end() || found->second.content_hash != item.second.content_hash;
    }));
}

}  // namespace weft::render
