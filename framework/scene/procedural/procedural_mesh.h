// Purpose: builds indexed triangle meshes from a few shapes: rectangles, bevelled boxes, turned (lathe) and
// swept profiles, tubes, grids and cards. Every shape has positions, normals and texture coordinates;
// finish() adds tangents and bounds.
// Units: metres; texture coordinates are in metres too (a material's texture transform sets the repeat).
// Exceptions: a card covers a given rectangle of the texture, and the caller sets the coordinates of a grid.
// v increases downwards.
// Conventions: front faces are counter-clockwise. The front of a surface is on the right-hand side of its
// profile's direction: profiles go upwards on the outside of a turned shape and downwards on its inside.
// Corners of a profile with an angle above about 35° stay sharp.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "weft/scene/scene.h"

namespace weft::scene {

// Points of a profile in metres: x is the radius (add_lathe) or the outward offset (add_sweep), y is the
// height.
using Profile = std::vector<glm::vec2>;

struct GridPoint {
    glm::vec3 position{0};
    glm::vec2 uv{0};
};

struct LatheShape {
    uint32_t segments = 20;
    // The profile is turned around the y axis from the first angle to the second one: 0 is +z, π/2 is +x.
    float from_rad = 0;
    float to_rad = 6.283185307f;
    // Length in metres after which the texture repeats, only used if u_span_m is 0. Then the texture has a
    // whole number of repeats around the shape, so that no seam is visible.
    float period_m = 1;
    // Distance in the texture, in metres, between the angles from_rad and to_rad. 0: the length of the arc at
    // the mean radius of the profile, rounded to a multiple of period_m.
    float u_span_m = 0;
};

struct TubeShape {
    float radius_start_m = 0.02f;
    float radius_end_m = 0.02f;
    uint32_t segments = 6;
};

struct Card {
    glm::vec3 center{0};
    // Half of the card's extent to the right: the card reaches from center - right to center + right. In the
    // same way, `up` is half of the extent upwards.
    glm::vec3 right{1, 0, 0};
    glm::vec3 up{0, 1, 0};
    // If `soft_normals` is set, the normals of the card mostly point away from this point.
    glm::vec3 normal_center{0};
    bool soft_normals = false;
    glm::vec2 uv_min{0};
    glm::vec2 uv_max{1};
};

class MeshBuilder {
 public:
    // Sets the transform of every shape that is added afterwards. Only rotation, translation and uniform
    // scale are allowed, no mirroring.
    void set_transform(const glm::mat4& transform) { transform_ = transform; }
    // Sets an offset that is added to every texture coordinate, so that similar shapes show different parts
    // of the texture.
    void set_uv_offset(glm::vec2 offset) { uv_offset_ = offset; }

    // Adds a rectangle. `origin` is its lower left corner seen from the front, and the normal is cross(right,
    // up). The texture coordinates are positions along the two edges, so the texture continues on a
    // neighbouring rectangle.
    void add_rectangle(glm::vec3 origin, glm::vec3 right, glm::vec3 up);
    // Adds a flat strip between the two rows of points `low` and `high`. Both rows have the same number of
    // points and run from left to right, seen from the front. u increases along `right`, v decreases along
    // `up`, and the normal is cross(right, up).
    void add_strip(const std::vector<glm::vec3>& low, const std::vector<glm::vec3>& high, glm::vec3 right,
                   glm::vec3 up);
    // Adds a smooth surface through cols × rows points; point(col, row) returns a point. The front faces in
    // the direction of the cross product of two vectors: the step to the next column, and the step to the
    // next row.
    void add_grid(uint32_t cols, uint32_t rows, const std::function<GridPoint(uint32_t, uint32_t)>& point);
    // Turns a profile around the y axis.
    void add_lathe(const Profile& profile, const LatheShape& shape);
    // Sweeps a profile along a horizontal path of at least two points. The profile's offsets point to the
    // right of the path: cross(direction, up). Corners of the path are mitred.
    void add_sweep(const Profile& profile, const std::vector<glm::vec3>& path, bool closed);
    void add_box(glm::vec3 low, glm::vec3 high);
    void add_bevelled_box(glm::vec3 low, glm::vec3 high, float bevel_m);
    void add_tube(const std::vector<glm::vec3>& path, const TubeShape& shape);
    void add_sphere(glm::vec3 center, float radius_m, uint32_t segments, uint32_t rings);
    // Adds a torus around the y axis. `radius_m` is the radius of the circle in the middle of the tube,
    // `tube_m` the radius of the tube.
    void add_torus(float radius_m, float tube_m, uint32_t segments, uint32_t tube_segments);
    void add_card(const Card& card);

    [[nodiscard]] Mesh finish(std::string name);

 private:
    struct BoxExtent {
        glm::vec3 center;
        glm::vec3 half;
        glm::vec3 inner;  // `half` minus the width of the bevel in each coordinate.
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
