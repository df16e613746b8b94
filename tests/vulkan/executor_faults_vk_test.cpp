// Purpose: tests the errors of an executor: faulty input, failed Vulkan calls, a time-out and a lost device.
// The executor must return a diagnostic and must not leak objects. Most diagnostics must name a pass or an
// import.
#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/triangle_source.h"
#include "vulkan/device/functions.h"
#include "vulkan/device/immediate_submit.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

class ExecutorFaultsVk : public ExecutorTest {
 protected:
    // Makes a graph with a compute pass, a fullscreen pass and a readback, so that the executor creates many
    // kinds of Vulkan objects.
    GraphBuilder make_graph() {
        write_shader("fill.comp", R"(
            layout(local_size_x = 8, local_size_y = 8) in;
            layout(r32ui) uniform writeonly uimage2D dst;
            uniform Params { uint value; } params;
            void main() { imageStore(dst, ivec2(gl_GlobalInvocationID.xy), uvec4(params.value)); })");
        write_shader("pass_on.frag", R"(
            uniform usampler2D src;
            layout(location = 0) out uint dst;
            void main() { dst = texelFetch(src, ivec2(gl_FragCoord.xy), 0).r; })");
        GraphBuilder builder;
        const ResourceId a = builder.image("a", Format::r32u, 8);
        const ResourceId b = builder.image("b", Format::r32u, 8);
        use_shader(builder.compute("fill", {{"dst", a, Access::storage_write, {}, kNoId}}), "fill.comp",
                   ProgramKind::compute);
        use_shader(builder.pass("pass_on", PassKind::fullscreen,
                                {{"src", a, Access::sampled_read, {}, kNoId},
                                 {"dst", b, Access::color_write, {}, kNoId}}),
                   "pass_on.frag", ProgramKind::fullscreen);
        builder.pass("read", PassKind::readback, {{"src", b, Access::copy_read, {}, kNoId}});
        return builder;
    }

    // Expects that the creation of an executor fails with one error, and returns this error.
    Diagnostic fault_of(ExecutorInput input) {
        Result<std::unique_ptr<Executor>> made = Executor::create(device(), std::move(input));
        if (made || made.errors().size() != 1) {
            ADD_FAILURE() << "one error was wanted: " << (made ? "none" : to_text(made.errors()));
            return {};
        }
        return made.errors()[0];
    }
};

bool message_mentions(const Diagnostic& diagnostic, const char* text) {
    return diagnostic.message.find(text) != std::string::npos;
}

TEST_F(ExecutorFaultsVk, a_missing_or_misshapen_import_is_named) {
    GraphBuilder builder;
    const ResourceId image = builder.image("backdrop", Format::r32u, 8);
    const AccessState read{stage::kCopy, access::kTransferRead, Layout::transfer_src};
    builder.import_as(image, read, read);
    builder.pass("read", PassKind::readback, {{"src", image, Access::copy_read, {}, kNoId}});
    const FramePlan plan = compile_plan(builder);
    Diagnostic fault = fault_of(input_for(plan));
    EXPECT_EQ(fault.code, "V414");
    EXPECT_TRUE(message_mentions(fault, "\"backdrop\"")) << fault.message;

    ResourceDecl smaller = plan.graph.resources[find_resource(plan.graph, "backdrop")];
    smaller.extent = {4, 8, 1};
    const Result<Image> other = Image::create(device(), smaller);
    ASSERT_TRUE(other.ok());
    ExecutorInput input = input_for(plan);
    input.bindings.images.emplace("backdrop", &*other);
    fault = fault_of(std::move(input));
    EXPECT_EQ(fault.code, "V414");
    EXPECT_TRUE(message_mentions(fault, "4x8") && message_mentions(fault, "8x8")) << fault.message;
}

TEST_F(ExecutorFaultsVk, what_a_plan_needs_and_is_not_given_is_named) {
    GraphBuilder builder = make_graph();
    const FramePlan plan = compile_plan(builder);
    ExecutorInput input = input_for(plan);
    ShaderCatalog fewer = shaders_;
    fewer.at("fill.comp").modules.clear();
    input.shaders = &fewer;
    Diagnostic fault = fault_of(std::move(input));
    EXPECT_EQ(fault.code, "V417");
    EXPECT_TRUE(message_mentions(fault, "\"fill\"") && message_mentions(fault, "fill.comp")) << fault.message;

    GraphBuilder custom;
    const ResourceId words = custom.buffer("words", 16);
    custom.pass("upload", PassKind::custom, {{"dst", words, Access::copy_write, {}, kNoId}}).side_effect =
        true;
    EXPECT_EQ(fault_of(input_for(compile_plan(custom))).code, "V417");
}

