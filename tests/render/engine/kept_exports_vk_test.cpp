// Purpose: tests that a program reads, in its own command buffers between frames, resources of the graph that
// keep their content: the frames after its reads do not overwrite what it still reads, and continue with the
// content.
#include <cstring>

#include "graph/rest/batch_order.h"
#include "tests/render/embedding/own_commands.h"
#include "tests/render/engine/engine_fixture.h"
#include "weft/vulkan/memory.h"

namespace weft::test {
namespace {

const std::string kKeptGraph = WEFT_SOURCE_DIR "/tests/render/engine/kept.json";

// Copies exports to host memory, without a barrier and without a wait: the export is in the state of the
// copy.
class ExportReader {
 public:
    explicit ExportReader(vk::Device& device) : device_(device), commands_(device) {}

    // Submits a copy of the first texels of one layer, or of the words of a buffer.
    void read(const std::string& key, const render::ExportedResource& from, uint32_t layer = 0) {
        Result<vk::Buffer> to = vk::Buffer::create(device_, kBytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                   vk::Buffer::Memory::readback, "copy of an export");
        ASSERT_TRUE(to) << to_text(to.errors());
        const VkCommandBuffer commands = commands_.begin().commands;
        if (from.image != VK_NULL_HANDLE) {
            VkBufferImageCopy region{};
            region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, layer, 1};
            // The last texel of the layer.
            region.imageOffset = {static_cast<int32_t>(from.extent.width) - 1,
                                  static_cast<int32_t>(from.extent.height) - 1, 0};
            region.imageExtent = {1, 1, 1};
            device_.fn().vkCmdCopyImageToBuffer(commands, from.image, from.layout, to->handle(), 1, &region);
        } else {
            const VkBufferCopy region{0, 0, kBytes};
            device_.fn().vkCmdCopyBuffer(commands, from.buffer, to->handle(), 1, &region);
        }
        commands_.submit();
        copies_.insert_or_assign(key, std::move(*to));
    }
    // Returns what was copied. The device must be idle.
    template <class T>
    [[nodiscard]] T value(const std::string& key) const {
        T found{};
        static_assert(sizeof found <= kBytes);
        std::memcpy(&found, copies_.at(key).mapped().data(), sizeof found);
        return found;
    }

 private:
    static constexpr uint64_t kBytes = 16;

