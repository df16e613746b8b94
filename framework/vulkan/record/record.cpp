#include "vulkan/record/record.h"

#include <algorithm>

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/record/draw_targets.h"

namespace weft::vk {
namespace {

// Binds descriptor sets 0 (frame) and 1 (ports), and writes the push constants. The draw source binds sets 2
// and 3. Call this after a pipeline of the pass is bound.
void bind_pass(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared,
               VkPipelineBindPoint point) {
    const DeviceFunctions& fn = context.device.fn();
    const VkPipelineLayout layout = prepared.layout.pipeline.get();
    if (prepared.layout.declares[kFrameSet]) {
        const VkDescriptorSet set = context.objects.draws->frame_set(context.slot, pass.view);
        fn.vkCmdBindDescriptorSets(context.commands, point, layout, kFrameSet, 1, &set, 0, nullptr);
    }
    if (prepared.layout.has_ports())
        fn.vkCmdBindDescriptorSets(context.commands, point, layout, kPortSet, 1,
                                   &prepared.port_set(context.resources.frame(), context.slot), 0, nullptr);
    if (prepared.layout.index_stages != 0) {
        const uint32_t index = 0;
        fn.vkCmdPushConstants(context.commands, layout, prepared.layout.index_stages, 0, sizeof index,
                              &index);
    }
    if (prepared.layout.push_stages == 0 || pass.params_bytes == 0) return;
    std::vector<std::byte> bytes(pass.params_bytes);
    const ResolvedGraph& graph = context.objects.plan.graph;
    write_params(graph, PassId(static_cast<uint32_t>(&pass - graph.passes.data())),
                 {context.frame, context.resources, &context.objects.validity}, bytes);
    fn.vkCmdPushConstants(context.commands, layout, prepared.layout.push_stages, 0, pass.params_bytes,
                          bytes.data());
}

// A buffer from which the GPU reads numbers, and the offset at which they begin.
struct IndirectPlace {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset_bytes = 0;
};

IndirectPlace place_of(const RecordContext& context, const PassDecl& pass, uint32_t use_index) {
    if (use_index == kNoId) return {};
    const UseDecl& use = pass.uses[use_index];
    const ResourceDecl& buffer = context.objects.plan.graph.resources[use.resource];
    return {context.resources.buffer(use.resource), used_bytes(buffer, use).offset_bytes};
}

FrontFace opposite(FrontFace face) {
    return face == FrontFace::clockwise ? FrontFace::counter_clockwise : FrontFace::clockwise;
}

// Prepares draws without vertex buffers. The shader gets only the vertex and instance indices.
void bind_vertices(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared) {
    const DeviceFunctions& fn = context.device.fn();
    fn.vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                         prepared.pipelines[0].pipeline.get());
    bind_pass(context, pass, prepared, VK_PIPELINE_BIND_POINT_GRAPHICS);
    // The triangle of a fullscreen pass is the same in every view.
    const DrawSource* draws = context.objects.draws;
    if (pass.kind == PassKind::raster && draws != nullptr && draws->is_mirrored(pass.view))
        fn.vkCmdSetFrontFace(context.commands, to_vk(opposite(pass.state.front_face)));
}

void draw_vertices(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared,
                   uint32_t vertices, uint32_t instances) {
    bind_vertices(context, pass, prepared);
    context.device.fn().vkCmdDraw(context.commands, vertices, instances, 0, 0);
}

// Draws what the commands in a buffer say. A device without multiDrawIndirect executes only one command at a
// time.
void draw_vertices_indirectly(const RecordContext& context, const PassDecl& pass,
                              const PreparedPass& prepared) {
    constexpr uint32_t kCommandBytes = sizeof(VkDrawIndirectCommand);
    const DeviceFunctions& fn = context.device.fn();
    const IndirectPlace from = place_of(context, pass, pass.draw_commands_use);
    const IndirectPlace count = place_of(context, pass, pass.draw_count_use);
    bind_vertices(context, pass, prepared);
    if (count.buffer != VK_NULL_HANDLE)
        return fn.vkCmdDrawIndirectCount(context.commands, from.buffer, from.offset_bytes, count.buffer,
                                         count.offset_bytes, pass.most_draws, kCommandBytes);
    const bool several = context.device.optional().multi_draw_indirect;
    const uint32_t step = several ? context.device.profile().max_draw_indirect_count : 1;
    for (uint64_t done = 0; done < pass.most_draws; done += step)
        fn.vkCmdDrawIndirect(context.commands, from.buffer, from.offset_bytes + done * kCommandBytes,
                             static_cast<uint32_t>(std::min<uint64_t>(step, pass.most_draws - done)),
                             kCommandBytes);
}

// Returns the number of draws that were left out.
uint32_t draw_list(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared,
                   const DrawPipeline& draw) {
    const DeviceFunctions& fn = context.device.fn();
    fn.vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw.pipeline.get());
    // Binds sets 0 and 1 again for every variant. All variants share one pipeline layout, but earlier draws
    // may have bound other sets.
    bind_pass(context, pass, prepared, VK_PIPELINE_BIND_POINT_GRAPHICS);
    DrawContext draws;
    draws.fn = &fn;
    draws.commands = context.commands;
    draws.layout = prepared.layout.pipeline.get();
    draws.list = draw.list;
    draws.view = pass.view;
    draws.variant = draw.variant;
    draws.cull = pass.state.cull;
    draws.frame_slot = context.slot;
    const IndirectPlace commands = place_of(context, pass, pass.draw_commands_use);
    const IndirectPlace count = place_of(context, pass, pass.draw_count_use);
    draws.draw_commands = commands.buffer;
    draws.draw_commands_offset_bytes = commands.offset_bytes;
    draws.draw_count = count.buffer;
    draws.draw_count_offset_bytes = count.offset_bytes;
    draws.most_draws = pass.most_draws;
    draws.uses_materials = prepared.layout.declares[kMaterialSet];
    draws.uses_instances = prepared.layout.declares[kInstanceSet];
    draws.culls_draws = pass.culls_draws;
    draws.depth_clamp = pass.state.depth_clamp;
    draws.frame_ranges = prepared.frame_ranges;
    draws.targets = draw_targets(context.objects.plan.graph, pass);
    return context.objects.draws->record(draws);
}

}  // namespace

