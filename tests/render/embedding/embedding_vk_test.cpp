// Tests a session inside the frame of an engine: other formats and final layouts of the output, several
// sessions on one device, command buffers of the program, and a device that is lost and created again.
#include <algorithm>

#include "tests/render/embedding/own_commands.h"
#include "tests/render/session_fixture.h"
#include "vulkan/device/immediate_submit.h"
#include "vulkan/device/to_vk.h"
#include "weft/vulkan/native.h"
#include "weft/vulkan/shared_pipelines.h"

namespace weft::test {
namespace {

constexpr Extent3D kPictureSize{32, 16, 1};
constexpr const char* kGradient = WEFT_SOURCE_DIR "/tests/render/embedding/gradient.json";
constexpr const char* kStored = WEFT_SOURCE_DIR "/tests/render/embedding/stored.json";
constexpr const char* kTrail = WEFT_SOURCE_DIR "/tests/render/resize/trail.json";
constexpr const char* kMissingPorts = WEFT_SOURCE_DIR "/tests/render/embedding/missing_ports.json";

class EmbeddingVk : public SessionTest {
 protected:
    void SetUp() override {
        SessionTest::SetUp();
        Result<scene::Scene> scene = scene::make_builtin("spheres");
        ASSERT_TRUE(scene);
        scene_ = std::move(*scene);
        passes_ = registered_passes();
    }

    render::SessionInput input_for(const std::string& graph) {
        render::SessionInput input;
        input.request.path = graph;
        input.request.size = kPictureSize;
        input.load.reader = read_text;
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.passes = &passes_;
        input.check_plan = true;
        return input;
    }
    std::unique_ptr<render::Session> open(const render::SessionInput& input) {
        return open_on(*device_, input);
    }
    std::unique_ptr<render::Session> open_on(vk::Device& device, const render::SessionInput& input) {
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(device, scene_, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session) = {.camera = scene::framing_camera(scene_, 2)};
        return std::move(*session);
    }
    Diagnostic fault_of(const render::SessionInput& input) {
        const auto session = render::Session::create(*device_, scene_, input, warnings_);
        EXPECT_FALSE(session);
        return session ? Diagnostic{} : session.errors().front();
    }
    static std::vector<std::byte> picture(render::Session& session) {
        EXPECT_TRUE(session.finish());
        const Result<vk::ReadbackData> data = session.read_output();
        EXPECT_TRUE(data) << to_text(data.errors());
        return data ? data->bytes : std::vector<std::byte>{};
    }
    std::vector<glm::vec4> gradient_in(Format format) {
        SCOPED_TRACE(format_info(format).name);
        render::SessionInput input = input_for(kGradient);
        input.request.output.format = format;
        const std::unique_ptr<render::Session> session = open(input);
        if (!session) return {};
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(draw_frame(*session));
        return render::decode_texels(format, picture(*session));
    }

