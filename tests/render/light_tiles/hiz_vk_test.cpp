// Tests that every texel of every Hi-Z mip level is the exact depth range (nearest, farthest) of the pixels
// that it covers. The test uses many picture sizes.
#include <algorithm>
#include <map>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr uint32_t kMips = 7;

// Depth is reversed: 1 at the near plane, 0 in the sky. Sky pixels do not count. The initial values are those
// of an empty range.
struct DepthRange {
    float nearest = 0, farthest = 1;
    void add(float z) {
        if (z <= 0) return;
        nearest = std::max(nearest, z);
        farthest = std::min(farthest, z);
    }
};

// Computes the correct result directly: the depth range of the pixels in each square of `side` x `side`
// pixels.
std::vector<DepthRange> ranges(const std::vector<glm::vec4>& depth, Extent3D size, uint32_t side,
                               uint32_t columns, uint32_t rows) {
    std::vector<DepthRange> found(size_t{columns} * rows);
    for (uint32_t y = 0; y < size.height; ++y)
        for (uint32_t x = 0; x < size.width; ++x)
            found.at(size_t{y / side} * columns + x / side).add(depth[size_t{y} * size.width + x].r);
    return found;
}

class HiZ : public SessionTest {
 protected:
    using Images = std::map<std::string, std::vector<glm::vec4>>;

    void expect_exact(const Images& images, Extent3D size) {
        const uint32_t across = (size.width + 127) / 128, down = (size.height + 127) / 128;
        for (uint32_t mip = 0; mip < kMips; ++mip) {
            const std::vector<glm::vec4>& texels = images.at("hiz.mip(" + std::to_string(mip) + ")");
            const uint32_t columns = across * 64 >> mip, rows = down * 64 >> mip;
            ASSERT_EQ(texels.size(), size_t{columns} * rows);
            const std::vector<DepthRange> wanted = ranges(images.at("depth"), size, 2u << mip, columns, rows);
            size_t wrong = 0;
            for (size_t i = 0; i < texels.size(); ++i)
                wrong += texels[i].r != wanted[i].nearest || texels[i].g != wanted[i].farthest ? 1u : 0u;
            EXPECT_EQ(wrong, 0u) << size.width << " × " << size.height << ", mip " << mip;
            texels_ += texels.size();
        }
    }

    // Renders two frames with different depths for each size, and checks every texel of every mip level.
    void run(const std::vector<Extent3D>& sizes) {
        std::vector<std::string> observed{"depth"};
        for (uint32_t mip = 0; mip < kMips; ++mip) observed.push_back("hiz.mip(" + std::to_string(mip) + ")");
        const std::unique_ptr<render::Session> session =
            start(WEFT_SOURCE_DIR "/tests/render/light_tiles/hiz.json", sizes.front(), observed);
        ASSERT_TRUE(session);
        for (const Extent3D& size : sizes) {
            ASSERT_TRUE(session->resize(size, warnings_));
            for (int frame = 0; frame < 2; ++frame) ASSERT_TRUE(draw_frame(*session));
            ASSERT_TRUE(session->finish());
            std::map<uint64_t, Images> frames;
            for (const vk::ReadbackData& data : session->take_readbacks())
                frames[data.frame_index][data.pass.substr(std::string("observe:").size())] =
                    render::decode_texels(data.format, data.bytes);
            ASSERT_EQ(frames.size(), 2u);
            for (const auto& [index, images] : frames) ASSERT_NO_FATAL_FAILURE(expect_exact(images, size));
        }
        std::printf("%zu sizes, %zu texels\n", sizes.size(), texels_);
    }

    size_t texels_ = 0;
};

TEST_F(HiZ, IsExactAtOddSizes) {
    run({{1366, 768, 1}, {961, 541, 1}, {3, 3, 1}});
}

TEST_F(HiZ, IsExactInRows) {
    std::vector<Extent3D> sizes;
    for (uint32_t n = 1; n <= 70; ++n) sizes.push_back({n, 1, 1});
    run(sizes);
}

TEST_F(HiZ, IsExactInColumns) {
    std::vector<Extent3D> sizes;
    for (uint32_t n = 1; n <= 70; ++n) sizes.push_back({1, n, 1});
    run(sizes);
}

// Tests sizes just below, at and above a multiple of 128 pixels, in both directions, because a workgroup of
// the Hi-Z shader covers 128 × 128 pixels.
TEST_F(HiZ, IsExactAroundSquares) {
    run({{127, 129, 1}, {128, 128, 1}, {129, 127, 1}, {257, 130, 1}});
}

}  // namespace
}  // namespace weft::test
