// Tests resources with both `history` and `keep` on a device: the current content continues the last one, and
// the contents of earlier frames stay readable, also after a resize and a change of the tier.
#include <cstring>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr uint32_t kStart = 5, kColumn = 3;
using Words = std::vector<uint32_t>;

// The values that the pass "probe" must see, computed without Weft.
struct Expected {
    // The newest values of a texel that grows; the last one is that of the current frame.
    std::vector<uint32_t> values{kStart, kStart, kStart};
    uint32_t frames = 0;

    void frame(bool grows) {
        ++frames;
        values.push_back(grows ? values.back() * 3 + kColumn : values.back());
    }
    [[nodiscard]] Words words() const {
        const size_t last = values.size() - 1;
        return {values[last], values[last - 1],     values[last - 2],     kStart,
                kStart,       frames > 1 ? 1u : 0u, frames > 2 ? 1u : 0u, 0};
    }
};

class CarryVk : public SessionTest {
 protected:
    void begin() {
        session_ = start(WEFT_SOURCE_DIR "/tests/render/carry/carry.json", {16, 16, 1}, {"seen"});
        ASSERT_TRUE(session_);
    }
    void frames(uint32_t count, bool grows = true) {
        for (uint32_t i = 0; i < count; ++i) {
            const Status done = draw_frame(*session_);
            ASSERT_TRUE(done) << to_text(done.errors());
            expected_.frame(grows);
            EXPECT_EQ(seen(), expected_.words()) << "frame " << expected_.frames;
        }
    }
    Words seen() {
        EXPECT_TRUE(session_->finish());
        Words words(8);
        for (const vk::ReadbackData& data : session_->take_readbacks())
            if (data.bytes.size() == words.size() * sizeof words[0])
                std::memcpy(words.data(), data.bytes.data(), data.bytes.size());
        return words;
    }
    void choose(const std::string& tier) {
        render::Selection selection = session_->selection();
        selection.request.tier = tier;
        render::PrepareResult prepared = session_->prepare(selection);
        ASSERT_TRUE(prepared.result) << to_text(prepared.result.errors());
        const Result<bool> swapped = session_->swap_in(std::move(*prepared.result));
        ASSERT_TRUE(swapped) << to_text(swapped.errors());
        ASSERT_TRUE(*swapped);
    }

    std::unique_ptr<render::Session> session_;
    Expected expected_;
};

TEST_F(CarryVk, EachFrameContinuesTheLast) {
    begin();
    frames(6);
}

TEST_F(CarryVk, AResizeOfTheOutputChangesNothing) {
    begin();
    frames(2);
    const Status done = session_->resize({31, 7, 1}, warnings_);
    ASSERT_TRUE(done) << to_text(done.errors());
    frames(3);
}

// In the tier "idle", no pass writes the image. Weft passes its content on, and the content stays valid.
TEST_F(CarryVk, ATierWithoutAWriterKeepsTheContent) {
    begin();
    frames(3);
    choose("idle");
    EXPECT_TRUE(find_pass(session_->plan().graph, "carry:x") != kNoId);
    frames(3, false);
    choose("");
    frames(2);
}

// In the tier "short", the image has no history. Its only copy continues the newest content, and afterwards
// the newest content is the only one that the history knows.
TEST_F(CarryVk, AHistoryBeginsAndEnds) {
    begin();
    frames(3);
    choose("short");
    ASSERT_TRUE(draw_frame(*session_));
    expected_.frame(true);
    EXPECT_EQ(seen()[0], expected_.words()[0]);
    choose("");
    ASSERT_TRUE(draw_frame(*session_));
    expected_.frame(true);
    const Words words = seen(), wanted = expected_.words();
    EXPECT_EQ(words[0], wanted[0]);
    EXPECT_EQ(words[1], wanted[1]);
    EXPECT_EQ(words[2], kStart) << "two frames ago there was no history";
    EXPECT_EQ(words[5], 1u);
    EXPECT_EQ(words[6], 0u);
}

class CarryOnQueuesVk : public CarryVk {
 protected:
    void SetUp() override {
        queues_ = 3;
        make_device(true);
    }
};

TEST_F(CarryOnQueuesVk, EachFrameContinuesTheLast) {
    begin();
    frames(4);
}

}  // namespace
}  // namespace weft::test
