// Purpose: tests what a program and a graph share: images and buffers of the program, resources of the graph
// that the program uses, and draw lists of the program.
#include <array>
#include <cstring>

#include "tests/render/engine/engine_fixture.h"
#include "tests/render/engine/triangle_list.h"
#include "vulkan/device/immediate_submit.h"

namespace weft::test {
namespace {

const std::string kOwnGraph = WEFT_SOURCE_DIR "/tests/render/engine/own.json";
constexpr AccessState kSampled{stage::kFragmentShader | stage::kComputeShader, access::kSampledRead,
                               Layout::shader_read_only};
constexpr AccessState kCopied{stage::kCopy, access::kTransferRead, Layout::transfer_src};
constexpr AccessState kWeightsRead{stage::kComputeShader, access::kStorageRead, Layout::undefined};

class EngineImports : public EngineTest {
 protected:
    vk::Image image(Extent3D extent, UsageMask usage, float fill) {
        ResourceDecl decl;
        decl.name = "own";
        decl.format = Format::rgba32f;
        decl.extent = extent;
        decl.usage = usage | usage::kTransferDst;
        Result<vk::Image> made = vk::Image::create(*device_, decl);
        EXPECT_TRUE(made);
        const std::vector<glm::vec4> texels(extent.width * extent.height, glm::vec4(fill));
        const std::span<const std::byte> level = std::as_bytes(std::span(texels));
        EXPECT_TRUE(vk::upload_image(*device_, *made, {&level, 1}));
        return std::move(*made);
    }
    vk::Buffer weights(float first) {
        Result<vk::Buffer> buffer = vk::Buffer::create(*device_, 8, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                                       vk::Buffer::Memory::upload, "weights");
        EXPECT_TRUE(buffer);
        write(*buffer, first);
        return std::move(*buffer);
    }
    static void write(vk::Buffer& buffer, float first) {
        const std::array values{first, 2.0f};
        std::memcpy(buffer.mapped().data(), values.data(), sizeof values);
    }

