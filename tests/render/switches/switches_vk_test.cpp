// Tests passes with "switch" on the device. Whatever the program switches from frame to frame, each picture
// must have the same bytes as that of a graph in which "if" has the same values, so that each change makes a
// new plan.
#include <algorithm>
#include <cstdlib>
#include <random>

#include "tests/graph/samples/random_switches.h"
#include "tests/render/session/object_counter.h"
#include "tests/render/session_fixture.h"
#include "tests/render/switches/count_allocations.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr const char* kSwitchesGraph = WEFT_SOURCE_DIR "/tests/render/switches/switches.json";
const std::vector<std::string> kSwitchNames{"extraOn", "glowOn", "mistOn", "trailOn"};

// Reads the graph with "if" instead of "switch". The graph itself then gives the member trailValid, which
// otherwise tells whether the pass with the switch has run.
std::optional<std::string> read_with_if(const std::string& path) {
    std::optional<std::string> text = read_text(path);
    const auto replace = [&](const std::string& old, const std::string& now) {
        for (size_t at = 0; text && (at = text->find(old, at)) != std::string::npos; at += now.size())
            text->replace(at, old.size(), now);
    };
    replace("\"switch\":", "\"if\":");
    replace("\"gain\": 1", R"("gain": 1, "trailValid": "trailOn")");
    return text;
}

// Returns a graph with "if" instead of "switch".
std::string with_if(std::string text) {
    const auto replace = [&](const std::string& old, const std::string& now, size_t name_bytes) {
        for (size_t at = 0; (at = text.find(old, at)) != std::string::npos;) {
            const std::string name = text.substr(at + old.size(), name_bytes);
            text.replace(at, old.size() + name_bytes, now + name);
        }
    };
    replace("\"switch\": \"!", "\"if\": \"1 - ", 2);
    replace("\"switch\": \"", "\"if\": \"", 2);
    return text;
}

class Switched : public SessionTest {
 protected:
    std::unique_ptr<render::Session> begin(const FileReader& reader,
                                           const std::string& path = kSwitchesGraph) {
        const Result<scene::Scene> scene = scene::make_builtin("spheres");
        passes_ = registered_passes();
        render::SessionInput input;
        input.request.path = path;
        input.request.size = {32, 32, 1};
        input.load.reader = reader;
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

    static std::vector<std::byte> picture(render::Session& session) {
        EXPECT_TRUE(draw_frame(session));
        EXPECT_TRUE(session.finish());
        Result<vk::ReadbackData> output = session.read_output();
        EXPECT_TRUE(output);
        return output ? std::move(output->bytes) : std::vector<std::byte>{};
    }

    static void set_params(render::Session& session, const std::vector<std::string>& names, uint32_t on) {
        render::Selection selection = session.selection();
        for (uint32_t s = 0; s < names.size(); ++s) selection.request.params[names[s]] = on >> s & 1u;
        render::PrepareResult made = session.prepare(selection);
        ASSERT_TRUE(made.result) << to_text(made.result.errors());
        const Result<bool> swapped = session.swap_in(std::move(*made.result));
        ASSERT_TRUE(swapped && *swapped) << to_text(swapped.errors());
    }

    // Returns all combinations of the switches, several times in a random order.
    static std::vector<uint32_t> combinations(uint32_t seed) {
        std::vector<uint32_t> all;
        for (uint32_t i = 0; i < 32; ++i) all.push_back(i % 16);
        std::mt19937 random(seed);
        for (size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[random() % i]);
        return all;
    }

    void compare_with_if() {
        const std::unique_ptr<render::Session> live = begin(read_text), planned = begin(read_with_if);
        ASSERT_TRUE(live && planned);
        const std::string hash = plan_hash(live->plan());
        std::set<std::vector<std::byte>> different;
        for (const uint32_t on : combinations(queues_)) {
            for (uint32_t s = 0; s < kSwitchNames.size(); ++s)
                frame_of(*live).parameters[kSwitchNames[s]] = (on >> s & 1u) != 0;
            set_params(*planned, kSwitchNames, on);
            if (HasFatalFailure()) return;
            for (int frame = 0; frame < 2; ++frame) {
                std::vector<std::byte> found = picture(*live);
                ASSERT_EQ(found, picture(*planned)) << "switches " << on << ", " << queues_ << " queues";
                different.insert(std::move(found));
            }
        }
        EXPECT_GE(different.size(), 16u);
        EXPECT_EQ(plan_hash(live->plan()), hash);
        EXPECT_EQ(live->pipelines_made_between_frames(), 0u);
    }

    // Renders a random graph and the same graph with "if", with the same changes of the switches, and
    // compares what they read back. Adds the number of compared images to `compared`.
    void compare_random_graph(uint32_t seed, uint64_t& compared) {
        const std::string path = WEFT_SOURCE_DIR "/tests/render/switches/random/graph.json";
        const RandomSwitches made = random_switches(seed);
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + made.text);
        const auto reader = [&](const std::string& body) -> FileReader {
            return
                [&path, text = R"({"version": 1, "name": "random", )" + body + "}"](const std::string& file) {
                    return file == path ? std::optional(text) : read_text(file);
                };
        };
        const std::unique_ptr<render::Session> live = begin(reader(made.text), path),
                                               planned = begin(reader(with_if(made.text)), path);
        ASSERT_TRUE(live && planned);
        std::vector<std::string> names;
        for (uint32_t s = 0; s < made.switches; ++s) names.push_back("s" + std::to_string(s));
        std::mt19937 random(seed);
        for (int change = 0; change < 5; ++change) {
            const auto on = static_cast<uint32_t>(random() % 16);
            for (uint32_t s = 0; s < names.size(); ++s)
                frame_of(*live).parameters[names[s]] = (on >> s & 1u) != 0;
            set_params(*planned, names, on);
            if (HasFatalFailure()) return;
            for (render::Session* session : {live.get(), planned.get()}) {
                ASSERT_TRUE(draw_frame(*session));
                ASSERT_TRUE(session->finish());
            }
            compare_readbacks(*live, *planned, compared);
            if (HasFatalFailure()) return;
        }
        EXPECT_EQ(live->pipelines_made_between_frames(), 0u);
    }

