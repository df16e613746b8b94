// Tests shading with one light list per tile of 16 × 16 pixels, in deferred and in forward shading. The
// picture must be nearly the same as with a loop over all lights. Each tile also has a class, such as "sky".
// There is one list of tiles for each class, and each tile must be only in the list of its class.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <set>

#include "scene/builtin/seeded_lights.h"
#include "tests/render/session_fixture.h"

namespace weft::test {
namespace {

constexpr Extent3D kTileShadingSize{320, 180, 1};
// kListBegin: index of the first tile in a list of tiles. The words before it are three workgroup counts.
constexpr uint32_t kLights = 1024, kTilePx = 16, kListBegin = 3;
constexpr size_t kTiles = size_t{(kTileShadingSize.width + kTilePx - 1) / kTilePx} *
                          ((kTileShadingSize.height + kTilePx - 1) / kTilePx);

class TileShading : public SessionTest {
 protected:
    // Renders one frame and returns the bytes of the observed resources, by name.
    std::map<std::string, std::vector<std::byte>> bytes_of(const scene::Scene& scene,
                                                           const std::string& graph,
                                                           std::vector<std::string> observed,
                                                           size_t camera = 0) {
        const std::unique_ptr<render::Session> session =
            start(scene, scene.cameras.at(camera), graph_path(graph), kTileShadingSize, std::move(observed),
                  scene.exposure_ev);
        if (!session || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "no picture of " << graph;
            return {};
        }
        std::map<std::string, std::vector<std::byte>> found;
        for (vk::ReadbackData& data : session->take_readbacks())
            found[data.pass.substr(std::string("observe:").size())] = std::move(data.bytes);
        return found;
    }
    template <class Word>
    static std::vector<Word> words(const std::vector<std::byte>& bytes) {
        std::vector<Word> out(bytes.size() / sizeof(Word));
        std::memcpy(out.data(), bytes.data(), out.size() * sizeof(Word));
        return out;
    }
    std::vector<uint16_t> hdr_of(const scene::Scene& scene, const std::string& graph) {
        return words<uint16_t>(bytes_of(scene, graph, {"hdr"})["hdr"]);
    }
    // Splits a buffer of light lists into one list of light indices for each tile. In the buffer, each tile
    // has the same number of words: the length of its list, the light indices, then unused words.
    static std::vector<std::vector<uint32_t>> lists_in(const std::vector<std::byte>& bytes) {
        const std::vector<uint32_t> all = words<uint32_t>(bytes);
        const size_t stride = all.size() / kTiles;
        std::vector<std::vector<uint32_t>> lists;
        for (size_t tile = 0; tile < kTiles && stride > 0; ++tile) {
            const auto length = all.begin() + static_cast<std::ptrdiff_t>(tile * stride);
            EXPECT_LT(*length, stride) << "tile " << tile;
            if (*length < stride) lists.emplace_back(length + 1, length + 1 + *length);
        }
        return lists;
    }
    void expect_same(const scene::Scene& scene, const std::string& culled, const std::string& all) {
        const std::vector<uint16_t> found = hdr_of(scene, culled), wanted = hdr_of(scene, all);
        ASSERT_EQ(found.size(), size_t{kTileShadingSize.width} * kTileShadingSize.height * 4);
        ASSERT_EQ(found.size(), wanted.size());
        size_t differ = 0, lit = 0;
        int worst = 0;
        for (size_t i = 0; i < found.size(); ++i) {
            // The bits of non-negative half floats are compared as integers. A difference of 1 means that the
            // two values are neighbouring half floats.
            const int off = std::abs(int{found[i]} - int{wanted[i]});
            differ += off > 0 ? 1 : 0;
            lit += i % 4 != 3 && wanted[i] > 0 ? 1 : 0;
            worst = std::max(worst, off);
        }
        std::printf("%s, %s against %s: %zu of %zu numbers differ, by %d steps of a half float at most\n",
                    scene.name.c_str(), culled.c_str(), all.c_str(), differ, found.size(), worst);
        EXPECT_LE(worst, 1) << scene.name << " by " << culled;
        EXPECT_GT(lit, found.size() / 4) << "it is dark";
    }
};

// Returns two scenes with very different depth ranges. Each has kLights lights.
std::vector<scene::Scene> crowded_scenes() {
    std::vector<scene::Scene> scenes;
    scene::BuiltinOptions options;
    options.lights = kLights;
    scenes.push_back(std::move(scene::make_builtin("lights", options)).value());
    scenes.push_back(std::move(scene::make_builtin("spheres")).value());
    const std::vector<scene::Light> many = scene::seeded_lights(scenes[1], kLights - 1, 1);
    scenes[1].lights.insert(scenes[1].lights.end(), many.begin(), many.end());
    return scenes;
}

TEST_F(TileShading, DeferredPicturesAreThoseOfAllLights) {
    for (const scene::Scene& scene : crowded_scenes()) expect_same(scene, "light_indexed", "deferred");
}

TEST_F(TileShading, ForwardPicturesAreThoseOfAllLights) {
    for (const scene::Scene& scene : crowded_scenes()) expect_same(scene, "forward_plus", "forward");
}

// Tests that both graphs make the same light lists, although light_indexed.json takes the depth from the
// G-buffer pass and forward_plus.json from a separate depth pass. Without the environment variable
// WEFT_EXTENDED, only the first camera is tested.
TEST_F(TileShading, DeferredAndForwardHaveTheSameLists) {
    const scene::Scene scene = crowded_scenes()[0];
    const std::vector<std::string> names{"tileLights", "glass::tileLights"};
    const size_t cameras = std::getenv("WEFT_EXTENDED") != nullptr ? scene.cameras.size() : 1;
    for (size_t camera = 0; camera < cameras; ++camera) {
        auto deferred = bytes_of(scene, "light_indexed", names, camera);
        auto forward = bytes_of(scene, "forward_plus", names, camera);
        for (const std::string& name : names) {
            const std::vector<std::vector<uint32_t>> lists = lists_in(deferred[name]);
            EXPECT_EQ(lists, lists_in(forward[name])) << name << ", camera " << camera;
            size_t listed = 0;
            for (const std::vector<uint32_t>& list : lists) listed += list.size();
            std::printf("camera %zu, %s: %zu lights in %zu lists\n", camera, name.c_str(), listed,
                        lists.size());
            EXPECT_EQ(lists.size(), kTiles);
            EXPECT_GT(listed, 100u);
        }
    }
}

TEST_F(TileShading, EachTileIsInTheListOfItsClass) {
    // The upper part of the picture is sky (skyTiles). The lamp lights only the middle of the ground
    // (punctualTiles). The edge of the ground is out of its range (directionalTiles). anyTiles is for area
    // lights and light functions, which this scene does not have.
    scene::Scene scene = std::move(scene::make_builtin("spheres")).value();
    scene.lights[0].range_m = 6;
    scene.cameras[0].transform = scene::framing_camera(scene, 16.0f / 9).transform;
    scene.cameras[0].fov_y_rad = 1.4f;
    const std::vector<std::string> names{"skyTiles", "directionalTiles", "punctualTiles", "anyTiles"};
    std::vector<std::string> observed = names;
    observed.insert(observed.end(), {"depth", "tileLights"});
    std::map<std::string, std::vector<std::byte>> found = bytes_of(scene, "light_indexed", observed);
    const std::vector<float> depth = words<float>(found["depth"]);
    const std::vector<uint32_t> lights = words<uint32_t>(found["tileLights"]);
    const uint32_t columns = (kTileShadingSize.width + kTilePx - 1) / kTilePx,
                   rows = (kTileShadingSize.height + kTilePx - 1) / kTilePx;
    const size_t stride = lights.size() / (size_t{columns} * rows);
    std::vector<bool> surface(size_t{columns} * rows, false);
    for (uint32_t y = 0; y < kTileShadingSize.height; ++y)
        for (uint32_t x = 0; x < kTileShadingSize.width; ++x)
            if (depth[size_t{y} * kTileShadingSize.width + x] > 0)
                surface[size_t{y / kTilePx} * columns + x / kTilePx] = true;
    std::vector<std::vector<uint32_t>> wanted(names.size());
    for (uint32_t tile = 0; tile < columns * rows; ++tile)
        wanted[!surface[tile] ? 0 : lights[tile * stride] == 0 ? 1 : 2].push_back(tile);
    for (size_t i = 0; i < names.size(); ++i) {
        const std::vector<uint32_t> list = words<uint32_t>(found[names[i]]);
        ASSERT_GE(list.size(), kListBegin + wanted[i].size()) << names[i];
        EXPECT_EQ(list[0], wanted[i].size()) << names[i];
        EXPECT_EQ(list[1] * list[2], 1u) << names[i];
        EXPECT_TRUE(std::equal(wanted[i].begin(), wanted[i].end(), list.begin() + kListBegin)) << names[i];
        EXPECT_EQ(wanted[i].empty(), names[i] == "anyTiles") << names[i] << " shows nothing here";
    }
}

}  // namespace
}  // namespace weft::test
