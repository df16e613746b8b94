// Tests resources with `"keep": "shared"` on a device: a change of the tier keeps the very image or buffer
// and its memory, and copies nothing.
#include <algorithm>
#include <cstring>

#include "tests/render/session/object_counter.h"
#include "tests/render/session_fixture.h"
#include "weft/transition.h"

namespace weft::test {
namespace {

class SharedVk : public SessionTest {
 protected:
    void begin() {
        session_ = start(WEFT_SOURCE_DIR "/tests/render/shared/shared.json", {16, 16, 1},
                         {"marks", "words", "own", "wide"});
        ASSERT_TRUE(session_);
    }
    void frames(uint32_t count) {
        for (uint32_t i = 0; i < count; ++i) {
            const Status done = draw_frame(*session_);
            ASSERT_TRUE(done) << to_text(done.errors());
        }
    }
    // Returns the first word of an observed resource after the last frame.
    uint32_t first_word(const std::string& name) {
        EXPECT_TRUE(session_->finish());
        for (vk::ReadbackData& data : session_->take_readbacks())
            std::memcpy(&words_[data.pass], data.bytes.data(), sizeof(uint32_t));
        return words_["observe:" + name];
    }
    render::Selection with_tier(const std::string& tier) {
        render::Selection selection = session_->selection();
        selection.request.tier = tier;
        selection.request.observed = {"words", "own", "wide"};
        if (tier != "bare" && tier != "idle") selection.request.observed.emplace_back("marks");
        return selection;
    }
    // Changes the tier while frames are in flight. Returns what happens to the resources.
    TransitionPlan choose(const std::string& tier) {
        render::PrepareResult prepared = session_->prepare(with_tier(tier));
        EXPECT_TRUE(prepared.result) << to_text(prepared.result.errors());
        if (!prepared.result) return {};
        EXPECT_NE(prepared.result->new_plan(), nullptr);
        const TransitionPlan between = transition(session_->plan(), *prepared.result->new_plan());
        const Result<bool> swapped = session_->swap_in(std::move(*prepared.result));
        EXPECT_TRUE(swapped) << to_text(swapped.errors());
        return between;
    }
    [[nodiscard]] vk::NativeResource native(const std::string& name) const {
        const ResourceId id = find_resource(session_->plan().graph, name);
        EXPECT_NE(id, kNoId) << name;
        return session_->parts().frames.executor().native(id);
    }
    // Returns the names of the resources whose contents are copied.
    [[nodiscard]] std::vector<std::string> copied(const TransitionPlan& between) const {
        std::vector<std::string> names;
        for (const ContentCopy& carry : between.carried)
            if (!carry.shared) names.push_back(session_->plan().graph.resources[carry.to].name);
        return names;
    }