    vk::Device& device_;
    OwnCommands commands_;
    std::map<std::string, vk::Buffer> copies_;
};

class KeptExportsVk : public EngineTest {
 protected:
    render::SessionInput input_with(std::map<std::string, ExportUse> exports) {
        render::SessionInput input = input_for(kKeptGraph, {});
        input.request.exports = std::move(exports);
        return input;
    }
    void frame(render::Session& session) {
        const Status drawn = draw_frame(session);
        ASSERT_TRUE(drawn) << to_text(drawn.errors());
    }
    void idle() { ASSERT_EQ(device_->fn().vkDeviceWaitIdle(device_->handle()), VK_SUCCESS); }
    // Copies exports between ten frames without waiting for the GPU, and compares the copies at the end.
    void copy_between_frames();
};

void KeptExportsVk::copy_between_frames() {
    ExportReader reader(*device_);
    const auto session = open(scene::Scene{}, input_with({{"sum", {Access::copy_read}},
                                                          {"trail", {Access::copy_read}},
                                                          {"table", {Access::copy_read}},
                                                          {"count", {Access::copy_read}}}));
    ASSERT_TRUE(session);
    EXPECT_EQ(BatchOrder(session->plan()).awaits_program(), queues_ > 1) << "another queue writes the sum";
    Diagnostics warnings;
    constexpr uint32_t kFrames = 10;
    std::set<VkImage> trails;
    for (uint32_t i = 0; i < kFrames; ++i) {
        // The contents survive a resize and another graph: both make a new plan while frames are in flight.
        if (i == 4) {
            const Status resized = session->resize({24, 16, 1}, warnings);
            ASSERT_TRUE(resized) << to_text(resized.errors());
        }
        if (i == 7) {
            render::Selection other = session->selection();
            other.request.observed = {"sum"};
            render::PrepareResult next = session->prepare(other);
            ASSERT_TRUE(next.result) << to_text(next.result.errors());
            ASSERT_TRUE(session->swap_in(std::move(*next.result)));
        }
        frame(*session);
        const std::string key = " after frame " + std::to_string(i);
        const auto sum = session->exported("sum"), trail = session->exported("trail"),
                   table = session->exported("table"), count = session->exported("count");
        ASSERT_TRUE(sum && trail && table && count);
        EXPECT_EQ(sum->extent.width, i < 4 ? kEngineSize.width : 24u);
        EXPECT_EQ(sum->layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        EXPECT_EQ(sum->stages, VK_PIPELINE_STAGE_2_COPY_BIT);
        EXPECT_EQ(table->layout, VK_IMAGE_LAYOUT_GENERAL) << "a pass samples it, and its writer rests";
        EXPECT_EQ(table->layers, 2u);
        EXPECT_EQ(count->size_bytes, 16u);
        if (i < 4) trails.insert(trail->image);
        // The program need not read each export after each frame.
        if (i % 3 != 1) reader.read("sum" + key, *sum);
        reader.read("trail" + key, *trail);
        if (i % 2 == 0) reader.read("table" + key, *table, 1);
        reader.read("count" + key, *count);
    }
    idle();
    EXPECT_EQ(trails.size(), 3u) << "a history of two frames has three copies";
    for (uint32_t i = 0; i < kFrames; ++i) {
        const std::string key = " after frame " + std::to_string(i);
        const auto frames = static_cast<float>(i + 1);
        if (i % 3 != 1) {
            EXPECT_EQ(reader.value<glm::vec4>("sum" + key), frames * glm::vec4(1, 2, 3, 4)) << key;
        }
        EXPECT_EQ(reader.value<glm::vec4>("trail" + key), glm::vec4(static_cast<float>(i / 2 + 1))) << key;
        if (i % 2 == 0) {
            EXPECT_EQ(reader.value<glm::vec4>("table" + key), glm::vec4(2, 7, 7, 1)) << key;
        }
        EXPECT_EQ(reader.value<glm::uvec4>("count" + key), glm::uvec4(0, i + 1, 0, 0)) << key;
    }
}

TEST_F(KeptExportsVk, AProgramCopiesThemBetweenTenFramesWithoutAWait) {
    copy_between_frames();
}

TEST_F(KeptExportsVk, TheSameOnThreeQueues) {
    queues_ = 3;
    make_device(true);
    copy_between_frames();
}

TEST_F(KeptExportsVk, AViewOfTheExportShowsWhatAPassAtRestHasWritten) {
    const auto session = open(
        scene::Scene{}, input_with({{"table", {Access::sampled_read}}, {"trail", {Access::sampled_read}}}));
    ASSERT_TRUE(session);
    const EngineFrame first = render_one(*session), second = render_one(*session);
    EXPECT_TRUE(first.woken.contains("fill"));
    EXPECT_EQ(second.woken, std::set<std::string>());
    const auto table = session->exported("table");
    ASSERT_TRUE(table);
    EXPECT_NE(table->view, VK_NULL_HANDLE);
    EXPECT_EQ(table->layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL) << "all readers sample the table";
    EXPECT_FALSE(session->exported("sum")) << "the program does not export it";
    EXPECT_NE(session->exported("trail")->view, VK_NULL_HANDLE);
}

// Then only a chain of two barriers orders the writes of two frames.
TEST_F(KeptExportsVk, TheProgramNeedNotReadItsExports) {
    for (const ExportUse& use : {ExportUse{Access::copy_read}, ExportUse{Access::sampled_read}}) {
        const bool copied = use.access == Access::copy_read;
        OwnCommands own(*device_);  // Outlives the session, which waits for the tickets.
        const auto session =
            open(scene::Scene{}, input_with({{"sum", use},
                                             {"trail", use},
                                             {"table", use},
                                             {"count", {copied ? use.access : Access::storage_read}}}));
        ASSERT_TRUE(session);
        for (uint32_t i = 0; i < 6; ++i) {
            // The commands of two frames are in one command buffer.
            if (i % 2 == 0) frame_of(*session).submit = own.begin();
            frame_of(*session).parameters["weight"] = i;  // The table is written in each frame.
            frame(*session);
            if (i % 2 == 1) own.submit();
        }
        idle();
    }
}

// Frames in command buffers of the program, with the program's copies in the same command buffer.
TEST_F(KeptExportsVk, TheFrameAndTheCopiesAreInOneCommandBuffer) {
    OwnCommands own(*device_);  // Outlives the session, which waits for the tickets.
    const auto session = open(scene::Scene{}, input_with({{"count", {Access::copy_read}}}));
    ASSERT_TRUE(session);
    Result<vk::Buffer> to = vk::Buffer::create(*device_, 40, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                               vk::Buffer::Memory::readback, "counts");
    ASSERT_TRUE(to);
    constexpr uint32_t kFrames = 10;
    for (uint32_t i = 0; i < kFrames; i += 2) {
        frame_of(*session).submit = own.begin();
        frame(*session);
        const auto copy = [&](uint32_t index) {
            const VkBufferCopy region{4, VkDeviceSize{index} * 4, 4};
            device_->fn().vkCmdCopyBuffer(frame_of(*session).submit.commands,
                                          session->exported("count")->buffer, to->handle(), 1, &region);
        };
        copy(i);
        own.submit();
        frame_of(*session).submit = {};
        frame(*session);
    }
    idle();
    for (uint32_t i = 0; i < kFrames; i += 2) {
        uint32_t count = 0;
        std::memcpy(&count, to->mapped().data() + size_t{i} * 4, sizeof count);
        EXPECT_EQ(count, i + 1);
    }
}

}  // namespace
}  // namespace weft::test
