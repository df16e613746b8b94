// Tests passes with `perFrame`. The first frame runs all of them. Each later frame runs only one of them, and
// the results of the others are kept.
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

class FrameSlices : public SessionTest {};

TEST_F(FrameSlices, TheFirstFrameRunsAllAndLaterOnesOneEach) {
    const std::unique_ptr<render::Session> session =
        start(WEFT_SOURCE_DIR "/tests/render/frame_slices/frame_slices.json", {8, 8, 1}, {"probe"});
    ASSERT_TRUE(session);
    constexpr uint32_t kFrames = 8, kLayers = 3;
    for (uint32_t i = 0; i < kFrames; ++i) ASSERT_TRUE(draw_frame(*session));
    ASSERT_TRUE(session->finish());
    const std::vector<vk::ReadbackData> readbacks = session->take_readbacks();
    ASSERT_EQ(readbacks.size(), kFrames);
    std::array<float, kLayers> wanted{0, 100, 200};
    for (uint32_t frame = 0; frame < kFrames; ++frame) {
        const uint32_t slice = frame % kLayers;
        if (frame > 0) wanted[slice] = static_cast<float>(100 * slice + frame);
        const std::vector<glm::vec4> texels =
            render::decode_texels(readbacks[frame].format, readbacks[frame].bytes);
        ASSERT_EQ(texels.size(), 16u * kLayers);
        for (uint32_t i = 0; i < texels.size(); ++i)
            EXPECT_EQ(texels[i].x, wanted[i / 16]) << "frame " << frame << ", layer " << i / 16;
    }
}

}  // namespace
}  // namespace weft::test