    scene::Scene scene_;
};

void expect_near(const std::vector<glm::vec4>& found, const std::vector<glm::vec4>& wanted, float most) {
    ASSERT_EQ(found.size(), wanted.size());
    float worst = 0;
    for (size_t i = 0; i < found.size(); ++i)
        for (int c = 0; c < 4; ++c) worst = std::max(worst, std::abs(found[i][c] - wanted[i][c]));
    EXPECT_LE(worst, most);
}

TEST_F(EmbeddingVk, TheOutputMayHaveEveryColourFormat) {
    std::vector<glm::vec4> linear;
    for (uint32_t y = 0; y < kPictureSize.height; ++y)
        for (uint32_t x = 0; x < kPictureSize.width; ++x)
            linear.emplace_back((x + 0.5F) / kPictureSize.width, (y + 0.5F) / kPictureSize.height, 0.25F, 1);
    const std::vector<glm::vec4> encoded = gradient_in(Format::rgba8);
    expect_near(gradient_in(Format::bgra8), encoded, 0);
    expect_near(gradient_in(Format::rgb10a2), encoded, 0.004F);
    // decode_texels() decodes sRGB, so the texels of these formats are linear.
    expect_near(gradient_in(Format::rgba8_srgb), linear, 0.01F);
    expect_near(gradient_in(Format::bgra8_srgb), linear, 0.01F);
    expect_near(gradient_in(Format::rgba16f), linear, 0.001F);
}

TEST_F(EmbeddingVk, AFormatOrLayoutThatIsImpossibleIsAnError) {
    render::SessionInput input = input_for(kGradient);
    input.request.output.format = Format::d32f;
    EXPECT_EQ(fault_of(input).code, "V424");
    input.request.output.format = Format::rgba8;
    input.request.output.final_layout = Layout::transfer_dst;
    EXPECT_EQ(fault_of(input).code, "V424");
    input.request.output = {Format::rgba8, Layout::transfer_src, usage::kTransferSrc};
    EXPECT_EQ(fault_of(input).code, "V424") << "no pass can write it";
    input.request.output = {Format::rgba8, Layout::transfer_src, usage::kColorAttachment};
    EXPECT_EQ(fault_of(input).code, "V424") << "it cannot have the layout of a copy source";
}

TEST_F(EmbeddingVk, AComputePassCannotStoreToAFormatWithoutStorage) {
    render::SessionInput input = input_for(kStored);
    input.request.output.format = Format::rgba16f;
    const std::unique_ptr<render::Session> session = open(input);
    ASSERT_TRUE(session);
    ASSERT_TRUE(draw_frame(*session));
    EXPECT_EQ(render::decode_texels(Format::rgba16f, picture(*session)).front(), glm::vec4(0.5F));

    input.request.output.format = Format::rgba8_srgb;
    Diagnostic fault = fault_of(input);
    EXPECT_EQ(fault.code, "V425");
    EXPECT_NE(fault.message.find("\"store\""), std::string::npos) << fault.message;
    ASSERT_FALSE(fault.help.empty());
    EXPECT_NE(fault.help[0].find("fullscreen"), std::string::npos);
    // The image of a swapchain often has the usage of a colour attachment only.
    input.request.output = {Format::rgba16f, Layout::present, usage::kColorAttachment};
    EXPECT_EQ(fault_of(input).code, "V425");
}

// Brings the output from its final layout to another one and back, as a program would. The validation layer
// reports a final layout that is not the promised one.
Status use_output(vk::Device& device, VkImage image, VkImageLayout layout) {
    return vk::immediate_submit(device, "using the output", [&](VkCommandBuffer commands) {
        for (const bool back : {false, true}) {
            VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
            barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
            barrier.srcAccessMask = barrier.dstAccessMask =
                VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
            barrier.oldLayout = back ? VK_IMAGE_LAYOUT_GENERAL : layout;
            barrier.newLayout = back ? layout : VK_IMAGE_LAYOUT_GENERAL;
            barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
            barrier.image = image;
            barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
            VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
            info.imageMemoryBarrierCount = 1;
            info.pImageMemoryBarriers = &barrier;
            device.fn().vkCmdPipelineBarrier2(commands, &info);
        }
    });
}

TEST_F(EmbeddingVk, TheOutputEndsInTheLayoutThatTheProgramNeeds) {
    for (const Layout layout : {Layout::present, Layout::shader_read_only, Layout::color_attachment}) {
        SCOPED_TRACE(layout_text(layout));
        render::SessionInput input = input_for(kGradient);
        input.request.output = {Format::bgra8, layout, usage::kColorAttachment | usage::kSampled};
        VkImageCreateInfo info = render::output_create_info(*device_, kPictureSize, input.request.output);
        EXPECT_EQ(info.format, VK_FORMAT_B8G8R8A8_UNORM);
        EXPECT_EQ(info.usage, static_cast<VkImageUsageFlags>(VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                                             VK_IMAGE_USAGE_SAMPLED_BIT));
        const std::unique_ptr<render::Session> session = open(input);
        ASSERT_TRUE(session);
        const ResourceDecl& decl = session->plan().graph.resources[session->plan().graph.output];
        EXPECT_EQ(decl.import->exit.layout, layout);
        Result<vk::Image> own = vk::Image::create(*device_, decl);
        ASSERT_TRUE(own) << to_text(own.errors());
        render::Selection selection = session->selection();
        selection.output = own->handle();
        render::PrepareResult prepared = session->prepare(selection);
        ASSERT_TRUE(prepared.result) << to_text(prepared.result.errors());
        ASSERT_TRUE(session->swap_in(std::move(*prepared.result)));
        for (int i = 0; i < 3; ++i) {
            ASSERT_TRUE(draw_frame(*session));
            ASSERT_TRUE(use_output(*device_, own->handle(), vk::to_vk(layout)));
        }
        ASSERT_TRUE(session->finish());
        const Result<vk::ReadbackData> read = session->read_output();
        ASSERT_FALSE(read);
        EXPECT_EQ(read.errors().front().code, "V426");
    }
}

TEST_F(EmbeddingVk, SeveralSessionsShareADeviceAndItsPipelines) {
    vk::SharedPipelines pipelines;
    const auto two_frames = [&](const std::unique_ptr<render::Session>& session) {
        for (int i = 0; i < 2; ++i) EXPECT_TRUE(draw_frame(*session));
        return picture(*session);
    };
    std::vector<std::byte> alone, trail_alone;
    {
        const std::unique_ptr<render::Session> session = open(input_for(kDeferredGraph));
        const std::unique_ptr<render::Session> trail = open(input_for(kTrail));
        ASSERT_TRUE(session && trail);
        alone = two_frames(session);
        trail_alone = two_frames(trail);
    }
    render::SessionInput input = input_for(kDeferredGraph);
    input.pipelines = &pipelines;
    const std::unique_ptr<render::Session> first = open(input);
    const std::unique_ptr<render::Session> second = open(input);
    const std::unique_ptr<render::Session> third = open(input_for(kTrail));
    ASSERT_TRUE(first && second && third);
    EXPECT_GT(first->parts().frames.executor().pipelines().made, 0u);
    EXPECT_EQ(second->parts().frames.executor().pipelines().made, 0u) << "all pipelines are shared";
    for (int i = 0; i < 2; ++i)
        for (render::Session* session : {first.get(), second.get(), third.get()})
            ASSERT_TRUE(draw_frame(*session));
    EXPECT_EQ(picture(*second), alone);
    EXPECT_EQ(picture(*first), alone);
    EXPECT_EQ(picture(*third), trail_alone);
}

TEST_F(EmbeddingVk, FramesInOwnCommandBuffersSurviveAResize) {
    std::array<std::vector<std::byte>, 2> pictures;
    for (const bool own : {false, true}) {
        OwnCommands commands(*device_);
        const std::unique_ptr<render::Session> session = open(input_for(kTrail));
        ASSERT_TRUE(session);
        const auto frames = [&](int count) {
            for (int i = 0; i < count; ++i) {
                if (own) frame_of(*session).submit = commands.begin();
                const Status drawn = draw_frame(*session);
                ASSERT_TRUE(drawn) << to_text(drawn.errors());
                if (own) commands.submit();
            }
        };
        frames(3);
        ASSERT_TRUE(session->resize({20, 24, 1}, warnings_));
        frames(3);
        pictures[own ? 1 : 0] = picture(*session);
    }
    EXPECT_EQ(pictures[0], pictures[1]);
}

// A shader may read images at ports that the graph does not have. Small images stand in for them. The first
// frame changes their layouts, also in a command buffer of the program.
TEST_F(EmbeddingVk, AMissingPortIsReadWithoutAHazardInAnOwnCommandBuffer) {
    OwnCommands commands(*device_);
    const std::unique_ptr<render::Session> session = open(input_for(kMissingPorts));
    ASSERT_TRUE(session);
    for (int i = 0; i < 2; ++i) {
        frame_of(*session).submit = commands.begin();
        const Status drawn = draw_frame(*session);
        ASSERT_TRUE(drawn) << to_text(drawn.errors());
        commands.submit();
    }
    EXPECT_FALSE(picture(*session).empty());
}

// Reads a value of the program in a pass in C++, and fills a buffer with it.
struct FillFromHost {
    static constexpr std::string_view kType = "fill_from_host";
    static constexpr std::array<PortDecl, 1> kPorts{Out{"words", Access::copy_write}};
    static constexpr std::array<ParamDecl, 0> kParams{};
    static Status check(const PassDecl&, const ResolvedGraph&) { return Unit{}; }
    static void prepare(const PassContext&, const HostInputs& host, Uploads& uploads) {
        if (const auto* word = host.get<uint32_t>("word"))
            uploads.put("words", std::as_bytes(std::span(word, 1)));
    }
    static void record(const PassContext&, Recorder& recorder) { recorder.copy_upload("words"); }
};

TEST_F(EmbeddingVk, PassesGetTheValuesOfTheProgram) {
    passes_.emplace("fill_from_host", pass_type<FillFromHost>());
    render::SessionInput input = input_for("/host.json");
    input.request.observed = {"words"};
    input.load.reader = [](const std::string& path) -> std::optional<std::string> {
        if (!path.ends_with("host.json")) return read_text(path);
        return R"({ "version": 1, "name": "host", "resources": { "words": { "buffer": "u32", "count": 1 } },
                    "passes": { "fill": { "type": "fill_from_host", "out": ["words"] } } })";
    };
    const std::unique_ptr<render::Session> session = open(input);
    ASSERT_TRUE(session);
    const uint32_t word = 0xC0FFEE;
    HostInputs host;
    host.set("word", word);
    frame_of(*session).host = &host;
    ASSERT_TRUE(draw_frame(*session));
    ASSERT_TRUE(session->finish());
    const std::vector<vk::ReadbackData> read = session->take_readbacks();
    ASSERT_EQ(read.size(), 1u);
    uint32_t found = 0;
    ASSERT_EQ(read[0].bytes.size(), sizeof found);
    std::memcpy(&found, read[0].bytes.data(), sizeof found);
    EXPECT_EQ(found, word);
}

