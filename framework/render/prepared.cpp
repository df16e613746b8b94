#include "weft/render/prepared.h"

#include <algorithm>

#include "weft/compile.h"

namespace weft::render {
namespace {

std::string part_of(uint32_t some, uint32_t all, const char* what) {
    return std::to_string(some) + " of " + std::to_string(all) + " " + what + (all == 1 ? "" : "s");
}

}  // namespace

std::string to_text(const Rebuilt& rebuilt) {
    if (rebuilt.nothing()) return "nothing changed";
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
    if (rebuilt.changed_shaders > 0) add(part_of(rebuilt.changed_shaders, rebuilt.shaders, "shader"));
    if (rebuilt.made_pipelines > 0) add(part_of(rebuilt.made_pipelines, rebuilt.pipelines, "pipeline"));
    if (rebuilt.plan) add("a new plan");
    if (rebuilt.values) add("values");
    return text;
}

StageMark mark_of(const FramePlan& plan, const ShaderCatalog& shaders, VkImage output) {
    StageMark mark;
    mark.plan_hash = plan.hash;
    mark.structure_hash = structure_hash(plan);
    mark.output = output;
    for (const auto& [reference, program] : shaders) {
        const ShaderInterface& interface = program.interface;
        mark.programs[reference] = {program.content_hash, interface.bindings,
                                    interface.has_params ? std::optional(interface.params) : std::nullopt};
    }
    return mark;
}

bool same_bindings(const StageMark& a, const StageMark& b) {
    return std::ranges::equal(a.programs, b.programs, [](const auto& left, const auto& right) {
        return left.first == right.first && left.second.bindings == right.second.bindings &&
               left.second.params == right.second.params;
    });
}

uint32_t changed_programs(const StageMark& from, const StageMark& to) {
    return static_cast<uint32_t>(std::ranges::count_if(to.programs, [&](const auto& item) {
        const auto found = from.programs.find(item.first);
        return found == from.programs.end() || found->second.content_hash != item.second.content_hash;
    }));
}

}  // namespace weft::render
