// Purpose: tests that a program that changes everything from frame to frame survives the loss of its device.
// It destroys the session and the device, creates them again, and goes on with the next frame.
#include "tests/render/engine/engine_run.h"

namespace weft::test {
namespace {

class DeviceLoss : public EngineRunTest {
 protected:
    // Leaks of objects are messages too.
    void destroy_the_device() {
        EXPECT_FALSE(device_->abandoned());
        for (const vk::Message& m : vk::destroy_device(std::move(device_)))
            ADD_FAILURE() << m.id << ": " << m.text;
    }
    void create_again() {
        destroy_the_device();
        make_device(true);
    }
    void TearDown() override {
        if (device_) destroy_the_device();
    }

    static void expect_no_costs(const CallCounts& counts) {
        EXPECT_EQ(counts.command_pools, 0) << "no new session";
        EXPECT_EQ(counts.allocations, 0);
        EXPECT_EQ(counts.idle_waits, 0);
        EXPECT_EQ(counts.pipelines, 0);
        EXPECT_GT(counts.submissions, 0);
    }

    // Compares the frames after the loss with those of a session that starts with the same frame on a device
    // that was never lost. Histories start anew in both.
    void expect_recovery(Loss loss) {
        const uint32_t half = frame_count() / 2, end = frame_count();
        const LongRun before = run({.end = half, .streams = true, .loss = loss});
        create_again();
        const Stretch stretch{.first = half, .end = end, .streams = true, .held = before.held};
        const LongRun after = run(stretch);
        create_again();
        const LongRun wanted = run(stretch);
        EXPECT_EQ(before.held, 2u);
        EXPECT_GE(before.parts + after.parts, frame_count() / 6 - 4);
        expect_no_costs(before.counts);
        expect_no_costs(after.counts);
        EXPECT_EQ(after.counts, wanted.counts);
        EXPECT_FALSE(wanted.picture.empty());
        EXPECT_TRUE(after.picture == wanted.picture);
        EXPECT_GT(after.images.size(), 40u);
        EXPECT_TRUE(after.images == wanted.images);
        expect_same_as_without_loss(after);
    }

    // Without `trail`, which mixes all earlier frames, the last frames look as if there were no loss.
    void expect_same_as_without_loss(const LongRun& after) {
        const LongRun whole = run({.end = frame_count(), .streams = true});
        uint32_t compared = 0;
        for (const auto& [name, bytes] : after.images) {
            if (name.starts_with("observe:trail") || name.ends_with(" " + std::to_string(frame_count() / 2)))
                continue;
            ++compared;
            ASSERT_TRUE(whole.images.contains(name)) << name;
            EXPECT_TRUE(whole.images.at(name) == bytes) << name;
        }
        EXPECT_GT(compared, 40u);
    }
};

class DeviceLossOnQueues : public DeviceLoss {
 protected:
    DeviceLossOnQueues() { queues_ = 3; }
};

TEST_F(DeviceLoss, AWaitNoticesItAndTheProgramGoesOn) {
    expect_recovery(Loss::in_wait);
}

TEST_F(DeviceLoss, ASubmissionNoticesItAndTheProgramGoesOn) {
    expect_recovery(Loss::in_submit);
}

TEST_F(DeviceLossOnQueues, ASubmissionInTheMiddleOfAFrameNoticesItAndTheProgramGoesOn) {
    expect_recovery(Loss::in_second_submit);
}

}  // namespace
}  // namespace weft::test