VKAPI_ATTR VkResult VKAPI_CALL submit_to_lost_device(VkQueue, uint32_t, const VkSubmitInfo*, VkFence) {
    return VK_ERROR_DEVICE_LOST;
}

// The program destroys the session, Weft's device and its own device, and creates all of them again.
TEST_F(EmbeddingVk, AfterTheLossOfTheDeviceEverythingIsCreatedAgain) {
    std::vector<std::byte> before;
    for (const bool is_lost : {true, false}) {
        vk::FeatureChain supported, enabled;
        device_->instance_fn().vkGetPhysicalDeviceFeatures2(device_->physical(), &supported.head());
        vk::enable_features(supported, enabled);
        const vk::NativeDevice own = native(*device_);
        Result<std::unique_ptr<vk::Device>> adopted =
            vk::Device::adopt({own.instance, own.physical, own.device, {own.queue}, &enabled});
        ASSERT_TRUE(adopted);
        std::unique_ptr<render::Session> session = open_on(**adopted, input_for(kDeferredGraph));
        ASSERT_TRUE(session);
        ASSERT_TRUE(draw_frame(*session));
        if (!is_lost) {
            EXPECT_EQ(picture(*session), before);
        } else {
            before = picture(*session);
            (*adopted)->fn().vkQueueSubmit = submit_to_lost_device;
            Status drawn = draw_frame(*session);
            ASSERT_FALSE(drawn);
            EXPECT_EQ(drawn.errors().front().code, "V408");
            EXPECT_FALSE(draw_frame(*session)) << "no further frame runs";
            // Other work also reports the loss, and neither hangs nor crashes.
            EXPECT_FALSE(session->read_output());
            EXPECT_FALSE(render::Session::create(**adopted, scene_, input_for(kDeferredGraph), warnings_));
        }
        session.reset();
        EXPECT_FALSE((*adopted)->abandoned());
        adopted->reset();
        // The validation layer reports objects that are not destroyed.
        for (const vk::Message& m : vk::destroy_device(std::move(device_)))
            ADD_FAILURE() << m.id << ": " << m.text;
        make_device(true);
    }
}

}  // namespace
}  // namespace weft::test
