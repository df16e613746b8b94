#include "vulkan/pipelines/params.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "graph/diagnostics/whole_number.h"

namespace weft::vk {
namespace {

// Alignment of each block in bytes: the largest minUniformBufferOffsetAlignment that Vulkan allows.
constexpr uint64_t kUniformAlignmentBytes = 256;

double builtin_value(PassId pass, const ParamWrite& write, uint32_t component, const FrameValues& values) {
    const FrameInput& frame = values.frame;
    switch (write.builtin) {
        case Builtin::none:
            return 0;
        case Builtin::valid:
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
    for (const ParamWrite& write : graph.passes[pass].params) {
        for (uint32_t i = 0; i < write.components; ++i) {
            const double value =
                write.builtin == Builtin::none ? write.value[i] : builtin_value(pass, write, i, values);
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
