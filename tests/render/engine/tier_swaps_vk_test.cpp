// Tests changes of the tier of graphs/weft.json while frames are rendered: no swap waits for the device,
// allocates memory or makes pipelines on the thread that renders; no picture is black; a resize during a swap
// and a tier with errors leave a running graph; nothing remains behind.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <future>

#include "tests/render/engine/call_counter.h"
#include "tests/render/session/object_counter.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

const std::string kWeft = WEFT_SOURCE_DIR "/graphs/weft.json";
constexpr const char* kTiers[] = {"low", "high", "medium", "ultra"};
constexpr uint32_t kFramesOfATier = 2;

class TierSwaps : public SessionTest {
 protected:
    void begin() {
        params_ = {{"lampShadowMaps", 0}};
        session_ = start(kWeft, {64, 36, 1});
        ASSERT_TRUE(session_);
    }
    void draw() {
        const Status done = draw_frame(*session_);
        ASSERT_TRUE(done) << to_text(done.errors());
        const Result<vk::ReadbackData> output = session_->read_output();
        ASSERT_TRUE(output) << to_text(output.errors());
        picture_ = output->bytes;
        EXPECT_TRUE(std::ranges::any_of(picture_, [](std::byte b) {
            return b > std::byte{16} && b < std::byte{255};
        })) << "the picture is black";
        ++drawn_;
    }
    // Prepares the tier on another thread while frames are rendered. `resizes`: the size of the output
    // changes meanwhile, so the first preparation is void, and is done again.
    render::PrepareResult prepared(const std::string& tier, bool resizes) {
        for (;;) {
            render::Selection selection = session_->selection();
            selection.request.tier = tier;
            std::future<render::PrepareResult> made =
                std::async(std::launch::async, [&] { return session_->prepare(selection); });
            do draw();
            while (made.wait_for(std::chrono::seconds(0)) != std::future_status::ready && !HasFatalFailure());
            render::PrepareResult result = made.get();
            if (!resizes) return result;
            resizes = false;
            const Extent3D now = session_->selection().request.size;
            const Status done = session_->resize({now.width == 64 ? 71u : 64u, 36, 1}, warnings_);
            EXPECT_TRUE(done) << to_text(done.errors());
            const Result<bool> swapped = session_->swap_in(std::move(*result.result));
            EXPECT_TRUE(swapped && !*swapped) << "the preparation was for the graph before the resize";
        }
    }
    void swap_to(const std::string& tier, bool resizes) {
        render::PrepareResult next = prepared(tier, resizes);
        ASSERT_TRUE(next.result) << to_text(next.result.errors());
        CallCounts counts;
        {
            const CallCounter counter(*device_);
            const Result<bool> swapped = session_->swap_in(std::move(*next.result));
            ASSERT_TRUE(swapped && *swapped);
            const Status done = draw_frame(*session_);
            ASSERT_TRUE(done) << to_text(done.errors());
            counts = counter.counts();
        }
        EXPECT_EQ(counts.allocations, 0);
        EXPECT_EQ(counts.idle_waits, 0);
        EXPECT_EQ(counts.pipelines, 0);
        for (uint32_t i = 0; i < kFramesOfATier; ++i) draw();
    }
    // Returns the largest peak of device memory, divided by the memory that the larger one of the two tiers
    // needs.
    double swap_through_all(uint32_t cycle, ObjectCounter& objects) {
        double most = 0;
        for (size_t i = 0; i < std::size(kTiers) && !HasFatalFailure(); ++i) {
            const bool resizes = cycle % 10 == 0 && i == cycle / 10 % std::size(kTiers);
            const uint64_t before = objects.live_bytes();
            (void)objects.take_most_bytes();
            swap_to(kTiers[i], resizes);
            EXPECT_TRUE(session_->finish());
            const uint64_t larger = std::max(before, objects.live_bytes());
            if (!resizes) most = std::max(most, double(objects.take_most_bytes()) / double(larger));
        }
        return most;
    }

    std::unique_ptr<render::Session> session_;
    std::vector<std::byte> picture_;
    uint32_t drawn_ = 0;
};

TEST_F(TierSwaps, DelayNoFrameAndLeaveNothingBehind) {
    const uint32_t cycles = std::getenv("WEFT_EXTENDED") != nullptr ? 100 : 3;
    ObjectCounter objects(*device_);
    begin();
    Leftovers settled;
    double most_memory = 0;
    for (uint32_t cycle = 0; cycle < cycles && !HasFatalFailure(); ++cycle) {
        SCOPED_TRACE("cycle " + std::to_string(cycle));
        most_memory = std::max(most_memory, swap_through_all(cycle, objects));
        ASSERT_TRUE(session_->finish());
        if (cycle == 1) settled = {objects.live(), resident_bytes()};
    }
    // Odd cycles end at the same size as cycle 1, because only cycles 0, 10, 20 … change it.
    const Leftovers last{objects.live(), resident_bytes()};
    std::printf(
        "%u cycles, %u frames: objects %lld after two cycles, %lld at last; resident KiB %llu and %llu\n",
        cycles, drawn_, static_cast<long long>(settled.objects), static_cast<long long>(last.objects),
        static_cast<unsigned long long>(settled.bytes / 1024),
        static_cast<unsigned long long>(last.bytes / 1024));
    std::printf("peak of device memory in a swap: %.2f times that of the larger tier\n", most_memory);
    EXPECT_LT(most_memory, 2) << "two plans, of which the smaller one shares memory with the larger one";
    EXPECT_EQ(last.objects, settled.objects);
    EXPECT_EQ(session_->pipelines_made_between_frames(), 0u);
    session_.reset();
    EXPECT_EQ(objects.live(), 0);
}

// After a change to `low` and back, the histories begin again, and soon the picture is that of a program that
// has always used the tier.
TEST_F(TierSwaps, SoonLookLikeAProgramThatNeverSwapped) {
    constexpr uint32_t kFrames = 24;
    begin();
    swap_to("low", false);
    swap_to("ultra", false);
    for (uint32_t i = 0; i < kFrames; ++i) draw();
    const std::vector<std::byte> swapped = picture_;
    begin();
    swap_to("ultra", false);
    for (uint32_t i = 0; i < kFrames; ++i) draw();
    double sum = 0;
    for (size_t i = 0; i < picture_.size(); ++i)
        sum += std::abs(std::to_integer<int>(picture_[i]) - std::to_integer<int>(swapped[i]));
    const double mean = sum / static_cast<double>(picture_.size());
    std::printf("mean difference %.3f of 255\n", mean);
    EXPECT_LT(mean, 1);
}

TEST_F(TierSwaps, ATierWithErrorsLeavesTheOldOneRunning) {
    begin();
    draw();
    render::PrepareResult next = prepared("lowest", false);
    ASSERT_FALSE(next.result);
    EXPECT_EQ(next.result.errors().front().code, "W129");
    draw();
    EXPECT_EQ(session_->selection().request.tier, "");
}

}  // namespace
}  // namespace weft::test
