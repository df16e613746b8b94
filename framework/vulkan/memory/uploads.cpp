#include "vulkan/memory/uploads.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "vulkan/device/functions.h"
#include "vulkan/device/to_vk.h"
#include "vulkan/memory/places.h"

namespace weft::vk {
namespace {

// Returns the index in `places` of the upload memory of `port`; nothing if the port has none.
std::optional<size_t> find_place(const std::vector<UploadPlace>& places, std::string_view port) {
    for (size_t n = 0; n < places.size(); ++n)
        if (places[n].port == port) return n;
    return std::nullopt;
}

class SlotUploads final : public Uploads {
 public:
    SlotUploads(const std::vector<UploadPlace>& places, std::vector<uint64_t>& filled_bytes,
                std::span<std::byte> memory, TurnLists& turns)
        : places_(places), filled_bytes_(filled_bytes), memory_(memory), turns_(turns) {}

    void put(std::string_view port, std::span<const std::byte> bytes) override {
        const std::optional<size_t> n = find_place(places_, port);
        if (!n) return;
        const UploadPlace& place = places_[*n];
        const uint64_t kept = std::min<uint64_t>(bytes.size(), place.capacity_bytes);
        if (kept != 0) std::memcpy(memory_.data() + place.offset_bytes, bytes.data(), kept);
        filled_bytes_[*n] = kept;
    }
    [[nodiscard]] uint64_t capacity(std::string_view port) const override {
        const std::optional<size_t> n = find_place(places_, port);
        return n ? places_[*n].capacity_bytes : 0;
    }
    void set_turns(std::string_view import, std::span<const uint32_t> rounds) override {
        turns_.insert_or_assign(std::string(import), std::vector<uint32_t>(rounds.begin(), rounds.end()));
    }

 private:
    const std::vector<UploadPlace>& places_;
    std::vector<uint64_t>& filled_bytes_;
    std::span<std::byte> memory_;
    TurnLists& turns_;
};

class CommandRecorder final : public RawRecorder {
 public:
    struct Target {
        const Device& device;
        const RawCommands& raw;
        const PassDecl& pass;
        const FrameResources& resources;
        const std::vector<UploadPlace>& places;
        const std::vector<uint64_t>& filled_bytes;
        VkBuffer memory;
    };
    explicit CommandRecorder(Target target) : target_(target) {}

    [[nodiscard]] const RawCommands& raw() const override { return target_.raw; }

    void copy_upload(std::string_view port) override {
        const std::optional<size_t> n = find_place(target_.places, port);
        if (!n) return;
        const UploadPlace& place = target_.places[*n];
        const uint64_t bytes = target_.filled_bytes[*n];
        if (bytes == 0) return;
        const UseDecl& use = target_.pass.uses[place.use];
        const DeviceFunctions& fn = target_.device.fn();
        if (place.regions.copies.empty()) {
            const VkBufferCopy copy{place.offset_bytes, place.target.offset_bytes, bytes};
            fn.vkCmdCopyBuffer(target_.raw.commands, target_.memory, target_.resources.buffer(use.resource),
                               1, &copy);
            return;
        }
        fn.vkCmdCopyBufferToImage(target_.raw.commands, target_.memory, target_.resources.image(use.resource),
                                  to_vk(use.state.layout), static_cast<uint32_t>(place.regions.copies.size()),
                                  place.regions.copies.data());
    }
    void fill_buffer(std::string_view port, uint32_t word) override {
        for (const UseDecl& use : target_.pass.uses) {
            const VkBuffer buffer = target_.resources.buffer(use.resource);
            if (use.port != port || !use.is_output || buffer == VK_NULL_HANDLE) continue;
            const ByteRange bytes = use.bytes.value_or(ByteRange{0, VK_WHOLE_SIZE});
            target_.device.fn().vkCmdFillBuffer(target_.raw.commands, buffer, bytes.offset_bytes,
                                                bytes.size_bytes, word);
        }
    }

 private:
    Target target_;
};

UploadPlace make_place(const FramePlan& plan, const PassDecl& pass, uint32_t use_index,
                       uint64_t offset_bytes) {
    const UseDecl& use = pass.uses[use_index];
    const ResourceDecl& decl = plan.graph.resources[use.resource];
    const ByteRange target = used_bytes(decl, use);
    UploadPlace place{use.port, use_index, offset_bytes, target.size_bytes, target, {}};
    if (decl.kind == ResourceKind::image) {
        place.regions = image_regions(decl, use.range, offset_bytes);
        place.capacity_bytes = place.regions.staging_bytes;
    }
    return place;
}

}  // namespace

uint64_t UploadMemory::lay_out(const FramePlan& plan) {
    uint64_t size_bytes = 0;
    places_.resize(plan.schedule.order.size());
    for (Position position(0); position < plan.schedule.order.size(); ++position) {
        const PassDecl& pass = plan.graph.passes[plan.schedule.order[position]];
        if (pass.kind != PassKind::custom) continue;
        for (uint32_t use = 0; use < pass.uses.size(); ++use) {
            if (pass.uses[use].access != Access::copy_write) continue;
            size_bytes = aligned_place(size_bytes);
            places_[position].push_back(make_place(plan, pass, use, size_bytes));
            size_bytes += places_[position].back().capacity_bytes;
        }
    }
    return size_bytes;
}

Result<UploadMemory> UploadMemory::create(Device& device, const FramePlan& plan) {
    UploadMemory memory;
    const uint64_t size_bytes = memory.lay_out(plan);
    for (auto& slot : memory.filled_bytes_)
        for (const auto& places : memory.places_) slot.emplace_back(places.size(), 0);
    Status made = create_slot_buffers(memory.memory_, device, size_bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                      Buffer::Memory::upload, "uploads");
    if (!made) return made.take_errors();
    return memory;
}

void UploadMemory::prepare(Position position, const PassType& type, const PassDecl& pass,
                           const HostInputs& host, uint32_t slot, TurnLists& turns) {
    std::vector<uint64_t>& filled = filled_bytes_[slot][position];
    std::fill(filled.begin(), filled.end(), 0);
    SlotUploads uploads(places_[position], filled, memory_[slot].mapped(), turns);
    if (type.prepare != nullptr) type.prepare(PassContext{pass.custom_params}, host, uploads);
}

void UploadMemory::record(const RawCommands& raw, const Recorded& recorded,
                          const FrameResources& resources) const {
    const auto& [device, position, type, pass, slot] = recorded;
    CommandRecorder recorder({device, raw, pass, resources, places_[position], filled_bytes_[slot][position],
                              memory_[slot].handle()});
    if (type.record != nullptr) type.record(PassContext{pass.custom_params}, recorder);
}

}  // namespace weft::vk
