// Tests groups on the device: rounds that take turns, lists of turns, rounds that rest and settle, and
// content that survives a resize and a reload.
#include <cstring>
#include <random>

#include "tests/graph/samples/random_groups.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr const char* kBakeGraph = WEFT_SOURCE_DIR "/tests/render/groups/bake.json";

class GroupsVk : public SessionTest {
 protected:
    std::unique_ptr<render::Session> begin() {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        EXPECT_TRUE(scene);
        return start(*scene, scene::framing_camera(*scene, 1), kBakeGraph, {32, 32, 1},
                     {"baked", "marked", "bounced"});
    }

    // Renders a frame. Then layers("baked") and so on have the first texel of each layer.
    void frame(render::Session& session, std::vector<uint32_t> order = {}) {
        frame_of(session).turns["order"] = std::move(order);
        ASSERT_TRUE(draw_frame(session));
        ASSERT_TRUE(session.finish());
        read_.clear();
        for (vk::ReadbackData& data : session.take_readbacks()) read_[data.pass] = std::move(data.bytes);
        dropped_ = 0;
        for (const vk::FrameTiming& timing : session.take_timings()) dropped_ += timing.dropped_turns;
    }

    [[nodiscard]] std::vector<float> layers(const std::string& resource) const {
        const std::vector<std::byte>& bytes = read_.at("observe:" + resource);
        constexpr size_t kLayerBytes = 16 * 16 * sizeof(float);
        std::vector<float> texels(bytes.size() / kLayerBytes);
        for (size_t layer = 0; layer < texels.size(); ++layer)
            std::memcpy(&texels[layer], &bytes[layer * kLayerBytes], sizeof(float));
        return texels;
    }
    // The words that the pass "look" writes: the members <port>ValidBits and <port>Valid of its Params.
    [[nodiscard]] std::vector<uint32_t> words() const {
        std::vector<uint32_t> words(4);
        std::memcpy(words.data(), read_.at("keepSeen").data(), 4 * sizeof(uint32_t));
        return words;
    }

    void set_power(render::Session& session, double power) {
        render::Selection selection = session.selection();
        selection.request.params["power"] = power;
        render::PrepareResult made = session.prepare(selection);
        ASSERT_TRUE(made.result) << to_text(made.result.errors());
        ASSERT_TRUE(session.swap_in(std::move(*made.result)));
    }

    std::unique_ptr<render::Session> begin_random(const RandomGroups& made, bool rests) {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        passes_ = registered_passes();
        render::SessionInput input;
        input.request.path = WEFT_SOURCE_DIR "/tests/render/rest/random/graph.json";
        input.request.size = {64, 64, 1};
        input.request.rests = rests;
        input.timestamps = true;
        input.load.reader = [&made](const std::string& path) {
            return path.ends_with("graph.json") ? std::optional("{\"version\": 1, " + made.text + "}")
                                                : read_text(path);
        };
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.passes = &passes_;
        input.check_plan = true;
        input.queues = queues_;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, *scene, input, warnings_);
        EXPECT_TRUE(session) << to_text(session.errors());
        if (!session) return nullptr;
        frame_of(**session) = {.camera = scene::framing_camera(*scene, 1)};
        return std::move(*session);
    }

    std::map<std::string, std::vector<std::byte>> read_;  // Key: name of the readback pass.
    uint32_t dropped_ = 0;
};

using Layers = std::vector<float>;
using Words = std::vector<uint32_t>;

TEST_F(GroupsVk, ABakeOfFourRoundsOneAFrameFillsAllLayers) {
    for (queues_ = 1; queues_ <= 3; queues_ += 2) {
        make_device(true);
        const std::unique_ptr<render::Session> session = begin();
        ASSERT_TRUE(session);
        const std::vector<Layers> wanted{
            {1, 0, 0, 0}, {1, 2, 0, 0}, {1, 2, 3, 0}, {1, 2, 3, 4}, {1, 2, 3, 4}};
        for (size_t i = 0; i < wanted.size(); ++i) {
            frame(*session);
            EXPECT_EQ(layers("baked"), wanted[i]) << "frame " << i;
            EXPECT_EQ(words()[0], (1u << std::min<size_t>(i + 1, 4)) - 1) << "bakedValidBits in frame " << i;
            EXPECT_EQ(words()[1], i >= 3 ? 1u : 0u) << "bakedValid in frame " << i;
        }
    }
}

