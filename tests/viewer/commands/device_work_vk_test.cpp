// Runs the documentation's example graph for multisampling, blits, indirect draws and indirect dispatches.
// Compares the graph's images "color", "thumbnail" and "bars" with pictures or values that must be equal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/viewer/documentation/snippets.h"
#include "tests/viewer/gltf_file.h"
#include "tests/viewer/pictures/pfm_image.h"
#include "tests/viewer/program.h"

namespace weft::test {
namespace {

using Json = nlohmann::json;
using Texel = std::array<float, 3>;
// Number of objects in builtin:spheres: 7 x 7 spheres and the ground.
constexpr uint32_t kDraws = 50;
constexpr uint32_t kWidth = 121, kHeight = 86;

class DeviceWork : public testing::Test {
 protected:
    void SetUp() override {
        if (!has_device()) GTEST_SKIP() << "no Vulkan device";
        for (const auto& [name, content] : snippets_of("format.md")) folder_.write(name, content);
        graph_ = read_text(folder_ / "sparse.json");
    }

    // Renders one resource of the graph at its own size, and expects that the validation layer gives no
    // message. The graph draws only the objects whose index i satisfies i % every == first.
    PfmImage picture(const std::string& graph, const std::string& resource, uint32_t every, uint32_t first) {
        std::vector<std::string> arguments{
            "render",     "builtin:spheres",
            "--graph",    graph,
            "--size",     std::to_string(kWidth) + "x" + std::to_string(kHeight),
            "--param",    "every=" + std::to_string(every),
            "--param",    "first=" + std::to_string(first),
            "--frames",   "2",
            "--validate", "--stats",
            "stats.json", "-o",
            "picture.pfm"};
        if (!resource.empty()) arguments.insert(arguments.end(), {"--resource", resource});
        const RunResult run = run_weft(arguments, {}, folder_.path());
        EXPECT_EQ(run.exit_code, 0) << run.text();
        if (run.exit_code != 0) return {};
        EXPECT_EQ(Json::parse(read_text(folder_ / "stats.json")).at("validation").at("messages"), 0);
        return read_pfm(folder_ / "picture.pfm").value_or(PfmImage{});
    }

