#include "tests/vulkan/plan_runner.h"

#include <gtest/gtest.h>

#include <cstring>
#include <span>

#include "vulkan/device/functions.h"
#include "vulkan/device/immediate_submit.h"
#include "weft/shader/compile_shader.h"

namespace weft::vk {
namespace {

// Returns pseudo-random content for the import `name`. The same name and size always give the same content,
// so that the results of two plans can be compared.
std::vector<std::byte> content_of(const std::string& name, uint64_t size_bytes) {
    uint32_t state = 2166136261u;
    for (const char c : name) state = (state ^ static_cast<unsigned char>(c)) * 16777619u;
    std::vector<std::byte> bytes(size_bytes);
    for (size_t i = 0; i + sizeof state <= bytes.size(); i += sizeof state) {
        state = state * 1664525u + 1013904223u;
        std::memcpy(bytes.data() + i, &state, sizeof state);
    }
    return bytes;
}

// Records a barrier: all earlier work ends before `stage`, and its writes are visible to `access`.
void order_copy(const Device& device, VkCommandBuffer commands, VkPipelineStageFlags2 stage,
                VkAccessFlags2 access) {
    VkMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = stage;
    barrier.dstAccessMask = access;
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &barrier;
    device.fn().vkCmdPipelineBarrier2(commands, &info);
}

std::vector<std::byte> read_buffer(Device& device, const Buffer& buffer) {
    Result<Buffer> target = Buffer::create(device, buffer.size_bytes(), VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                           Buffer::Memory::readback, "import readback");
    if (!target) {
        ADD_FAILURE() << to_text(target.errors());
        return {};
    }
    const Status read = immediate_submit(device, "reading an import", [&](VkCommandBuffer commands) {
        order_copy(device, commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
        const VkBufferCopy copy{0, 0, buffer.size_bytes()};
        device.fn().vkCmdCopyBuffer(commands, buffer.handle(), target->handle(), 1, &copy);
        order_copy(device, commands, VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
    });
    if (!read) ADD_FAILURE() << to_text(read.errors());
    return {target->mapped().begin(), target->mapped().end()};
}

}  // namespace

const ShaderCatalog& TestShaders::for_graph(const ResolvedGraph& graph) {
    ShaderRoots roots;
    roots.roots = {WEFT_SOURCE_DIR "/tests/graph/shaders"};
    roots.include_root = WEFT_SOURCE_DIR "/shaders/include";
    for (const PassDecl& pass : graph.passes) {
        if (pass.shader.empty() || catalog_.contains(pass.shader)) continue;
        const ProgramKind kind =
            pass.kind == PassKind::compute ? ProgramKind::compute : ProgramKind::fullscreen;
        Result<ShaderProgram> made = compile_shader(pass.shader, kind, roots);
        if (made)
            catalog_.emplace(pass.shader, std::move(*made));
        else
            ADD_FAILURE() << to_text(made.errors());
    }
    return catalog_;
}

TestImports::TestImports(Device& device, const ResolvedGraph& graph) : device_(&device) {
    for (const ResourceDecl& decl : graph.resources)
        if (decl.lifetime == ResourceLifetime::imported) make(decl);
}

void TestImports::make(const ResourceDecl& decl) {
    ResourceDecl own = decl;
    // After an upload the image has the layout shader_read_only, which requires the usage kSampled.
    own.usage |= usage::kTransferSrc | usage::kTransferDst | usage::kSampled;
    const std::vector<std::byte> content = content_of(decl.name, content_bytes(decl));
    Status filled = Unit{};
    if (decl.kind == ResourceKind::buffer) {
        Result<Buffer> made = Buffer::create(*device_, decl.size_bytes, buffer_create_info(own).usage,
                                             Buffer::Memory::device, decl.name);
        ASSERT_TRUE(made.ok()) << to_text(made.errors());
        filled = upload_buffer(*device_, *made, content);
        buffers_.emplace(decl.name, std::move(*made));
    } else {
        ASSERT_EQ(decl.mips, 1u) << "imports of tests have one mip";
        Result<Image> made = Image::create(*device_, own);
        ASSERT_TRUE(made.ok()) << to_text(made.errors());
        const std::span<const std::byte> level = content;
        filled = upload_image(*device_, *made, {&level, 1});
        images_.emplace(decl.name, std::move(*made));
    }
    ASSERT_TRUE(filled.ok()) << to_text(filled.errors());
}

ImportBindings TestImports::bindings() const {
    ImportBindings bound;
    for (const auto& [name, buffer] : buffers_) bound.buffers.emplace(name, buffer.handle());
    for (const auto& [name, image] : images_) bound.images.emplace(name, &image);
    return bound;
}

std::map<std::string, std::vector<std::byte>> TestImports::buffer_contents() const {
    std::map<std::string, std::vector<std::byte>> contents;
    for (const auto& [name, buffer] : buffers_) contents.emplace(name, read_buffer(*device_, buffer));
    return contents;
}

PlanResult run_plan(Device& device, const FramePlan& plan, TestShaders& shaders, const RunOptions& options) {
    const TestImports imports(device, plan.graph);
    ExecutorInput input;
    input.plan = plan;
    input.shaders = &shaders.for_graph(plan.graph);
    input.bindings = imports.bindings();
    input.hooks = options.hooks;
    input.timestamps = options.timestamps;
    Result<std::unique_ptr<Executor>> executor = Executor::create(device, std::move(input));
    if (!executor) {
        ADD_FAILURE() << to_text(executor.errors());
        return {};
    }
    Status done = Unit{};
    for (uint32_t i = 0; i < options.frames && done; ++i) {
        if (Result<uint32_t> slot = (*executor)->begin_frame(); !slot) {
            done = slot.take_errors();
            break;
        }
        FrameInput frame;
        frame.frame_index = i;
        done = (*executor)->run(frame);
    }
    if (done) done = (*executor)->finish();
    if (!done) {
        ADD_FAILURE() << to_text(done.errors());
        return {};
    }
    return {(*executor)->take_readbacks(), imports.buffer_contents()};
}

}  // namespace weft::vk