TEST_F(GroupsVk, ABakeGoesOnAfterAResizeAndAReload) {
    const std::unique_ptr<render::Session> session = begin();
    ASSERT_TRUE(session);
    frame(*session);
    ASSERT_TRUE(session->resize({40, 24, 1}, warnings_));
    frame(*session);
    EXPECT_EQ(layers("baked"), (Layers{1, 2, 0, 0}));
    EXPECT_EQ(words()[0], 3u);
    render::PrepareResult made = session->prepare(session->selection());
    ASSERT_TRUE(made.result) << to_text(made.result.errors());
    ASSERT_TRUE(session->swap_in(std::move(*made.result)));
    frame(*session);
    EXPECT_EQ(layers("baked"), (Layers{1, 2, 3, 0}));
    EXPECT_EQ(words()[0], 7u);
}

// Round 0 of "listed" writes layer 3, because its repeat counts down. A layer has the number of the frame in
// which its round ran last.
TEST_F(GroupsVk, AListChoosesTheRoundsAndTheirOrder) {
    const std::unique_ptr<render::Session> session = begin();
    ASSERT_TRUE(session);
    frame(*session, {});
    EXPECT_EQ(layers("marked"), (Layers{0, 0, 0, 0})) << "warmUp is 0";
    EXPECT_EQ(words()[2], 0u);
    frame(*session, {3, 1});
    EXPECT_EQ(layers("marked"), (Layers{2, 0, 2, 0}));
    EXPECT_EQ(words()[2], 5u);
    EXPECT_EQ(dropped_, 0u);
    frame(*session, {0, 0, 4, 4000000000u, 2});
    EXPECT_EQ(layers("marked"), (Layers{2, 3, 2, 3}));
    EXPECT_EQ(dropped_, 3u) << "one round twice, two that do not exist";
    frame(*session, {0, 1, 2, 3});
    EXPECT_EQ(layers("marked"), (Layers{2, 4, 4, 4}));
    EXPECT_EQ(dropped_, 1u) << "perFrame is 3";
    frame(*session, {});
    EXPECT_EQ(layers("marked"), (Layers{2, 4, 4, 4}));
}

// A resource of a group can be shown also before a round has run. Then it has its first content.
TEST_F(GroupsVk, AResourceOfAGroupIsShownBeforeARoundHasRun) {
    const Result<scene::Scene> scene = scene::make_builtin("spheres");
    const std::unique_ptr<render::Session> session =
        start(*scene, scene::framing_camera(*scene, 1), kBakeGraph, {32, 32, 1}, {"listed::raw"});
    ASSERT_TRUE(session);
    frame(*session, {});
    EXPECT_EQ(layers("listed::raw"), Layers{0});
    frame(*session, {2});
    EXPECT_EQ(layers("listed::raw"), Layers{2});
    frame(*session, {});
    EXPECT_EQ(layers("listed::raw"), Layers{2}) << "the round that ran last has left it";
    render::Selection selection = session->selection();
    selection.request.debug = "listed::raw";
    render::PrepareResult made = session->prepare(selection);
    ASSERT_TRUE(made.result) << to_text(made.result.errors());
    ASSERT_TRUE(session->swap_in(std::move(*made.result)));
    frame(*session, {});
}

// A pass in C++ that gives the list of turns 1, 0 in each frame.
struct ChooseRounds {
    static constexpr std::string_view kType = "choose_rounds";
    static constexpr std::array<PortDecl, 1> kPorts{Out{"list", Access::copy_write}};
    static constexpr std::array<ParamDecl, 0> kParams{};
    static Status check(const PassDecl&, const ResolvedGraph&) { return Unit{}; }
    static void prepare(const PassContext&, const HostInputs&, Uploads& uploads) {
        constexpr std::array<uint32_t, 2> kRounds{1, 0};
        uploads.put("list", std::as_bytes(std::span(kRounds)));
        uploads.set_turns("order", kRounds);
    }
    static void record(const PassContext&, Recorder& recorder) { recorder.copy_upload("list"); }
};

