// Purpose: test fixture that reads the sun shadows that a graph computes, at arbitrary world positions or for
// the surface in each pixel.
#pragma once

#include <sstream>

#include "tests/render/session_fixture.h"

namespace weft::test {

inline constexpr uint32_t kGrid = 384;
inline const std::string kSunGraphs = WEFT_SOURCE_DIR "/tests/render/sun/";

// A grid of world positions with kGrid rows and columns. `right` and `down` are the steps to the next column
// and to the next row. The image `seen` in grid.json must have kGrid × kGrid texels.
struct Grid {
    glm::vec3 corner{0}, right{0}, down{0};
    [[nodiscard]] glm::vec3 at(uint32_t i) const {
        return corner + right * static_cast<float>(i % kGrid) + down * static_cast<float>(i / kGrid);
    }
};

inline std::string list_of(const glm::vec3& v) {
    std::ostringstream text;
    text.precision(9);
    text << "[" << v.x << ", " << v.y << ", " << v.z << "]";
    return text.str();
}

inline void put(std::string& text, const std::string& word, const glm::vec3& value) {
    const size_t at = text.find("\"" + word + "\"");
    if (at != std::string::npos) text.replace(at, word.size() + 2, list_of(value));
}

struct Seen {
    // Share of the sun's light that reaches each point, from 0 to 1.
    std::vector<float> share;
    // Octahedral normals of the pixels. `normals` and `depths` are empty if the test does not observe these
    // images.
    std::vector<glm::vec4> normals;
    // Depth of each pixel: the distance of the near plane divided by the distance of the surface. Both are
    // measured along the view direction.
    std::vector<glm::vec4> depths;
    render::SunCascades sun;
    glm::vec3 eye{0};
};

class SunShadows : public SessionTest {
 protected:
    Seen look(const scene::Scene& scene, const scene::Camera& camera, const Grid& grid) {
        const FileReader reader = [&](const std::string& path) {
            std::optional<std::string> text = read_text(path);
            if (!text || !path.ends_with("grid.json")) return text;
            put(*text, "CORNER", grid.corner);
            put(*text, "RIGHT", grid.right);
            put(*text, "DOWN", grid.down);
            return text;
        };
        return run(start(scene, camera, kSunGraphs + "grid.json", {320, 180, 1}, {"seen"}, 0, reader));
    }
    static Seen run(const std::unique_ptr<render::Session>& session) {
        Seen seen;
        if (!session || !draw_frame(*session) || !session->finish()) {
            ADD_FAILURE() << "no picture";
            return seen;
        }
        for (const vk::ReadbackData& data : session->take_readbacks()) {
            const std::vector<glm::vec4> texels = render::decode_texels(data.format, data.bytes);
            if (data.pass == "observe:normal") seen.normals = texels;
            if (data.pass == "observe:depth") seen.depths = texels;
            if (data.pass != "observe:seen") continue;
            for (const glm::vec4& texel : texels) seen.share.push_back(texel.r);
        }
        seen.sun = session->parts().frames.sun();
        seen.eye = session->parts().frames.view().eye;
        return seen;
    }
};

// Returns how far a point is inside of a shadow map, in texels: its least distance from an edge.
inline double inside_map(const render::SunCascades& sun, uint32_t i, const glm::vec3& point) {
    const shared::SunCascade& map = sun.constants.cascades[i];
    const double size = static_cast<double>(sun.views[i].viewport_px.x);
    const glm::dvec2 at = glm::dvec2(glm::dmat4(map.world_to_map) * glm::dvec4(point, 1)) * size;
    return std::min({at.x, at.y, size - at.x, size - at.y});
}

// Returns the sizes of the texels of the maps that are used for a point. Near the edge of a map, the distance
// from the edge is added, because the share of the map depends on it. If the result is the same for two
// frames, the maps have moved by whole texels only.
inline std::vector<glm::dvec2> maps_at(const Seen& seen, const glm::vec3& point) {
    std::vector<glm::dvec2> sizes;
    for (uint32_t i = 0; i < seen.sun.count; ++i) {
        const double inside = inside_map(seen.sun, i, point);
        // The shader moves the point by up to two texels before it looks for the map.
        if (inside <= 0) continue;
        sizes.push_back(seen.sun.cascades[i].texel_m);
        if (inside >= 4 + double{shared::kSunBlendTexels}) break;
        sizes.emplace_back(inside);
    }
    return sizes;
}

// Returns the size in metres of the texels of the shadow map that is used for a point: the longer side. Where
// several maps blend, the largest size is returned.
inline double texel_at(const Seen& seen, const glm::vec3& point) {
    double texel_m = 0;
    for (uint32_t i = 0; i < seen.sun.count; ++i) {
        const double inside = inside_map(seen.sun, i, point);
        // The shader moves the point by up to two texels before it looks for the map.
        if (inside <= 0) continue;
        const glm::dvec2 sides_m = seen.sun.cascades[i].texel_m;
        texel_m = std::max({texel_m, sides_m.x, sides_m.y});
        if (inside >= 4 + double{shared::kSunBlendTexels}) break;
    }
    return texel_m;
}

inline scene::Scene atrium(float hour) {
    Result<scene::Scene> scene = scene::make_builtin("atrium", {.hour = hour});
    EXPECT_TRUE(scene);
    return std::move(*scene);
}

}  // namespace weft::test