    std::unique_ptr<render::Session> session_;
    std::map<std::string, uint32_t> words_;
};

TEST_F(SharedVk, TheObjectAndItsMemoryStay) {
    begin();
    const vk::NativeResource marks = native("marks"), words = native("words"), own = native("own");
    EXPECT_NE(marks.image, VK_NULL_HANDLE);
    EXPECT_NE(marks.memory, VK_NULL_HANDLE);
    EXPECT_NE(words.buffer, VK_NULL_HANDLE);
    EXPECT_NE(marks.memory, words.memory);
    EXPECT_EQ(marks.offset_bytes, 0u);
    frames(3);
    for (const char* tier : {"drawn", "", "async", "drawn"}) {
        SCOPED_TRACE(tier);
        const TransitionPlan between = choose(tier);
        EXPECT_EQ(copied(between), std::vector<std::string>{"own"});
        EXPECT_TRUE(between.cleared.empty());
        EXPECT_EQ(native("marks"), marks);
        EXPECT_EQ(native("words"), words);
        EXPECT_NE(native("own").buffer, own.buffer);
        frames(2);
    }
    EXPECT_EQ(first_word("words"), 11u);
    EXPECT_EQ(first_word("own"), 11u);
    EXPECT_EQ(first_word("marks"), 100u);
}

// The usage of the one object has the flags that all tiers need.
TEST_F(SharedVk, TheUsageIsThatOfAllTiers) {
    begin();
    const auto usage_now = [&] {
        return session_->plan().graph.resources[find_resource(session_->plan().graph, "marks")].usage;
    };
    const UsageMask usage = usage_now();
    EXPECT_TRUE(usage & usage::kStorage);
    EXPECT_TRUE(usage & usage::kColorAttachment);
    frames(1);
    (void)choose("drawn");
    EXPECT_EQ(usage_now(), usage);
    frames(1);
}

TEST_F(SharedVk, AResizeChangesOnlyWhatDependsOnTheSize) {
    begin();
    const vk::NativeResource marks = native("marks"), wide = native("wide");
    frames(2);
    const Status done = session_->resize({24, 9, 1}, warnings_);
    ASSERT_TRUE(done) << to_text(done.errors());
    EXPECT_EQ(native("marks"), marks);
    EXPECT_NE(native("wide").image, wide.image);
    frames(2);
    EXPECT_EQ(first_word("marks"), 9u);
    EXPECT_EQ(first_word("wide"), 2u) << "cleared, because onResize is clear";
}

// The tier "bare" does not have the image. When it comes back, it starts again, although frames of the first
// plan may still be in flight when the last plan is made.
TEST_F(SharedVk, AResourceThatWasGoneStartsAgain) {
    begin();
    frames(3);
    (void)choose("bare");
    frames(1);
    const TransitionPlan between = choose("");
    EXPECT_EQ(between.cleared.size(), 1u);
    frames(1);
    EXPECT_EQ(first_word("marks"), 6u);
    EXPECT_EQ(first_word("words"), 5u);
}

// No pass of the tier "idle" uses the image. Its plan, and the plan after a resize, retain the image with its
// content for the next tier.
TEST_F(SharedVk, ATierWithoutUsesRetainsTheContent) {
    begin();
    const vk::NativeResource marks = native("marks");
    frames(3);
    for (const char* tier : {"idle", "drawn", "idle", ""}) {
        const TransitionPlan between = choose(tier);
        EXPECT_TRUE(between.cleared.empty()) << tier;
        EXPECT_EQ(native("marks"), marks) << tier;
        frames(1);
        if (tier != std::string("idle")) continue;
        const Status resized = session_->resize({24, 9, 1}, warnings_);
        ASSERT_TRUE(resized) << to_text(resized.errors());
        frames(1);
    }
    EXPECT_EQ(first_word("marks"), 101u);
}

// The tier "bare" does not declare the image, so the image is gone when the tier "idle" comes.
TEST_F(SharedVk, ATierRetainsNothingThatIsGone) {
    begin();
    frames(1);
    (void)choose("bare");
    (void)choose("idle");
    EXPECT_EQ(session_->plan().live.live_resources[find_resource(session_->plan().graph, "marks")], 0);
    frames(1);
}

TEST_F(SharedVk, SwapsBeforeAnyFrameLoseNothing) {
    begin();
    for (const char* tier : {"drawn", "async", ""}) (void)choose(tier);
    frames(2);
    EXPECT_EQ(first_word("marks"), 7u);
}

TEST_F(SharedVk, ManySwapsLeaveNoObjectBehind) {
    const ObjectCounter objects(*device_);
    int64_t settled = 0;
    {
        begin();
        for (uint32_t i = 0; i < 12; ++i) {
            (void)choose(i % 2 == 0 ? "drawn" : "");
            frames(1 + i % 3);
            EXPECT_TRUE(session_->finish());
            if (i == 3) settled = objects.live();
        }
        EXPECT_EQ(objects.live(), settled);
        session_.reset();
    }
    EXPECT_EQ(objects.live(), 0);
}

class SharedOnQueuesVk : public SharedVk {
 protected:
    void SetUp() override {
        queues_ = 3;
        make_device(true);
    }
};

TEST_F(SharedOnQueuesVk, OtherQueuesWaitForTheOldFrames) {
    begin();
    const vk::NativeResource marks = native("marks");
    for (const char* tier : {"async", "", "async", "drawn", ""}) {
        frames(2);
        (void)choose(tier);
        EXPECT_EQ(native("marks"), marks);
    }
    frames(1);
    EXPECT_EQ(first_word("words"), 11u);
    EXPECT_EQ(first_word("marks"), 101u);
}

}  // namespace
}  // namespace weft::test
