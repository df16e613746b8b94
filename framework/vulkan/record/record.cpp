#include "vulkan/record/record.h"

#include <algorithm>

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/record/draw_targets.h"
#include "vulkan/record/raw_pass.h"

namespace weft::vk {
namespace {

// Returns descriptor set 0 of the pass, for `view` or, with multiview, for all views of the pass.
VkDescriptorSet frame_set(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared,
                          const std::string& view) {
    const DrawSource& draws = *context.objects.draws;
    if (pass.view_use != kNoId) {
        const Position position(static_cast<uint32_t>(&prepared - context.objects.passes.data()));
        return context.objects.view_sets.set(position, context.resources.frame(), context.slot);
    }
    if (pass.lowering == ViewLowering::multiview) return draws.views_set(context.slot, pass.views);
    return pass.area.image == kNoId ? draws.frame_set(context.slot, view)
                                    : draws.frame_set_of_area(context.slot, view, pass.area);
}

// Binds descriptor sets 0 (frame) and 1 (ports), and writes the push constants. The draw source binds sets 2
// and 3. Call this after a pipeline of the pass is bound. `view` is the view to draw; with multiview, all
// views of the pass are drawn.
void bind_pass(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared,
               VkPipelineBindPoint point, const std::string& view) {
    const DeviceFunctions& fn = context.device.fn();
    const VkPipelineLayout layout = prepared.layout.pipeline.get();
    if (prepared.layout.declares[kFrameSet]) {
        const VkDescriptorSet set = frame_set(context, pass, prepared, view);
        fn.vkCmdBindDescriptorSets(context.commands, point, layout, kFrameSet, 1, &set, 0, nullptr);
    }
    if (prepared.layout.has_ports())
        fn.vkCmdBindDescriptorSets(
            context.commands, point, layout, kPortSet, 1,
            &prepared.port_set(variant_in(pass, context.switches), context.resources.frame(), context.slot),
            0, nullptr);
    if (prepared.layout.index_stages != 0) {
        const uint32_t index = 0;
        fn.vkCmdPushConstants(context.commands, layout, prepared.layout.index_stages, 0, sizeof index,
                              &index);
    }
    if (prepared.layout.push_stages == 0 || pass.params_bytes == 0) return;
    std::vector<std::byte> bytes(pass.params_bytes);
    const ResolvedGraph& graph = context.objects.plan.graph;
    write_params(graph, PassId(static_cast<uint32_t>(&pass - graph.passes.data())),
                 {context.frame, context.resources, context.objects.areas, &context.objects.validity,
                  context.switches},
                 bytes);
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

// Returns the views for which the draws of a pass are recorded, one after the other. With multiview, the
// draws are recorded only once, for all views together.
std::span<const std::string> recorded_views(const PassDecl& pass) {
    return pass.lowering == ViewLowering::multiview ? std::span(&pass.view, 1) : pass.drawn_views();
}

// Prepares draws without vertex buffers. The shader gets only the vertex and instance indices.
void bind_vertices(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared,
                   const std::string& view) {
    const DeviceFunctions& fn = context.device.fn();
    fn.vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                         prepared.pipelines_of(variant_in(pass, context.switches))[0].pipeline.get());
    bind_pass(context, pass, prepared, VK_PIPELINE_BIND_POINT_GRAPHICS, view);
    // A view can be a mirror image, in which triangles have the opposite winding. This does not concern a
    // fullscreen pass, because its triangle is the same in every view.
    const DrawSource* draws = context.objects.draws;
    if (pass.kind != PassKind::raster || draws == nullptr) return;
    const FrontFace front = pass.state.front_face;
    fn.vkCmdSetFrontFace(context.commands, to_vk(draws->is_mirrored(view) ? opposite(front) : front));
}

void draw_vertices(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared,
                   uint32_t vertices, uint32_t instances) {
    for (const std::string& view : recorded_views(pass)) {
        bind_vertices(context, pass, prepared, view);
        context.device.fn().vkCmdDraw(context.commands, vertices, instances, 0, 0);
    }
}

// Records the draws whose draw commands are in a buffer. On a device without multiDrawIndirect, one call may
// execute only one draw command.
void draw_vertices_indirectly(const RecordContext& context, const PassDecl& pass,
                              const PreparedPass& prepared, const std::string& view) {
    constexpr uint32_t kCommandBytes = sizeof(VkDrawIndirectCommand);
    const DeviceFunctions& fn = context.device.fn();
    const IndirectPlace from = place_of(context, pass, pass.draw_commands_use);
    const IndirectPlace count = place_of(context, pass, pass.draw_count_use);
    bind_vertices(context, pass, prepared, view);
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

// Draws one draw list. Returns the number of draws that were left out because they are outside of the frustum
// of the view.
uint32_t draw_list(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared,
                   const DrawPipeline& draw, const std::string& view, const DrawTargets& targets) {
    const DeviceFunctions& fn = context.device.fn();
    fn.vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw.pipeline.get());
    // Binds sets 0 and 1 again for every variant. All variants share one pipeline layout, but earlier draws
    // may have bound other sets.
    bind_pass(context, pass, prepared, VK_PIPELINE_BIND_POINT_GRAPHICS, view);
    DrawContext draws;
    draws.fn = &fn;
    draws.commands = context.commands;
    draws.layout = prepared.layout.pipeline.get();
    draws.list = draw.list;
    draws.view = view;
    if (pass.lowering == ViewLowering::multiview) draws.views = pass.views;
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
    draws.targets = targets;
    return context.objects.draws->record(draws);
}

// The part of the attachments to which a pass draws, and the dynamic state for this part. If the attachments
// have a live size, the part is the area that this frame uses.
struct DrawnArea {
    VkExtent2D extent;
    RasterState state;
};

DrawnArea drawn_area(const RecordContext& context, const PassDecl& pass, const RenderingScope& scope) {
    if (pass.area.image == kNoId) return {scope.area.extent, pass.state};
    const FrameAreas& areas = context.objects.areas;
    const Extent3D area = areas.area(ResourceId(pass.area.image), pass.area.mip);
    return {{area.width, area.height}, live_state(pass, areas.values())};
}

// Begins the rendering scope of a pass.
void begin_pass(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared) {
    const RenderingScope& scope = prepared.scope(context.resources.frame());
    const DrawnArea area = drawn_area(context, pass, scope);
    begin_rendering(context.device, context.commands, scope, area.extent, area.state);
}

// Records the draw lists of a pass, for each view.
void record_lists(const RecordContext& context, Position position, const PassDecl& pass,
                  const PreparedPass& prepared) {
    const DrawnArea area = drawn_area(context, pass, prepared.scope(context.resources.frame()));
    DrawTargets targets = draw_targets(context.objects.plan.graph, pass);
    targets.extent = area.extent;
    bool first = true;
    const std::span<const std::string> views = recorded_views(pass);
    for (const DrawPipeline& draw : prepared.pipelines_of(variant_in(pass, context.switches)))
        for (size_t view = 0; view < views.size(); ++view) {
            // Sets the dynamic state again before every list except the first, because a draw list of the
            // program may have bound a pipeline without this dynamic state.
            if (!first) set_draw_state(context.device, context.commands, area.extent, area.state);
            first = false;
            context.draws_left_out[context.first_view[position] + view] +=
                draw_list(context, pass, prepared, draw, views[view], targets);
        }
}

}  // namespace

std::vector<uint32_t> count_recorded_views(const FramePlan& plan) {
    std::vector<uint32_t> first{0};
    for (const PassId id : plan.schedule.order)
        first.push_back(first.back() + static_cast<uint32_t>(recorded_views(plan.graph.passes[id]).size()));
    return first;
}

void record_compute(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared) {
    const DeviceFunctions& fn = context.device.fn();
    fn.vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE,
                         prepared.pipelines_of(variant_in(pass, context.switches))[0].pipeline.get());
    bind_pass(context, pass, prepared, VK_PIPELINE_BIND_POINT_COMPUTE, pass.view);
    const IndirectPlace sizes = place_of(context, pass, pass.indirect_use);
    if (sizes.buffer != VK_NULL_HANDLE)
        return fn.vkCmdDispatchIndirect(context.commands, sizes.buffer, sizes.offset_bytes);
    const std::array<uint32_t, 3> groups = live_groups(pass, context.objects.areas.values());
    fn.vkCmdDispatch(context.commands, groups[0], groups[1], groups[2]);
}

void record_fullscreen(const RecordContext& context, const PassDecl& pass, const PreparedPass& prepared) {
    begin_pass(context, pass, prepared);
    draw_vertices(context, pass, prepared, 3, 1);
    end_rendering(context.device, context.commands, prepared.scope(context.resources.frame()));
}

void record_raster(const RecordContext& context, Position position, const PassDecl& pass,
                   const PreparedPass& prepared) {
    begin_pass(context, pass, prepared);
    if (pass.draws_without_list() && pass.draw_commands_use != kNoId)
        for (const std::string& view : recorded_views(pass))
            draw_vertices_indirectly(context, pass, prepared, view);
    else if (pass.vertices > 0)
        draw_vertices(context, pass, prepared, pass.vertices, pass.instances);
    else
        record_lists(context, position, pass, prepared);
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
                                            objects.plan, context.resources, objects.areas);
        case PassKind::custom:
            return record_custom(context, position, pass, prepared);
    }
}

}  // namespace weft::vk