    // Copies an image to host memory with commands of the program. The image is in the state that the export
    // declares, and stays in it.
    std::vector<std::byte> copy(const render::ExportedResource& source, uint64_t texel_bytes,
                                VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT) {
        const uint64_t bytes = uint64_t{source.extent.width} * source.extent.height * texel_bytes;
        return read(bytes, [&](VkCommandBuffer commands, VkBuffer to) {
            barrier(commands, source, aspect, source.layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
            VkBufferImageCopy region{};
            region.imageSubresource = {aspect, 0, 0, 1};
            region.imageExtent = source.extent;
            device_->fn().vkCmdCopyImageToBuffer(commands, source.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                                 to, 1, &region);
        });
    }
    template <class Record>
    std::vector<std::byte> read(uint64_t bytes, const Record& record) {
        Result<vk::Buffer> to = vk::Buffer::create(*device_, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                   vk::Buffer::Memory::readback, "copy");
        EXPECT_TRUE(to);
        EXPECT_TRUE(vk::immediate_submit(*device_, "a copy", [&](VkCommandBuffer commands) {
            record(commands, to->handle());
            VkMemoryBarrier2 host{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
            host.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
            host.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
            host.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
            host.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
            VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
            info.memoryBarrierCount = 1;
            info.pMemoryBarriers = &host;
            device_->fn().vkCmdPipelineBarrier2(commands, &info);
        }));
        return {to->mapped().begin(), to->mapped().end()};
    }
    void barrier(VkCommandBuffer commands, const render::ExportedResource& source, VkImageAspectFlags aspect,
                 VkImageLayout from, VkImageLayout to) {
        VkImageMemoryBarrier2 move{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
        move.srcStageMask = source.stages;
        move.srcAccessMask = 0;
        move.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
        move.dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT;
        move.oldLayout = from;
        move.newLayout = to;
        move.srcQueueFamilyIndex = move.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        move.image = source.image;
        move.subresourceRange = {aspect, 0, 1, 0, 1};
        VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
        info.imageMemoryBarrierCount = 1;
        info.pImageMemoryBarriers = &move;
        device_->fn().vkCmdPipelineBarrier2(commands, &info);
    }
};

TEST_F(EngineImports, ExportedResourcesHaveTheContentOfTheFrame) {
    render::SessionInput input = input_for(kEngineGraph, {"place", "glass"});
    input.request.exports = {{"unused", {Access::copy_read}}, {"place", {}}, {"lights", {Access::copy_read}}};
    const auto session = open(squares({{"a", 0, 0, glm::mat4(1)}}), input);
    ASSERT_TRUE(session);
    for (int i = 0; i < 3; ++i) {
        frame_of(*session).camera.transform = moved(0.1f * static_cast<float>(i), 0, 6);
        const EngineFrame frame = render_one(*session);
        const auto place = session->exported("place"), unused = session->exported("unused"),
                   lights = session->exported("lights");
        ASSERT_TRUE(place && unused && lights);
        EXPECT_EQ(place->layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        EXPECT_EQ(place->format, VK_FORMAT_R32G32B32A32_SFLOAT);
        EXPECT_EQ(place->extent.width, kEngineSize.width);
        EXPECT_EQ(unused->layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        EXPECT_EQ(unused->stages, VK_PIPELINE_STAGE_2_COPY_BIT);
        const std::vector<std::byte> spare = read(8 * 16, [&](VkCommandBuffer commands, VkBuffer to) {
            VkBufferImageCopy region{};
            region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
            region.imageExtent = unused->extent;
            device_->fn().vkCmdCopyImageToBuffer(commands, unused->image, unused->layout, to, 1, &region);
        });
        EXPECT_EQ(render::decode_texels(Format::rgba32f, spare)[5], glm::vec4(5, 1, 2, 3));
        const std::vector<std::byte> listed =
            read(sizeof(shared::Light), [&](VkCommandBuffer commands, VkBuffer to) {
                const VkBufferCopy region{0, 0, sizeof(shared::Light)};
                device_->fn().vkCmdCopyBuffer(commands, lights->buffer, to, 1, &region);
            });
        shared::Light light{};
        std::memcpy(&light, listed.data(), sizeof light);
        EXPECT_EQ(light.type, shared::kLightDirectional);
        EXPECT_TRUE(copy(*place, 16) == frame.images.at("place"));
    }
    EXPECT_FALSE(session->exported("glass")) << "the program does not export it";
    const VkImage old = session->exported("place")->image;
    Diagnostics warnings;
    ASSERT_TRUE(session->resize({24, 16, 1}, warnings));
    render_one(*session);
    EXPECT_EQ(session->exported("place")->extent.width, 24u);
    EXPECT_NE(session->exported("place")->image, old);
}

TEST_F(EngineImports, WithoutAnExportAnUnusedPassIsRemoved) {
    const auto session = open(squares({{"a", 0, 0, glm::mat4(1)}}), false);
    ASSERT_TRUE(session);
    const FramePlan& plan = session->plan();
    EXPECT_FALSE(plan.live.live_passes[find_pass(plan.graph, "spare")]);
    EXPECT_FALSE(session->exported("unused"));
}

TEST_F(EngineImports, AResourceThatCannotBeExportedIsReported) {
    for (const char* name : {"trail", "outline", "backbuffer", "places"}) {
        render::SessionInput input = input_for(kEngineGraph, {});
        input.request.exports = {{name, {Access::storage_read_write}}};
        const auto session = render::Session::create(*device_, squares({}), input, warnings_);
        ASSERT_FALSE(session) << name;
        ASSERT_EQ(session.errors().size(), 1u) << to_text(session.errors());
        EXPECT_EQ(session.errors().front().code, "W243") << name;
        EXPECT_FALSE(session.errors().front().help.empty()) << name;
    }
}

TEST_F(EngineImports, AProgramBringsItsOwnDrawsImagesAndBuffersWithoutAScene) {
    const TriangleList triangle(*device_);
    vk::Image paint = image({4, 4, 1}, usage::kSampled, 0.5f), wide = image({8, 2, 1}, usage::kSampled, 4);
    vk::Image canvas = image({16, 8, 1}, usage::kStorage | usage::kTransferSrc | usage::kSampled, 0);
    std::array<vk::Buffer, vk::kFramesInFlight> slots{weights(1), weights(1)};
    render::SessionInput input = input_for(kOwnGraph, {"drawn", "held"});
    input.draw_lists["triangles"] = {&triangle, {{16}, {{"corner", Format::rgba32f, 0, 0}}}};
    input.draw_sets[2] = {triangle.layout(),
                          {{2, 0, BindingKind::uniform_buffer, stage_bit(ShaderStage::fragment), 16, false}}};
    input.imports["paint"] =
        render::own_image(paint.handle(), Format::rgba32f, {4, 4, 1}, usage::kSampled, kSampled);
    input.imports["paint"].decl.read_only = true;
    input.imports["canvas"] =
        render::own_image(canvas.handle(), Format::rgba32f, {16, 8, 1},
                          usage::kStorage | usage::kTransferSrc | usage::kSampled, kCopied);
    input.imports["canvas"].decl.resource.import->entry.layout = Layout::undefined;
    input.imports["weights"] = render::own_buffer(VK_NULL_HANDLE, 8, 4, usage::kStorage, kWeightsRead);
    input.imports["weights"].decl.read_only = true;
    for (size_t slot = 0; slot < slots.size(); ++slot)
        input.imports["weights"].object.slot_buffers[slot] = slots[slot].handle();

    Result<std::unique_ptr<render::Session>> made = render::Session::create(*device_, input, warnings_);
    ASSERT_TRUE(made) << to_text(made.errors());
    render::Session& session = **made;
    render::FrameInput& frame = frame_of(session);
    frame = {.camera = front_camera()};
    frame.import_versions["weights"] = 1;
    const auto canvas_texel = [&](size_t i) {
        render::ExportedResource source;
        source.image = canvas.handle();
        source.extent = {16, 8, 1};
        source.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        source.stages = VK_PIPELINE_STAGE_2_COPY_BIT;
        return render::decode_texels(Format::rgba32f, copy(source, 16))[i];
    };

    EngineFrame drawn = render_one(session);
    const glm::vec4 tint = render::decode_texels(Format::rgba8, drawn.images.at("drawn"))[0];
    EXPECT_LT(glm::length(tint - TriangleList::kTint), 0.01f);
    EXPECT_EQ(triangle.targets.color_count, 1u);
    EXPECT_EQ(triangle.targets.colors[0], VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_EQ(triangle.targets.depth, VK_FORMAT_D32_SFLOAT);
    EXPECT_EQ(triangle.targets.extent.width, kEngineSize.width);
    EXPECT_EQ(triangle.seen.view_projection, session.parts().frames.view().view_projection);
    EXPECT_EQ(texels(drawn, "held")[0], glm::vec4(1, 2, 0, 0));
    EXPECT_LT(glm::length(canvas_texel(3) - (tint + 0.5f)), 1e-6f);

    // The pass at rest sees a new content of the buffer when its version changes.
    EXPECT_EQ(render_one(session).woken, std::set<std::string>());
    std::vector<uint32_t> filled;
    frame.fill_slot = [&](uint32_t slot) {
        write(slots[slot], 7);
        filled.push_back(slot);
    };
    frame.import_versions["weights"] = 2;
    drawn = render_one(session);
    EXPECT_EQ(filled, std::vector<uint32_t>{0}) << "the third frame";
    EXPECT_EQ(drawn.woken, std::set<std::string>{"weigh"});
    EXPECT_EQ(texels(drawn, "held")[0], glm::vec4(7, 2, 0, 0));

    // Another image, of another size, without a new session.
    Diagnostics warnings;
    const Status rebound = session.rebind("paint", {.image = wide.handle()}, {{8, 2, 1}}, warnings);
    ASSERT_TRUE(rebound) << to_text(rebound.errors());
    drawn = render_one(session);
    EXPECT_EQ(texels(drawn, "held")[0], glm::vec4(7, 2, 0, 0)) << "kept content moves to the new plan";
    EXPECT_LT(glm::length(canvas_texel(3) - (tint + 4.0f)), 1e-6f);
    EXPECT_EQ(session.pipelines_made_between_frames(), 0u);
    EXPECT_EQ(code_of(session.rebind("weight", {}, {}, warnings)), "W245");
    made->reset();
}

TEST_F(EngineImports, NamesOfOtherImportsAreTaken) {
    const TriangleList triangle(*device_);
    const auto error_of = [&](const render::SessionInput& input) {
        const auto session =
            render::Session::create(*device_, squares({{"a", 0, 0, glm::mat4(1)}}), input, warnings_);
        EXPECT_FALSE(session);
        return session ? std::string() : session.errors().front().code;
    };
    render::SessionInput input = input_for(kEngineGraph, {});
    input.draw_lists["opaque"] = {&triangle, {{16}, {{"corner", Format::rgba32f, 0, 0}}}};
    EXPECT_EQ(error_of(input), "W245");
    input.draw_lists.clear();
    input.imports["instances"] = render::own_buffer(VK_NULL_HANDLE, 8, 4, usage::kStorage, kWeightsRead);
    EXPECT_EQ(error_of(input), "W245");
    input.imports.clear();
    input.imports["pictures"] = render::own_buffer(VK_NULL_HANDLE, 8, 4, usage::kStorage, kWeightsRead);
    input.textures["pictures"] = {VK_NULL_HANDLE};
    EXPECT_EQ(error_of(input), "W245") << "the program has a table of this name";
    input.imports.clear();
    input.textures.clear();
    input.draw_sets[2] = {triangle.layout(), {}};
    EXPECT_EQ(error_of(input), "W246");
}

}  // namespace
}  // namespace weft::test