void record_compute(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared) {
    const DeviceFunctions& fn = context.device.fn();
    fn.vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE,
                         prepared.pipelines[0].pipeline.get());
    bind_pass(context, pass, prepared, VK_PIPELINE_BIND_POINT_COMPUTE);
    const IndirectPlace sizes = place_of(context, pass, pass.indirect_use);
    if (sizes.buffer != VK_NULL_HANDLE)
        fn.vkCmdDispatchIndirect(context.commands, sizes.buffer, sizes.offset_bytes);
    else
        fn.vkCmdDispatch(context.commands, pass.groups[0], pass.groups[1], pass.groups[2]);
}

void record_fullscreen(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared) {
    begin_rendering(context.device, context.commands, prepared.scope(context.resources.frame()), pass.state);
    draw_vertices(context, pass, prepared, 3, 1);
    end_rendering(context.device, context.commands, prepared.scope(context.resources.frame()));
}

void record_raster(const RecordContext& context, Position position, const PassDecl& pass,
                   const PreparedPass& prepared) {
    begin_rendering(context.device, context.commands, prepared.scope(context.resources.frame()), pass.state);
    if (pass.draws_without_list() && pass.draw_commands_use != kNoId)
        draw_vertices_indirectly(context, pass, prepared);
    else if (pass.vertices > 0)
        draw_vertices(context, pass, prepared, pass.vertices, pass.instances);
    else
        for (const DrawPipeline& draw : prepared.pipelines) {
            // A list of the program may have bound a pipeline without this dynamic state.
            if (&draw != &prepared.pipelines.front())
                set_draw_state(context.device, context.commands, prepared.scope(context.resources.frame()),
                               pass.state);
            context.draws_left_out[position] += draw_list(context, pass, prepared, draw);
        }
    end_rendering(context.device, context.commands, prepared.scope(context.resources.frame()));
}

void record_pass(const RecordContext& context, Position position) {
    const PlanObjects& objects = context.objects;
    const PassDecl& pass = objects.plan.graph.passes[objects.plan.schedule.order[position]];
    const PreparedPass& prepared = objects.passes[position];
    switch (pass.kind) {
        case PassKind::compute:
            return record_compute(context, pass, prepared);
        case PassKind::fullscreen:
            return record_fullscreen(context, pass, prepared);
        case PassKind::raster:
            return record_raster(context, position, pass, prepared);
        case PassKind::clear:
            return record_clear(context, pass);
        case PassKind::copy:
        case PassKind::blit:
            return record_copy(context, pass);
        case PassKind::readback:
            return objects.readbacks.record(context.device, context.commands, position, context.slot,
                                            objects.plan, context.resources);
        case PassKind::custom:
            return objects.uploads.record(context.device, context.commands, position, *prepared.type, pass,
                                          context.slot, context.resources);
    }
}

}  // namespace weft::vk