TEST_F(GroupsVk, APassInCppChoosesTheRounds) {
    const Result<scene::Scene> scene = scene::make_builtin("spheres");
    passes_ = registered_passes();
    passes_.emplace("choose_rounds", pass_type<ChooseRounds>());
    render::SessionInput input;
    input.request.path = kBakeGraph;
    input.request.size = {32, 32, 1};
    input.request.observed = {"baked", "marked", "bounced"};
    input.load.reader = [](const std::string& path) {
        std::optional<std::string> text = read_text(path);
        const std::string place = "\"passes\": {\n    \"look\"",
                          resources = "\"resources\": {\n    \"baked\"";
        const size_t at = text ? text->find(place) : std::string::npos;
        if (at == std::string::npos) return text;
        text->replace(at, place.size(),
                      R"("passes": { "choose": { "type": "choose_rounds", "out": { "list": "chosen" } },
                         "readChosen": { "type": "readback", "in": ["chosen"] }, "look")");
        text->replace(text->find(resources), resources.size(),
                      R"("resources": { "chosen": { "buffer": "u32", "count": 2 }, "baked")");
        return text;
    };
    input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
    input.passes = &passes_;
    input.check_plan = true;
    Result<std::unique_ptr<render::Session>> session =
        render::Session::create(*device_, *scene, input, warnings_);
    ASSERT_TRUE(session) << to_text(session.errors());
    frame_of(**session) = {.camera = scene::framing_camera(*scene, 1)};
    frame(**session, {3});
    EXPECT_EQ(layers("marked"), (Layers{0, 0, 1, 1})) << "the list of the pass replaces that of the program";
}

// Each round adds half of the other round's result if both rounds have run before. So the first sweep gives 1
// and 1, and the two sweeps after it let the results approach 2.
TEST_F(GroupsVk, RoundsSettleAfterAChange) {
    const std::unique_ptr<render::Session> session = begin();
    ASSERT_TRUE(session);
    const std::vector<Layers> wanted{{1, 1}, {1.5f, 1.75f}, {1.875f, 1.9375f}, {1.875f, 1.9375f}};
    for (const Layers& layer : wanted) {
        frame(*session);
        EXPECT_EQ(layers("bounced"), layer);
    }
    EXPECT_EQ(words()[3], 3u);
    set_power(*session, 2);
    frame(*session);
    EXPECT_EQ(layers("bounced"), (Layers{2.96875f, 3.484375f}));
    for (int i = 0; i < 2; ++i) frame(*session);
    const Layers settled = layers("bounced");
    frame(*session);
    EXPECT_EQ(layers("bounced"), settled);
}

// Random graphs with random changes of their parameters give the same bytes with and without rest.
TEST_F(GroupsVk, RandomGroupsGiveTheBytesOfRunningEverything) {
    queues_ = 3;
    make_device(true);
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 50 : 8;
    size_t rested = 0;
    for (uint32_t seed = 1; seed <= seeds; ++seed) {
        queues_ = 1 + seed % 3;
        const RandomGroups made = random_groups(seed + 90000, true, RestShaders::real);
        SCOPED_TRACE("seed " + std::to_string(seed + 90000) + "\n" + made.text);
        const std::unique_ptr<render::Session> resting = begin_random(made, true),
                                               running = begin_random(made, false);
        ASSERT_TRUE(resting && running);
        std::mt19937 random(seed);
        for (uint32_t i = 0; i < 6; ++i) {
            for (render::Session* session : {resting.get(), running.get()}) {
                render::Selection selection = session->selection();
                std::mt19937 change(seed * 100 + i);
                selection.request.params["p" + std::to_string(change() % made.params)] =
                    static_cast<double>(change() % 8) / 8;
                render::PrepareResult now = session->prepare(selection);
                ASSERT_TRUE(now.result) << to_text(now.result.errors());
                ASSERT_TRUE(session->swap_in(std::move(*now.result)));
                ASSERT_TRUE(draw_frame(*session));
                ASSERT_TRUE(session->finish());
            }
            for (const vk::FrameTiming& timing : resting->take_timings())
                for (const vk::PassTiming& pass : timing.passes) {
                    if (!pass.rested) continue;
                    ++rested;
                    // A round that rests records no time stamps.
                    EXPECT_TRUE(pass.gpu_ms == 0 || pass.pass.find("::") == std::string::npos) << pass.pass;
                }
            const std::vector<vk::ReadbackData> a = resting->take_readbacks(), b = running->take_readbacks();
            ASSERT_EQ(a.size(), b.size());
            for (size_t k = 0; k < a.size(); ++k)
                ASSERT_EQ(a[k].bytes, b[k].bytes) << a[k].pass << " in frame " << i;
        }
    }
    std::printf("seeds 90001..%u: passes rested %zu times\n", 90000 + seeds, rested);
    EXPECT_GT(rested, 0u);
}

}  // namespace
}  // namespace weft::test
