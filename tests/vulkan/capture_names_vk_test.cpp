// Purpose: tests the names that capture tools such as RenderDoc show: each pass has a label in the command
// buffer, and objects are named after resources.
#include <algorithm>
#include <set>

#include "tests/vulkan/executor_fixture.h"
#include "vulkan/device/functions.h"

namespace weft::vk {
namespace {

// Calls recorded by the functions below, which replace Vulkan functions. The data are global, because plain
// functions cannot receive an object of the test.
struct Recorded {
    // Names of the labels in the order of recording; an empty text marks the end of a label.
    std::vector<std::string> labels;
    // Names that were given to images.
    std::set<std::string> images;
};
Recorded& recorded() {
    static Recorded all;
    return all;
}

VKAPI_ATTR void VKAPI_CALL begin_label(VkCommandBuffer, const VkDebugUtilsLabelEXT* label) {
    recorded().labels.emplace_back(label->pLabelName);
}
VKAPI_ATTR void VKAPI_CALL end_label(VkCommandBuffer) {
    recorded().labels.emplace_back();
}
VKAPI_ATTR VkResult VKAPI_CALL name_object(VkDevice, const VkDebugUtilsObjectNameInfoEXT* info) {
    if (info->objectType == VK_OBJECT_TYPE_IMAGE) recorded().images.emplace(info->pObjectName);
    return VK_SUCCESS;
}

using CaptureNamesVk = ExecutorTest;

TEST_F(CaptureNamesVk, passes_are_labelled_and_images_named) {
    auto& functions = const_cast<InstanceFunctions&>(device().instance_fn());
    functions.vkCmdBeginDebugUtilsLabelEXT = begin_label;
    functions.vkCmdEndDebugUtilsLabelEXT = end_label;
    functions.vkSetDebugUtilsObjectNameEXT = name_object;
    recorded() = {};
    test::GraphBuilder builder;
    const ResourceId from = builder.image("from", Format::rgba8, 5),
                     to = builder.image("to", Format::rgba8, 5);
    builder.pass("fill", PassKind::clear, {{"dst", from, Access::clear_write, {}, kNoId}});
    builder.pass("duplicate", PassKind::copy,
                 {{"src", from, Access::copy_read, {}, kNoId}, {"dst", to, Access::copy_write, {}, kNoId}});
    builder.pass("read", PassKind::readback, {{"src", to, Access::copy_read, {}, kNoId}});
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    ASSERT_EQ(run_frames(*executor, 1).size(), 1u);
    EXPECT_EQ(recorded().images, (std::set<std::string>{"from", "to"}));
    std::vector<std::string> labels = recorded().labels;
    EXPECT_EQ(std::ranges::count(labels, ""), static_cast<std::ptrdiff_t>(labels.size() / 2))
        << "each one ends";
    std::erase(labels, "");
    for (const char* pass : {"fill", "duplicate", "read"})
        EXPECT_EQ(std::ranges::count(labels, pass), 1) << pass;
}

}  // namespace
}  // namespace weft::vk
