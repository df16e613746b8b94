// Purpose: test fixture that renders one frame of a graph with light tiles, and reads back the light lists
// and the data from which they were made.
#pragma once

#include <algorithm>
#include <cstring>

#include "tests/render/light_tiles/light_reference.h"
#include "tests/render/session_fixture.h"

namespace weft::test {

struct TileFrame {
    Extent3D size;
    shared::ViewConstants view{};
    std::vector<float> depth, glass_depth;
    std::vector<shared::Light> lights;
    // Number of directional lights. They are the first elements of `lights`.
    uint32_t directional = 0;
    // The words of the buffers as the GPU wrote them.
    std::vector<uint32_t> tile_lights, overflow, mask, glass_lights;

    [[nodiscard]] uint32_t across() const { return (size.width + kTilePx - 1) / kTilePx; }
    [[nodiscard]] uint32_t tiles() const { return across() * ((size.height + kTilePx - 1) / kTilePx); }
};

// Returns the light indices in the list of a tile, in the order of the list. The first word of a list is the
// number of lights.
inline std::vector<uint32_t> list_of(const TileFrame& frame, const std::vector<uint32_t>& words,
                                     uint32_t tile) {
    const size_t begin = size_t{tile} * (words.size() / frame.tiles());
    const auto first = words.begin() + static_cast<std::ptrdiff_t>(begin) + 1;
    return {first, first + words.at(begin)};
}

class TileTest : public SessionTest {
 protected:
    using Params = std::map<std::string, double>;

    // Renders one frame and returns the observed buffers. On any error, the test fails and the frame is
    // empty.
    TileFrame tiles(const std::string& graph, const scene::Scene& scene, const scene::Camera& camera,
                    Extent3D size, const Params& params, std::vector<std::string> observed) {
        passes_ = registered_passes();
        render::SessionInput input;
        input.adds_parts = false;
        input.request.path = WEFT_SOURCE_DIR "/tests/render/light_tiles/" + graph;
        input.load.reader = read_text;
        input.load.graph_root = WEFT_SOURCE_DIR "/graphs";
        input.load.shader_root = WEFT_SOURCE_DIR "/shaders";
        input.load.shader_cache = WEFT_TEST_CACHE;
        input.passes = &passes_;
        input.request.size = size;
        input.request.params = params;
        input.request.observed = std::move(observed);
        input.check_plan = true;
        Result<std::unique_ptr<render::Session>> session =
            render::Session::create(*device_, scene, input, warnings_);
        Status done = session ? (*session)->render_frame({.camera = camera}) : Status{session.take_errors()};
        if (done) done = (*session)->finish();
        if (!done) {
            ADD_FAILURE() << to_text(done.errors());
            return {};
        }
        TileFrame frame;
        frame.size = size;
        frame.view = (*session)->parts().frames.view();
        frame.lights = (*session)->parts().scene.lights();
        for (const shared::Light& light : frame.lights)
            frame.directional += light.type == shared::kLightDirectional ? 1u : 0u;
        for (const vk::ReadbackData& data : (*session)->take_readbacks()) store(data, frame);
        return frame;
    }

 private:
    template <typename T>
    static void copy(const std::vector<std::byte>& bytes, std::vector<T>& to) {
        to.resize(bytes.size() / sizeof(T));
        std::memcpy(to.data(), bytes.data(), to.size() * sizeof(T));
    }
    static void store(const vk::ReadbackData& data, TileFrame& frame) {
        const std::string name = data.pass.substr(std::string("observe:").size());
        if (name == "depth") copy(data.bytes, frame.depth);
        if (name == "glassDepth") copy(data.bytes, frame.glass_depth);
        if (name == "tileLights") copy(data.bytes, frame.tile_lights);
        if (name == "tileOverflow") copy(data.bytes, frame.overflow);
        if (name == "tileMask") copy(data.bytes, frame.mask);
        if (name == "glassLights") copy(data.bytes, frame.glass_lights);
        if (name != "lights") return;
        // The buffer has room for more lights than the scene has. Only the lights of the scene are kept.
        const size_t count = frame.lights.size();
        copy(data.bytes, frame.lights);
        frame.lights.resize(count);
    }
};

// Sums over all tiles: entries of the light lists (`listed`), lights that reach a pixel of the tile
// (`needed`), and needed lights that are not in the tile's list (`missed`).
struct Comparison {
    size_t listed = 0, needed = 0, missed = 0;
    [[nodiscard]] double in_vain_percent() const {
        return listed == 0
                   ? 0
                   : 100.0 * static_cast<double>(listed + missed - needed) / static_cast<double>(listed);
    }
};

inline Comparison compare(const TileFrame& frame) {
    std::vector<BoundingSphere> spheres;
    for (const shared::Light& light : frame.lights) spheres.push_back(sphere_around(light));
    const TilePlaces places = tile_places(frame.depth, frame.size, frame.view);
    Comparison sum;
    for (uint32_t tile = 0; tile < frame.tiles(); ++tile) {
        const std::vector<uint32_t> listed = list_of(frame, frame.tile_lights, tile);
        const std::vector<uint32_t> needed =
            lights_of_tile(places[tile], frame.lights, spheres, frame.directional);
        sum.listed += listed.size();
        sum.needed += needed.size();
        for (const uint32_t light : needed) sum.missed += std::ranges::binary_search(listed, light) ? 0u : 1u;
    }
    return sum;
}

}  // namespace weft::test
