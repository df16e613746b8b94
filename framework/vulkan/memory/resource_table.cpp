#include "vulkan/memory/resource_table.h"

#include <algorithm>

#include "vulkan/device/executor_errors.h"

namespace weft::vk {
namespace {

std::string shape_text(const ResourceDecl& decl) {
    return std::string(format_info(decl.format).name) + " " + std::to_string(decl.extent.width) + "x" +
           std::to_string(decl.extent.height) + "x" + std::to_string(decl.extent.depth) + ", " +
           std::to_string(decl.mips) + " mips, " + std::to_string(decl.layers) + " layers, " +
           std::to_string(decl.samples) + " samples";
}

bool same_shape(const ResourceDecl& a, const ResourceDecl& b) {
    return a.format == b.format && a.extent == b.extent && a.mips == b.mips && a.layers == b.layers &&
           a.samples == b.samples;
}

Status bind_textures(const FramePlan& plan, ResourceId id, const ImportBindings& bindings,
                     ResourceTable& table) {
    const ResourceDecl& decl = plan.graph.resources[id];
    const auto it = bindings.textures.find(decl.name);
    const size_t found = it == bindings.textures.end() ? 0 : it->second.size();
    if (found != decl.textures)
        return plan.graph.sources.error(decl.loc, "V414",
                                        "the program gave " + std::to_string(found) +
                                            " textures for the table \"" + decl.name + "\"; wanted " +
                                            std::to_string(decl.textures));
    if (std::ranges::find(it->second, VkImageView{VK_NULL_HANDLE}) != it->second.end())
        return plan.graph.sources.error(decl.loc, "V414",
                                        "the program gave no view for a texture of \"" + decl.name + "\"");
    table.textures.emplace(id, it->second);
    return Unit{};
}

Status bind_import(const FramePlan& plan, ResourceId id, const ImportBindings& bindings,
                   ResourceTable& table) {
    const ResourceDecl& decl = plan.graph.resources[id];
    if (decl.textures > 0) return bind_textures(plan, id, bindings, table);
    if (const auto slots = bindings.slot_buffers.find(decl.name); slots != bindings.slot_buffers.end()) {
        table.slot_buffers.emplace(id, slots->second);
        return Unit{};
    }
    if (decl.kind == ResourceKind::buffer) {
        const auto it = bindings.buffers.find(decl.name);
        if (it == bindings.buffers.end() || it->second == VK_NULL_HANDLE)
            return plan.graph.sources.error(
                decl.loc, "V414", "the program gave no buffer for the import \"" + decl.name + "\"");
        table.buffers[id] = it->second;
        return Unit{};
    }
    const auto it = bindings.images.find(decl.name);
    if (it == bindings.images.end() || it->second == nullptr)
        return plan.graph.sources.error(decl.loc, "V414",
                                        "the program gave no image for the import \"" + decl.name + "\"");
    if (!same_shape(it->second->decl(), decl))
        return plan.graph.sources.error(decl.loc, "V414",
                                        "the image for the import \"" + decl.name + "\" is " +
                                            shape_text(it->second->decl()) + "; wanted " + shape_text(decl));
    table.images[id] = it->second->handle();
    return Unit{};
}

// Returns a list by ResourceId: 1 if a live pass, the prologue or the epilogue uses the resource, else 0. The
// program need not provide an import that is used only by passes that the compiler has removed.
std::vector<uint8_t> used_resources(const FramePlan& plan) {
    std::vector<uint8_t> used(plan.graph.resources.size(), 0);
    for (const PassId pass : plan.schedule.order)
        for (const UseDecl& use : plan.graph.passes[pass].uses) used[use.resource] = 1;
    for (const BarrierDecl& barrier : plan.barriers.epilogue) used[barrier.resource] = 1;
    for (const BarrierDecl& barrier : plan.barriers.prologue.before) used[barrier.resource] = 1;
    return used;
}

}  // namespace

Result<ResourceTable> bind_resources(const FramePlan& plan, const TransientHeap& heap,
                                     const ImportBindings& bindings) {
    const size_t count = plan.graph.resources.size();
    const std::vector<uint8_t> used = used_resources(plan);
    ResourceTable table{.images = std::vector<VkImage>(count, VK_NULL_HANDLE),
                        .buffers = std::vector<VkBuffer>(count, VK_NULL_HANDLE),
                        .rings = Rings(plan)};
    Diagnostics errors;
    for (ResourceId id(0); id < count; ++id) {
        table.images[id] = heap.image(id);
        table.buffers[id] = heap.buffer(id);
        if (!used[id] || plan.graph.resources[id].lifetime != ResourceLifetime::imported) continue;
        const Status status = bind_import(plan, id, bindings, table);
        if (!status) append(errors, status.errors());
    }
    if (!errors.empty()) return errors;
    return table;
}

}  // namespace weft::vk
