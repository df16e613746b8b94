#include "render/parts/draw_recorder.h"

#include <array>

#include "shared/draw_command.glsl"
#include "vulkan/device/functions.h"

namespace weft::render {
namespace {

constexpr uint32_t kCommandBytes = sizeof(VkDrawIndexedIndirectCommand);
static_assert(sizeof(shared::DrawCommand) == kCommandBytes);

// Returns the index in `run.draws` of the draw that is recorded as number i, counted from 0.
uint32_t place_of(const DrawRun& run, uint32_t i) {
    return run.order ? (*run.order)[i] : i;
}

}  // namespace

void DrawRecorder::bind(const GpuPart& part) {
    if (bound_ == &part) return;
    bound_ = &part;
    material_ = scene::kNone;
    const vk::DeviceFunctions& fn = *context_.fn;
    const GpuGeometry& geometry = part.geometry();
    const std::array streams{geometry.positions.handle(), geometry.attributes.handle()};
    const std::array<VkDeviceSize, 2> offsets{0, 0};
    fn.vkCmdBindVertexBuffers(context_.commands, 0, static_cast<uint32_t>(streams.size()), streams.data(),
                              offsets.data());
    fn.vkCmdBindIndexBuffer(context_.commands, geometry.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    if (!context_.uses_instances) return;
    const VkDescriptorSet instances = part.draw_set(context_.frame_slot);
    fn.vkCmdBindDescriptorSets(context_.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context_.layout, 3, 1,
                               &instances, 0, nullptr);
}

uint32_t DrawRecorder::record(const DrawRun& run) {
    const vk::DeviceFunctions& fn = *context_.fn;
    const std::vector<PartDraw>& draws = *run.draws;
    const auto size = static_cast<uint32_t>(run.order ? run.order->size() : draws.size());
    bind(*run.part);
    uint32_t left_out = 0;
    for (uint32_t i = 0; i < size;) {
        const uint32_t place = place_of(run, i);
        const PartDraw& draw = draws[place];
        const bool outside = is_outside(frusta_, draw.box, context_.depth_clamp);
        if (draw.variant != context_.variant || outside) {
            left_out += draw.variant == context_.variant ? 1 : 0;
            ++i;
            continue;
        }
        const uint32_t same = count_alike(run, i, size);
        i += same;
        set_state(*run.part, draw);
        if (run.has_commands)
            fn.vkCmdDrawIndexedIndirect(
                context_.commands, context_.draw_commands,
                context_.draw_commands_offset_bytes + VkDeviceSize{place} * kCommandBytes, 1, kCommandBytes);
        else
            fn.vkCmdDrawIndexed(context_.commands, draw.mesh.index_count, same, draw.mesh.first_index,
                                draw.mesh.vertex_offset, draw.instance);
    }
    return left_out;
}

void DrawRecorder::record_counted(const GpuPart& part) {
    bind(part);
    clockwise_ = mirrored_;
    context_.fn->vkCmdSetFrontFace(context_.commands,
                                   mirrored_ ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    context_.fn->vkCmdDrawIndexedIndirectCount(
        context_.commands, context_.draw_commands, context_.draw_commands_offset_bytes, context_.draw_count,
        context_.draw_count_offset_bytes, context_.most_draws, kCommandBytes);
}

// Returns how many draws one instanced command can draw, starting with the i-th draw. These draws have the
// same mesh and state, their instances have consecutive indices, and none of them is outside of the frustums.
// With indirect drawing the result is 1, because each draw has its own command in the buffer.
uint32_t DrawRecorder::count_alike(const DrawRun& run, uint32_t i, uint32_t size) const {
    if (run.has_commands) return 1;
    const PartDraw& first = (*run.draws)[place_of(run, i)];
    uint32_t count = 1;
    for (; i + count < size; ++count) {
        const PartDraw& next = (*run.draws)[place_of(run, i + count)];
        const bool alike = next.mesh == first.mesh && next.instance == first.instance + count &&
                           next.material == first.material && next.variant == first.variant &&
                           next.double_sided == first.double_sided && next.mirrored == first.mirrored &&
                           !is_outside(frusta_, next.box, context_.depth_clamp);
        if (!alike) break;
    }
    return count;
}

// Records only the state that differs from the previous draw.
void DrawRecorder::set_state(const GpuPart& part, const PartDraw& draw) {
    const vk::DeviceFunctions& fn = *context_.fn;
    if (context_.uses_materials && draw.material != material_) {
        const VkDescriptorSet set = part.material_set(draw.material);
        fn.vkCmdBindDescriptorSets(context_.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context_.layout, 2, 1,
                                   &set, 0, nullptr);
        material_ = draw.material;
    }
    const bool clockwise = draw.mirrored != mirrored_;
    if (clockwise_ != clockwise) {
        fn.vkCmdSetFrontFace(context_.commands,
                             clockwise ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
        clockwise_ = clockwise;
    }
    if (context_.cull == CullMode::material && double_sided_ != draw.double_sided) {
        fn.vkCmdSetCullMode(context_.commands, draw.double_sided ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
        double_sided_ = draw.double_sided;
    }
}

}  // namespace weft::render