TEST_F(ExecutorFaultsVk, a_draw_source_without_views_in_buffers_is_named) {
    write_shader("seen/seen.vert", "void main() { gl_Position = vec4(0, 0, 0, 1); }");
    write_shader("seen/seen.frag", "layout(location = 0) out vec4 color; void main() { color = vec4(1); }");
    GraphBuilder builder;
    const ResourceId target = builder.image("target", Format::rgba8, 8), views = builder.buffer("views", 512);
    builder.pass("zero", PassKind::clear, {{"dst", views, Access::clear_write, {}, kNoId}});
    PassDecl& draw = builder.pass("draw", PassKind::raster,
                                  {{"views:list", views, Access::uniform_read, {}, kNoId},
                                   {"color", target, Access::color_write, {}, kNoId}});
    draw.vertices = draw.instances = 1;
    draw.view_use = 0;
    draw.side_effect = true;
    use_shader(draw, "seen", ProgramKind::raster);
    const FramePlan plan = compile_plan(builder);
    const TriangleSource source(device());
    for (const DrawSource* draws :
         {static_cast<const DrawSource*>(nullptr), static_cast<const DrawSource*>(&source)}) {
        ExecutorInput input = input_for(plan);
        input.draws = draws;
        const Diagnostic fault = fault_of(std::move(input));
        EXPECT_EQ(fault.code, "V415");
        EXPECT_TRUE(message_mentions(fault, "reads its view from a buffer")) << fault.message;
    }
}

TEST_F(ExecutorFaultsVk, a_draw_list_that_does_not_fit_the_shader_is_named) {
    write_shader("flat/flat.vert", R"(
        layout(location = 0) in vec3 normal;
        layout(set = 2, binding = 0) uniform Material { vec4 color; } material;
        void main() { gl_Position = vec4(normal, material.color.x); })");
    write_shader("flat/flat.frag", "layout(location = 0) out vec4 color; void main() { color = vec4(1); }");
    GraphBuilder builder;
    const ResourceId target = builder.image("target", Format::rgba8, 8);
    PassDecl& draw =
        builder.pass("draw", PassKind::raster, {{"color", target, Access::color_write, {}, kNoId}});
    draw.draw_lists = {"opaque"};
    draw.side_effect = true;
    use_shader(draw, "flat", ProgramKind::raster);
    const FramePlan plan = compile_plan(builder);
    EXPECT_EQ(fault_of(input_for(plan)).code, "V415") << "no draw source at all";

    const TriangleSource source(device());
    ExecutorInput input = input_for(plan);
    input.draws = &source;
    Diagnostic fault = fault_of(std::move(input));
    EXPECT_EQ(fault.code, "V415");
    EXPECT_TRUE(message_mentions(fault, "set 2")) << fault.message;

    write_shader("flat/flat.vert",
                 "layout(location = 0) in vec3 normal; void main() { gl_Position = vec4(normal, 1); }");
    use_shader(draw, "flat", ProgramKind::raster);
    input = input_for(plan);
    input.draws = &source;
    fault = fault_of(std::move(input));
    EXPECT_EQ(fault.code, "V414");
    EXPECT_TRUE(message_mentions(fault, "\"opaque\"")) << fault.message;

    ImportCatalog imports;
    imports.imports.emplace("opaque", TriangleSource::draw_list("opaque"));
    input = input_for(plan);
    input.draws = &source;
    input.imports = &imports;
    Result<std::unique_ptr<Executor>> made = Executor::create(device(), std::move(input));
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.errors()[0].code, "V416");
    EXPECT_TRUE(message_mentions(made.errors()[0], "\"normal\"")) << made.errors()[0].message;
}

VKAPI_ATTR VkResult VKAPI_CALL never_signalled(VkDevice, uint32_t, const VkFence*, VkBool32, uint64_t) {
    return VK_TIMEOUT;
}

VKAPI_ATTR VkResult VKAPI_CALL lost_at_submit(VkQueue, uint32_t, const VkSubmitInfo*, VkFence) {
    return VK_ERROR_DEVICE_LOST;
}

TEST_F(ExecutorFaultsVk, a_frame_that_never_ends_is_a_time_out_that_names_passes) {
    auto executor = executor_for(input_for(compile_plan(make_graph())));
    ASSERT_NE(executor, nullptr);
    ASSERT_TRUE(executor->begin_frame().ok());
    ASSERT_TRUE(executor->run({}).ok());
    const auto wait = std::exchange(device().fn().vkWaitForFences, never_signalled);
    const Status finished = executor->finish();
    const Result<uint32_t> next = executor->begin_frame();
    device().fn().vkWaitForFences = wait;
    ASSERT_FALSE(finished.ok());
    ASSERT_FALSE(next.ok()) << "after a time-out nothing runs any more";
    EXPECT_EQ(finished.errors()[0].code, "V407");
    EXPECT_TRUE(message_mentions(finished.errors()[0], "read")) << finished.errors()[0].message;
    // The frame still runs on the device; only the wait for its fence was made to fail. This submission waits
    // until the frame has ended. Then the executor can be destroyed without leaks.
    ASSERT_TRUE(immediate_submit(device(), "waiting", [](VkCommandBuffer) {}).ok());
}

