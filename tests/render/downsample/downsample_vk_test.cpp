// Purpose: makes the mips of images in one pass (shaders/downsample/downsample.comp) and in a chain of
// passes. Both must agree bit for bit, and with a reduction on the CPU. Sizes: 1366 x 768, and random sizes
// with odd sides, sides of one texel, and powers of two.
#include <algorithm>
#include <cstring>
#include <random>

#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

struct Mip {
    uint32_t width = 1, height = 1;
    std::vector<float> texels;
    [[nodiscard]] float at(uint32_t x, uint32_t y) const { return texels[size_t{y} * width + x]; }
};

// Returns the values that fill.comp writes.
Mip filled(Extent3D size, uint32_t frame) {
    Mip mip{size.width, size.height, {}};
    for (uint32_t y = 0; y < size.height; ++y)
        for (uint32_t at = 0; at < size.width; ++at) {
            uint32_t x = at * 747796405u + y * 2891336453u + frame * 277803737u;
            x = (x >> 15 ^ x) * 2246822519u;
            x = (x >> 13 ^ x) * 3266489917u;
            mip.texels.push_back(static_cast<float>((x >> 16 ^ x) >> 8) / 16777216.0F);
        }
    return mip;
}

enum class Reduction : uint8_t { least, greatest, mean };

// Reduces a mip. Texel (x, y) is found by the texels that belong to it: texel p of a side belongs to texel p
// / 2, and the last texel of an odd side belongs to the last texel of the result.
Mip reduced(const Mip& from, Reduction reduction) {
    Mip to{std::max(from.width / 2, 1u), std::max(from.height / 2, 1u), {}};
    std::vector<std::vector<float>> members(size_t{to.width} * to.height);
    for (uint32_t y = 0; y < from.height; ++y)
        for (uint32_t x = 0; x < from.width; ++x)
            members[size_t{std::min(y / 2, to.height - 1)} * to.width + std::min(x / 2, to.width - 1)]
                .push_back(from.at(x, y));
    for (const std::vector<float>& texels : members) {
        double sum = 0;
        for (const float texel : texels) sum += static_cast<double>(texel);
        to.texels.push_back(reduction == Reduction::least ? std::ranges::min(texels)
                            : reduction == Reduction::greatest
                                ? std::ranges::max(texels)
                                : static_cast<float>(sum / static_cast<double>(texels.size())));
    }
    return to;
}

std::vector<float> chain_of(const Mip& first, Reduction reduction) {
    std::vector<float> all = first.texels;
    for (Mip mip = first; mip.width > 1 || mip.height > 1;) {
        mip = reduced(mip, reduction);
        all.insert(all.end(), mip.texels.begin(), mip.texels.end());
    }
    return all;
}

class Downsample : public SessionTest {
 protected:
    void expect_mips(Extent3D size) {
        SCOPED_TRACE(std::to_string(size.width) + " x " + std::to_string(size.height));
        const std::unique_ptr<render::Session> session =
            start(WEFT_SOURCE_DIR "/tests/render/downsample/downsample.json", size,
                  {"least", "leastChain", "greatest", "greatestChain", "mean", "meanChain"});
        ASSERT_TRUE(session);
        // The second frame begins with the counter that the first one has left.
        constexpr uint32_t kFrames = 2;
        for (uint32_t i = 0; i < kFrames; ++i) ASSERT_TRUE(draw_frame(*session));
        ASSERT_TRUE(session->finish());
        std::map<std::string, std::vector<std::vector<float>>> images;
        for (const vk::ReadbackData& data : session->take_readbacks()) {
            std::vector<float> texels(data.bytes.size() / sizeof(float));
            std::memcpy(texels.data(), data.bytes.data(), data.bytes.size());
            images[data.pass.substr(std::string("observe:").size())].push_back(std::move(texels));
        }
        for (uint32_t frame = 0; frame < kFrames; ++frame) {
            const Mip first = filled(size, frame);
            for (const auto& [name, reduction] :
                 {std::pair{"least", Reduction::least}, std::pair{"greatest", Reduction::greatest},
                  std::pair{"mean", Reduction::mean}}) {
                ASSERT_EQ(images[name].size(), kFrames);
                const std::vector<float>& found = images[name][frame];
                EXPECT_TRUE(found == images[name + std::string("Chain")][frame])
                    << name << ", frame " << frame;
                expect_near(found, chain_of(first, reduction), reduction == Reduction::mean ? 1e-5F : 0,
                            name);
            }
        }
    }

    static void expect_near(const std::vector<float>& found, const std::vector<float>& wanted, float error,
                            const char* name) {
        ASSERT_EQ(found.size(), wanted.size()) << name;
        for (size_t i = 0; i < found.size(); ++i)
            ASSERT_NEAR(found[i], wanted[i], error) << name << ", texel " << i << " of all mips";
    }
};

TEST_F(Downsample, OnePassMakesAllMipsOfAPicture) {
    expect_mips({1366, 768, 1});
}

TEST_F(Downsample, OnePassMakesAllMipsOfEachSize) {
    constexpr uint32_t kSeed = 20261124;
    std::mt19937 random(kSeed);
    const auto side = [&](uint32_t most) { return 1 + static_cast<uint32_t>(random() % most); };
    std::vector<Extent3D> sizes{{1, 300, 1}, {256, 64, 1}, {127, 129, 1}, {65, 2, 1}};
    if (std::getenv("WEFT_EXTENDED") != nullptr) {
        sizes.push_back({4096, 1, 1});
        sizes.push_back({2, 1, 1});
        for (int i = 0; i < 20; ++i) sizes.push_back({side(700), side(700), 1});
    }
    sizes.push_back({side(300) | 1, side(300) | 1, 1});
    for (const Extent3D& size : sizes) expect_mips(size);
    std::cout << "seed " << kSeed << ": " << sizes.size() << " sizes\n";
}

}  // namespace
}  // namespace weft::test
