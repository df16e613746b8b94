// Tests those mutants (damaged copies) of the shipped graphs that can be loaded: renders them on a device,
// and expects no validation message.
#include <cstdlib>

#include "tests/render/graph_mutants.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr uint32_t kFirstDrawnSeed = 61000;
constexpr Extent3D kDrawnSize{64, 36, 1};
constexpr uint32_t kDrawnFrames = 2;
// A number out of range may request too much memory or work for a CPU device. Mutants above these limits are
// skipped.
constexpr uint64_t kMostMemory_bytes = uint64_t{256} << 20;
constexpr uint64_t kMostInvocations = uint64_t{1} << 22;
constexpr size_t kMostPasses = 600;

class GraphMutantsVkTest : public SessionTest {
 protected:
    enum class Outcome : uint8_t { refused, too_much, drawn };

    static bool is_too_much(const FramePlan& plan) {
        uint64_t invocations = 0;
        for (const PassId id : plan.schedule.order) {
            const PassDecl& pass = plan.graph.passes[id];
            uint64_t workgroups = 1;
            for (const uint32_t side : pass.groups) workgroups *= side;
            if (pass.kind == PassKind::compute) invocations += workgroups * 64;
        }
        return plan.schedule.order.size() > kMostPasses || invocations > kMostInvocations;
    }

    render::SessionInput input_of(const Mutant& mutant) {
        render::SessionInput input;
        input.request.path = GraphMutants::path_of(mutant.root);
        input.load.reader = GraphMutants::reader_of(mutant);
        input.load.graph_root = GraphMutants::path_of("graphs");
        input.load.shader_root = GraphMutants::path_of("shaders");
        input.load.shader_cache = WEFT_TEST_CACHE "/mutants";
        input.passes = &passes_;
        input.request.size = kDrawnSize;
        input.check_plan = true;
        input.load.limits.graph.transient_bytes = kMostMemory_bytes;
        return input;
    }

    Outcome draw(const Mutant& mutant) {
        SCOPED_TRACE("seed " + std::to_string(mutant.seed) + ", " + mutant.file + " (loaded: " + mutant.root +
                     "), " + mutant.how);
        Diagnostics warnings;
        const Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, *scene_, input_of(mutant), warnings);
        if (!session) {
            const Diagnostics& faults = session.errors();
            const bool too_much = faults.front().code == "W143";
            for (const Diagnostic& d : faults)
                EXPECT_TRUE(d.code.starts_with("W") && d.line > 0 && d.column > 0) << to_text(d);
            return too_much ? Outcome::too_much : Outcome::refused;
        }
        if (is_too_much((*session)->plan())) return Outcome::too_much;
        Status done = Unit{};
        for (uint32_t frame = 0; frame < kDrawnFrames && done; ++frame)
            done = (*session)->render_frame({camera_, 0, frame / 60.0, 1 / 60.0});
        if (done) done = (*session)->finish();
        EXPECT_TRUE(done) << to_text(done.errors());
        const std::vector<vk::Message> messages = device_->messages().messages();
        for (size_t i = messages_; i < messages.size(); ++i)
            ADD_FAILURE() << messages[i].id << ": " << messages[i].text << "\n" << mutant.text;
        messages_ = messages.size();
        return Outcome::drawn;
    }

    Result<scene::Scene> scene_ = scene::make_builtin("spheres");
    scene::Camera camera_;
    // Number of validation messages that have been checked already.
    size_t messages_ = 0;
};

TEST_F(GraphMutantsVkTest, AreDrawnWithoutAMessage) {
    ASSERT_TRUE(scene_);
    camera_ = scene::framing_camera(*scene_, 16.0f / 9.0f);
    passes_ = registered_passes();
    const uint32_t wanted = std::getenv("WEFT_EXTENDED") != nullptr ? 300 : 12;
    const GraphMutants mutants;
    uint32_t drawn = 0, too_much = 0, seed = kFirstDrawnSeed;
    for (; drawn < wanted && seed < kFirstDrawnSeed + 20 * wanted && !HasFailure(); ++seed) {
        const Outcome outcome = draw(mutants.make(seed));
        drawn += outcome == Outcome::drawn ? 1 : 0;
        too_much += outcome == Outcome::too_much ? 1 : 0;
    }
    std::printf("seeds %u to %u: %u mutants drawn, %u left out as too much work\n", kFirstDrawnSeed, seed - 1,
                drawn, too_much);
    EXPECT_EQ(drawn, wanted);
}

}  // namespace
}  // namespace weft::test