    ScratchFolder folder_;
    std::string graph_;
};

TEST_F(DeviceWork, DrawingByTheListsOwnCommandsIsDrawingTheList) {
    folder_.write("direct.json",
                  replaced(graph_, R"({ "list": "opaque", "indirect": "kept" })", R"(["opaque"])"));
    const PfmImage indirect = picture("sparse.json", "color", 1, 0),
                   direct = picture("direct.json", "color", 1, 0);
    ASSERT_EQ(direct.texels.size(), kWidth * kHeight);
    EXPECT_EQ(indirect.texels, direct.texels);
}

// The readback passes of the graph have nothing to do with --resource.
TEST_F(DeviceWork, AResourceIsWrittenAlsoIfTheGraphReadsAnotherOneBack) {
    std::string graph = graph_;
    graph.insert(graph.find("\"show\":"), R"("zLast": { "type": "readback", "in": ["bars"] }, )");
    folder_.write("reads.json", graph);
    const PfmImage alone = picture("sparse.json", "color", 1, 0), with = picture("reads.json", "color", 1, 0);
    ASSERT_EQ(with.texels.size(), kWidth * kHeight);
    EXPECT_EQ(with.texels, alone.texels);
}

// The three pictures show all objects, those with an even index, and those with an odd index. A pixel inside
// an object has the same colour in the first picture and in the second or third. A pixel at an edge is the
// average of several samples, so it may differ from the second and from the third picture.
TEST_F(DeviceWork, CulledDrawsAreGoneAndTheOthersAreThere) {
    const PfmImage all = picture("sparse.json", "color", 1, 0), even = picture("sparse.json", "color", 2, 0),
                   odd = picture("sparse.json", "color", 2, 1);
    ASSERT_EQ(all.texels.size(), kWidth * kHeight);
    ASSERT_EQ(even.texels.size(), all.texels.size());
    ASSERT_EQ(odd.texels.size(), all.texels.size());
    size_t only_even = 0, only_odd = 0, neither = 0;
    for (size_t i = 0; i < all.texels.size(); ++i) {
        const bool in_even = all.texels[i] == even.texels[i], in_odd = all.texels[i] == odd.texels[i];
        only_even += in_even && !in_odd;
        only_odd += in_odd && !in_even;
        neither += !in_even && !in_odd;
    }
    EXPECT_GT(only_even, all.texels.size() / 10);
    EXPECT_GT(only_odd, all.texels.size() / 10);
    EXPECT_LT(neither, all.texels.size() / 5) << "edges between the two";
    EXPECT_GT(neither, 0u) << "edges are averages";
}

Texel bilinear(const PfmImage& image, double x, double y) {
    const auto at = [&](double column, double row) {
        const double right = image.width_px - 1.0, bottom = image.height_px - 1.0;
        return image.at(static_cast<uint32_t>(std::clamp(column, 0.0, right)),
                        static_cast<uint32_t>(std::clamp(row, 0.0, bottom)));
    };
    const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
    const double u = x - 0.5 - left, v = y - 0.5 - top;
    Texel sum{};
    for (size_t c = 0; c < sum.size(); ++c)
        sum[c] = static_cast<float>((1 - v) * ((1 - u) * at(left, top)[c] + u * at(left + 1, top)[c]) +
                                    v * ((1 - u) * at(left, top + 1)[c] + u * at(left + 1, top + 1)[c]));
    return sum;
}

TEST_F(DeviceWork, TheThumbnailIsThePictureFilteredLinearly) {
    const PfmImage color = picture("sparse.json", "color", 2, 0),
                   small = picture("sparse.json", "thumbnail", 2, 0);
    ASSERT_EQ(small.width_px, (kWidth + 7) / 8);
    ASSERT_EQ(small.height_px, (kHeight + 7) / 8);
    for (uint32_t y = 0; y < small.height_px; ++y)
        for (uint32_t x = 0; x < small.width_px; ++x) {
            const Texel wanted =
                bilinear(color, (x + 0.5) * kWidth / small.width_px, (y + 0.5) * kHeight / small.height_px);
            // The tolerance covers two roundings: of the values to half floats, and of the position between
            // two texels to eight bits.
            for (size_t c = 0; c < 3; ++c) ASSERT_NEAR(small.at(x, y)[c], wanted[c], 0.005) << x << ", " << y;
        }
}

TEST_F(DeviceWork, ThereAreAsManyBarsAsDraws) {
    for (const uint32_t every : {2u, 7u}) {
        const PfmImage bars = picture("sparse.json", "bars", every, 1);
        ASSERT_EQ(bars.width_px, 8 * kDraws);
        const uint32_t count = (kDraws - 1 + every - 1) / every;
        for (uint32_t x = 0; x < bars.width_px; ++x)
            ASSERT_EQ(bars.at(x, 5)[0], x / 8 < count && x % 8 < 6 ? 1 : 0) << x;
    }
}

TEST_F(DeviceWork, ABufferWithoutRoomForTheListIsRefused) {
    folder_.write("short.json", replaced(graph_, R"("count": "opaqueDraws")", R"("count": 49)"));
    EXPECT_EQ(run_weft({"check", "short.json"}, {}, folder_.path()).exit_code, 0) << "it knows no scene";
    const RunResult run =
        run_weft({"render", "builtin:spheres", "--graph", "short.json", "-o", "a.png"}, {}, folder_.path());
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.err.find("short.json:17:76:"), std::string::npos) << run.text();
    EXPECT_NE(run.err.find("the 50 draws of \"opaque\" need 1000"), std::string::npos) << run.text();
}

}  // namespace
}  // namespace weft::test
