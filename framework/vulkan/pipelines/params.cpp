#include "vulkan/pipelines/params.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "graph/diagnostics/whole_number.h"
#include "graph/live/live_frame.h"

namespace weft::vk {
namespace {

// Alignment of each block in bytes: the largest minUniformBufferOffsetAlignment that Vulkan allows.
constexpr uint64_t kUniformAlignmentBytes = 256;

// Returns the value of a member that describes the area of a port. Components are 0 (x) and 1 (y).
double area_value(const ResolvedGraph& graph, const UseDecl& use, Builtin builtin, uint32_t component,
                  const FrameAreas& areas) {
    const auto side = [&](const Extent3D& extent) -> double {
        return component == 0 ? extent.width : extent.height;
    };
    const double area = side(areas.area(use.resource, use.range.mip));
    const double whole = side(mip_extent(graph.resources[use.resource].extent, use.range.mip));
    if (builtin == Builtin::area_size) return area;
    return (builtin == Builtin::area_uv ? area : area - kFilterMargin_px) / whole;
}

double builtin_value(const ResolvedGraph& graph, PassId pass, const ParamWrite& write, uint32_t component,
                     const FrameValues& values) {
    const FrameInput& frame = values.frame;
    switch (write.builtin) {
        case Builtin::none:
            return 0;
        case Builtin::valid:
            if (frame.hides_history) return 0;
            return values.resources.rings().valid(write.resource, values.resources.frame()) ? 1 : 0;
        case Builtin::unit_valid:
        case Builtin::unit_bits:
            return values.validity != nullptr ? values.validity->value(pass, write, component) : 0;
        case Builtin::frame_index:
            return static_cast<double>(frame.frame_index);
        case Builtin::time_s:
            return frame.time_s;
        case Builtin::delta_time_s:
            return frame.delta_time_s;
        case Builtin::pre_exposure:
            return frame.pre_exposure;
        case Builtin::prev_pre_exposure:
            return frame.prev_pre_exposure;
        case Builtin::live:
            return values.areas.values()[write.live[component]].x;
        case Builtin::area_size:
        case Builtin::area_uv:
        case Builtin::area_uv_most:
            return area_value(graph, graph.passes[pass].uses[write.use], write.builtin, component,
                              values.areas);
    }
    return 0;
}

uint32_t bits_of(ScalarType scalar, double value) {
    switch (scalar) {
        case ScalarType::f32: {
            const float narrowed = saturated_float(value);
            uint32_t bits = 0;
            std::memcpy(&bits, &narrowed, sizeof bits);
            return bits;
        }
        // The value is converted to 64 bits and then cut to 32 bits, so a frame index wraps at 2^32. A direct
        // conversion of a larger value to 32 bits would overflow.
        case ScalarType::i32:
        case ScalarType::u32:
            return static_cast<uint32_t>(saturated<int64_t>(value));
        case ScalarType::boolean:
            return value != 0 ? 1 : 0;
    }
    return 0;
}

}  // namespace

void write_params(const ResolvedGraph& graph, PassId pass, const FrameValues& values,
                  std::span<std::byte> bytes) {
    std::fill(bytes.begin(), bytes.end(), std::byte{0});
    const PassDecl& decl = graph.passes[pass];
    const std::vector<ParamWrite>& writes =
        decl.variants.empty() ? decl.params : decl.variants[variant_in(decl, values.switches)].params;
    for (const ParamWrite& write : writes) {
        for (uint32_t i = 0; i < write.components; ++i) {
            const double value = write.builtin == Builtin::none
                                     ? write.value[i]
                                     : builtin_value(graph, pass, write, i, values);
            const uint32_t bits = bits_of(write.scalar, value);
            const size_t offset = write.offset_bytes + size_t{i} * sizeof bits;
            assert(offset + sizeof bits <= bytes.size());
            std::memcpy(bytes.data() + offset, &bits, sizeof bits);
        }
    }
}

uint64_t ParamsMemory::lay_out(const Device& device, const FramePlan& plan) {
    uint64_t size_bytes = 0;
    for (const PassId id : plan.schedule.order) {
        const PassDecl& pass = plan.graph.passes[id];
        const bool pushed = pass.params_push && !device.hides_uniforms();
        if (pass.params_bytes == 0 || pushed) {
            blocks_.push_back({});
            continue;
        }
        blocks_.push_back({size_bytes, pass.params_bytes});
        size_bytes += (pass.params_bytes + kUniformAlignmentBytes - 1) / kUniformAlignmentBytes *
                      kUniformAlignmentBytes;
    }
    return size_bytes;
}

uint64_t ParamsMemory::slot_bytes(const Device& device, const FramePlan& plan) {
    return ParamsMemory().lay_out(device, plan);
}

Result<ParamsMemory> ParamsMemory::create(Device& device, const FramePlan& plan) {
    ParamsMemory memory;
    const uint64_t size_bytes = memory.lay_out(device, plan);
    Status made = create_slot_buffers(memory.memory_, device, size_bytes, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
                                      Buffer::Memory::upload, "Params");
    if (!made) return made.take_errors();
    return memory;
}

VkDescriptorBufferInfo ParamsMemory::descriptor(Position position, uint32_t slot) const {
    return {memory_[slot].handle(), blocks_[position].offset_bytes, blocks_[position].size_bytes};
}

void ParamsMemory::write(const FramePlan& plan, const FrameValues& values, uint32_t slot) {
    for (size_t position = 0; position < blocks_.size(); ++position) {
        const Block& block = blocks_[position];
        if (block.size_bytes == 0) continue;
        write_params(plan.graph, plan.schedule.order[position], values,
                     memory_[slot].mapped().subspan(block.offset_bytes, block.size_bytes));
    }
}

}  // namespace weft::vk
