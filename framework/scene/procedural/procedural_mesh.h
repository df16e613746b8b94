// Purpose: build indexed triangle meshes from a few shapes: rectangles, bevelled boxes, turned (lathe) and
// swept
//   profiles, tubes, grids and cards. Every shape gives positions, normals and texture coordinates; finish()
//   adds tangents and bounds.
// Units: metres; texture coordinates are metres too (a material's texture transform sets the repeat), except
// for cards,
//   which span a given rectangle of the texture. v grows downwards.
// Conventions: front faces counter-clockwise; a profile is walked so that the surface lies on its right:
// upwards on the
//   outside of a turned shape, downwards on its inside. Corners sharper than about 35° stay sharp.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

using Profile = std::vector<glm::vec2>;  // (radius or outward offset, height)

struct GridPoint {
    glm::vec3 position{0};
    glm::vec2 uv{0};
};

struct LatheShape {
    uint32_t segments = 20;
    float from_rad = 0;
    float to_rad = 6.283185307f;
    float period_m = 1;  // of the texture: a full turn gets a whole number of repeats, so that no seam shows
    float u_span_m = 0;  // 0: as long as the mean circumference
};

struct TubeShape {
    float radius_start_m = 0.02f;
    float radius_end_m = 0.02f;
    uint32_t segments = 6;
};

struct Card {
    glm::vec3 center{0};
    glm::vec3 right{1, 0, 0};  // half extents
    glm::vec3 up{0, 1, 0};
    glm::vec3 normal_center{0};  // normals point away from here when `soft_normals`
    bool soft_normals = false;
    glm::vec2 uv_min{0};
    glm::vec2 uv_max{1};
};

class MeshBuilder {
 public:
    // Applies to every shape added from here on. Rigid or uniformly scaled, no mirroring.
    void set_transform(const glm::mat4& transform) { transform_ = transform; }
    // Added to every texture coordinate, so that like shapes don't show the same piece of texture.
    void set_uv_offset(glm::vec2 offset) { uv_offset_ = offset; }

    // `origin` is the lower left corner seen from the front; the normal is cross(right, up). Texture
    // coordinates are positions along the two edges, so neighbouring rectangles join.
    void add_rectangle(glm::vec3 origin, glm::vec3 right, glm::vec3 up);
    // A flat polygon fan from two equally long rows of points, `low` and `high`, both left to right from the
    // front.
    void add_strip(const std::vector<glm::vec3>& low, const std::vector<glm::vec3>& high, glm::vec3 right,
                   glm::vec3 up);
    // Smooth surface over cols × rows points; the front is where cross(d/dcol, d/drow) points.
    void add_grid(uint32_t cols, uint32_t rows, const std::function<GridPoint(uint32_t, uint32_t)>& point);
    void add_lathe(const Profile& profile, const LatheShape& shape);
    // Along a horizontal path of at least two points; offsets point to its right (cross(direction, up));
    // mitred corners.
    void add_sweep(const Profile& profile, const std::vector<glm::vec3>& path, bool closed);
    void add_box(glm::vec3 low, glm::vec3 high);
    void add_bevelled_box(glm::vec3 low, glm::vec3 high, float bevel_m);
    void add_tube(const std::vector<glm::vec3>& path, const TubeShape& shape);
    void add_sphere(glm::vec3 center, float radius_m, uint32_t segments, uint32_t rings);
    void add_torus(float radius_m, float tube_m, uint32_t segments, uint32_t tube_segments);
    void add_card(const Card& card);

    [[nodiscard]] Mesh finish(std::string name);

 private:
    struct BoxExtent {
        glm::vec3 center;
        glm::vec3 half;
        glm::vec3 inner;  // half, less the bevel
    };

    uint32_t add_vertex(glm::vec3 position, glm::vec3 normal, glm::vec2 uv);
    void add_triangle(uint32_t a, uint32_t b, uint32_t c);
    void add_box_face(glm::vec3 center, glm::vec3 right, glm::vec3 up);
    void add_box_bevel(const BoxExtent& box, glm::vec3 a, glm::vec3 b);
    void add_lathe_run(const Profile& run, const std::vector<glm::vec2>& normals, float v_start,
                       const LatheShape& shape, float u_span_m);

    Mesh mesh_;
    glm::mat4 transform_{1};
    glm::vec2 uv_offset_{0};
};

}  // namespace weft::scene