    static void compare_readbacks(render::Session& live, render::Session& planned, uint64_t& compared) {
        std::map<std::string, std::vector<std::byte>> wanted;
        for (vk::ReadbackData& data : planned.take_readbacks()) wanted[data.pass] = std::move(data.bytes);
        for (const vk::ReadbackData& data : live.take_readbacks()) {
            ASSERT_TRUE(data.bytes == wanted[data.pass]) << data.pass;
            ++compared;
        }
    }
};

TEST_F(Switched, PicturesAreThoseOfTheGraphWithIf) {
    compare_with_if();
}

TEST_F(Switched, PicturesOnSeveralQueuesAreThoseOfTheGraphWithIf) {
    queues_ = 3;
    make_device(true);
    compare_with_if();
}

// Random graphs with random changes of their switches give the same bytes as the graphs with "if", which keep
// the contents of resources through their changes of the plan.
TEST_F(Switched, RandomGraphsGiveWhatTheGraphsWithIfGive) {
    const uint32_t seeds = std::getenv("WEFT_EXTENDED") != nullptr ? 200 : 6;
    uint64_t compared = 0;
    for (const uint32_t queues : {1u, 3u}) {
        for (const vk::Message& m : device_->messages().messages()) ADD_FAILURE() << m.id << ": " << m.text;
        queues_ = queues;
        make_device(true);
        for (uint32_t seed = 1; seed <= seeds && !HasFatalFailure(); ++seed)
            compare_random_graph(seed * 2 + queues, compared);
    }
    std::printf("%llu images compared\n", static_cast<unsigned long long>(compared));
    EXPECT_GE(compared, 40u);
}