TEST_F(ExecutorFaultsVk, a_lost_device_names_the_passes_of_the_frame) {
    auto executor = executor_for(input_for(compile_plan(make_graph())));
    ASSERT_NE(executor, nullptr);
    ASSERT_TRUE(executor->begin_frame().ok());
    const auto submit = std::exchange(device().fn().vkQueueSubmit, lost_at_submit);
    const Status ran = executor->run({});
    device().fn().vkQueueSubmit = submit;
    ASSERT_FALSE(ran.ok());
    EXPECT_EQ(ran.errors()[0].code, "V408");
    EXPECT_TRUE(message_mentions(ran.errors()[0], "fill, pass_on, read")) << ran.errors()[0].message;
    EXPECT_FALSE(executor->finish().ok());
}

// Makes one call of a Vulkan function fail: `calls_left` calls succeed, then one call fails. The state is
// global, because Vulkan functions are plain functions without an object.
struct FailingCall {
    uint32_t calls_left = 0;
    DeviceFunctions real{};
};
FailingCall failing;

VkResult next_result() {
    return failing.calls_left-- == 0 ? VK_ERROR_OUT_OF_DEVICE_MEMORY : VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL allocate_memory(VkDevice device, const VkMemoryAllocateInfo* info,
                                               const VkAllocationCallbacks* allocator,
                                               VkDeviceMemory* memory) {
    const VkResult result = next_result();
    return result != VK_SUCCESS ? result : failing.real.vkAllocateMemory(device, info, allocator, memory);
}
VKAPI_ATTR VkResult VKAPI_CALL create_view(VkDevice device, const VkImageViewCreateInfo* info,
                                           const VkAllocationCallbacks* allocator, VkImageView* view) {
    const VkResult result = next_result();
    return result != VK_SUCCESS ? result : failing.real.vkCreateImageView(device, info, allocator, view);
}
VKAPI_ATTR VkResult VKAPI_CALL create_layout(VkDevice device, const VkDescriptorSetLayoutCreateInfo* info,
                                             const VkAllocationCallbacks* allocator,
                                             VkDescriptorSetLayout* layout) {
    const VkResult result = next_result();
    return result != VK_SUCCESS ? result
                                : failing.real.vkCreateDescriptorSetLayout(device, info, allocator, layout);
}
VKAPI_ATTR VkResult VKAPI_CALL create_module(VkDevice device, const VkShaderModuleCreateInfo* info,
                                             const VkAllocationCallbacks* allocator, VkShaderModule* module) {
    const VkResult result = next_result();
    return result != VK_SUCCESS ? result : failing.real.vkCreateShaderModule(device, info, allocator, module);
}
VKAPI_ATTR VkResult VKAPI_CALL create_fence(VkDevice device, const VkFenceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator, VkFence* fence) {
    const VkResult result = next_result();
    return result != VK_SUCCESS ? result : failing.real.vkCreateFence(device, info, allocator, fence);
}

// Makes call 0 fail, then call 1 and so on, until the creation succeeds. Returns the number of failed
// attempts.
template <class Create>
uint32_t fail_each_call(Create create) {
    for (uint32_t n = 0; n < 100; ++n) {
        failing.calls_left = n;
        Result<std::unique_ptr<Executor>> made = create();
        if (made) return n;
        EXPECT_EQ(made.errors()[0].code, "V410") << to_text(made.errors());
    }
    return 100;
}

TEST_F(ExecutorFaultsVk, memory_that_runs_out_anywhere_is_an_error_and_leaks_nothing) {
    const FramePlan plan = compile_plan(make_graph());
    const auto create = [&] { return Executor::create(device(), input_for(plan)); };
    failing.real = device().fn();
    DeviceFunctions& fn = device().fn();
    fn.vkAllocateMemory = allocate_memory;
    EXPECT_GE(fail_each_call(create), 1u + 2 * kFramesInFlight)
        << "the heap, params and readback of every slot";
    fn = failing.real;
    fn.vkCreateImageView = create_view;
    EXPECT_EQ(fail_each_call(create), 2u) << "equal views are made once";
    fn = failing.real;
    fn.vkCreateDescriptorSetLayout = create_layout;
    EXPECT_GE(fail_each_call(create), 2u);
    fn = failing.real;
    fn.vkCreateShaderModule = create_module;
    EXPECT_EQ(fail_each_call(create), 3u);
    fn = failing.real;
    fn.vkCreateFence = create_fence;
    EXPECT_EQ(fail_each_call(create), kFramesInFlight);
    fn = failing.real;
    const auto executor = executor_for(input_for(plan));
    ASSERT_NE(executor, nullptr);
    EXPECT_EQ(run_frames(*executor, 1).size(), 1u) << "the device is as good as new";
}

}  // namespace
}  // namespace weft::vk
