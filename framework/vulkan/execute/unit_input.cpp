#include "vulkan/execute/unit_input.h"

#include <cstring>

#include "vulkan/pipelines/params.h"

namespace weft::vk {
namespace {

void add_number(uint64_t number, std::vector<std::byte>& bytes) {
    const size_t old = bytes.size();
    bytes.resize(old + sizeof number);
    std::memcpy(bytes.data() + old, &number, sizeof number);
}

// Returns false if the set or one of the draw lists may change in every frame.
bool add_draws(const UnitInputContext& context, const PassDecl& pass, const PreparedPass& prepared,
               std::vector<std::byte>& bytes) {
    const DrawSource* draws = context.objects.draws;
    if (prepared.layout.declares[kFrameSet] &&
        !draws->add_frame_bytes(context.slot, pass.view, prepared.frame_ranges, bytes))
        return false;
    for (const std::string& list : pass.draw_lists) {
        const std::optional<uint64_t> version = draws->list_version(list);
        if (!version) return false;
        add_number(*version, bytes);
    }
    return true;
}

// Returns false if the pass reads an import without a version.
bool add_imports(const UnitInputContext& context, const PassDecl& pass, std::vector<std::byte>& bytes) {
    for (const UseDecl& use : pass.uses) {
        const ResourceDecl& resource = context.objects.plan.graph.resources[use.resource];
        if (resource.lifetime != ResourceLifetime::imported || !use.wakes) continue;
        const auto version = context.frame.import_versions.find(resource.name);
        if (version == context.frame.import_versions.end()) return false;
        add_number(version->second, bytes);
    }
    return true;
}

}  // namespace

void add_unit_input(const UnitInputContext& context, Position position, UnitInput& input) {
    if (!input) return;
    const FramePlan& plan = context.objects.plan;
    const PassId id = plan.schedule.order[position];
    const PassDecl& pass = plan.graph.passes[id];
    std::vector<std::byte>& bytes = *input;
    const size_t old = bytes.size();
    bytes.resize(old + pass.params_bytes);
    // The validity of what the pass reads is left out: a unit whose results become valid has run, and so it
    // wakes its readers.
    write_params(plan.graph, id, {context.frame, context.resources}, std::span(bytes).subspan(old));
    // The values of passes without a shader, such as the value of a clear.
    for (const float channel : pass.clear) {
        uint32_t bits = 0;
        std::memcpy(&bits, &channel, sizeof bits);
        add_number(bits, bytes);
    }
    const bool known = add_draws(context, pass, context.objects.passes[position], bytes) &&
                       add_imports(context, pass, bytes);
    if (!known) input.reset();
}

}  // namespace weft::vk