TEST_F(Switched, ALiveParameterChangesNothingButTheSwitch) {
    const std::unique_ptr<render::Session> session = begin(read_text);
    ASSERT_TRUE(session);
    const std::string hash = structure_hash(session->plan());
    const FramePlan* plan = &session->plan();
    const std::vector<std::byte> all_on = picture(*session);
    const ObjectCounter objects(*device_);
    set_params(*session, kSwitchNames, 0);
    const std::vector<std::byte> all_off = picture(*session);
    EXPECT_NE(all_on, all_off);
    EXPECT_EQ(&session->plan(), plan);
    EXPECT_EQ(structure_hash(session->plan()), hash);
    EXPECT_EQ(session->pipelines_made_between_frames(), 0u);
    EXPECT_EQ(objects.live(), 0);
    for (const GraphParam& param : session->plan().graph.params)
        EXPECT_EQ(param.cost, ParamCost::live) << param.name;
}

// Returns how often the thread allocates memory while it renders one frame.
uint64_t allocations_of_frame(render::Session& session) {
    const uint64_t before = allocations_of_thread();
    EXPECT_TRUE(draw_frame(session));
    return allocations_of_thread() - before;
}

// A frame that changes switches must allocate as often as the next frame, in which nothing changes. The
// Vulkan objects must stay the same, too.
TEST_F(Switched, AChangeAllocatesNothing) {
    make_device(false);  // The validation layer would allocate memory, too.
    const std::unique_ptr<render::Session> session = begin(read_text);
    ASSERT_TRUE(session);
    const auto turn = [&](uint32_t on) {
        for (uint32_t s = 0; s < kSwitchNames.size(); ++s)
            frame_of(*session).parameters[kSwitchNames[s]] = (on >> s & 1u) != 0;
    };
    // The first frames may allocate memory that later frames use again.
    turn(15);
    for (int i = 0; i < 80; ++i) (void)allocations_of_frame(*session);
    const ObjectCounter objects(*device_);
    uint64_t most = 0;
    for (const uint32_t on : combinations(7)) {
        turn(on);
        const uint64_t changed = allocations_of_frame(*session);
        const uint64_t steady = allocations_of_frame(*session);
        EXPECT_EQ(changed, steady) << "switches " << on;
        most = std::max(most, changed);
    }
    std::printf("at most %llu allocations in a frame\n", static_cast<unsigned long long>(most));
    EXPECT_EQ(objects.live(), 0);
    EXPECT_EQ(session->pipelines_made_between_frames(), 0u);
}

TEST_F(Switched, TimingsTellWhichPassesWereOff) {
    const std::unique_ptr<render::Session> session = begin(read_text);
    ASSERT_TRUE(session);
    frame_of(*session).parameters = {{"mistOn", 0}, {"trailOn", 0}};
    (void)picture(*session);
    std::set<std::string> off;
    for (const vk::FrameTiming& frame : session->take_timings())
        for (const vk::PassTiming& pass : frame.passes)
            if (pass.switched_off) off.insert(pass.pass);
    EXPECT_EQ(off, (std::set<std::string>{"draw", "mist", "veil"}));
}

TEST_F(Switched, AValueStaysUntilTheNextOneOrUntilASwap) {
    const std::unique_ptr<render::Session> live = begin(read_text), planned = begin(read_text);
    ASSERT_TRUE(live && planned);
    const auto expect_same = [&](const char* when) { EXPECT_EQ(picture(*live), picture(*planned)) << when; };
    frame_of(*live).parameters = {{"glowOn", 0}, {"mistOn", 0}};
    set_params(*planned, {"glowOn", "mistOn"}, 0);
    expect_same("both are off");
    frame_of(*live).parameters = {{"glowOn", 0.5}};
    set_params(*planned, {"glowOn"}, 1);
    expect_same("any number but 0 is on, and the other switch stays off");
    frame_of(*live).parameters = {{"noSwitch", 1}};
    const Status unknown = draw_frame(*live);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.errors().front().code, "W242");
    frame_of(*live).parameters.clear();
    const std::vector<std::byte> off = picture(*live);
    EXPECT_EQ(off, picture(*planned)) << "both values stay";
    for (render::Session* session : {live.get(), planned.get()}) set_params(*session, kSwitchNames, 15);
    expect_same("the values of the selection hold again");
    EXPECT_NE(picture(*live), off);
}

}  // namespace
}  // namespace weft::test
