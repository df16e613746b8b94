#include "render/views/view_matrices.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace weft::render {
namespace {

// Distance of the near planes of lamps, in metres.
constexpr float kLampNear_m = 0.05f;
// Smallest and largest half angle of a spot light's view, in radians. A wider cone does not fit into one flat
// picture.
constexpr float kLeastHalf_rad = 0.01f, kMostHalf_rad = 1.5f;

// The axes of one face: the directions in which the column number and the row number in the picture grow, and
// the direction of the view.
struct FaceAxes {
    glm::dvec3 right, down, forward;
};
constexpr int kAxes = 3;

const FaceAxes& face_axes(uint32_t face) {
    static const std::array<FaceAxes, kCubeFaces> kFaces{{
        {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}},
        {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}},
        {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
        {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
        {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
    }};
    return kFaces[face];
}

// Returns the matrix from world space to the view space with these axes: x right, y up, z towards the viewer.
glm::mat4 view_matrix(const FaceAxes& axes, const glm::dvec3& at) {
    glm::dmat4 view(1);
    const std::array<glm::dvec3, kAxes> rows{axes.right, -axes.down, -axes.forward};
    for (int row = 0; row < kAxes; ++row) {
        for (int column = 0; column < kAxes; ++column)
            view[column][row] = rows[static_cast<size_t>(row)][column];
        view[3][row] = -glm::dot(rows[static_cast<size_t>(row)], at);
    }
    return glm::mat4(view);
}

glm::mat4 square_projection(float factor, float near_m) {
    glm::mat4 projection(0.0f);
    projection[0][0] = factor;
    projection[1][1] = -factor;
    projection[2][3] = -1;
    projection[3][2] = near_m;
    return projection;
}

ViewInput spot_view(const shared::Light& light) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(light.direction));
    glm::dvec3 right(light.side);
    right -= forward * glm::dot(right, forward);
    if (glm::dot(right, right) < 1e-12)
        right = glm::cross(forward, std::abs(forward.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1));
    right = glm::normalize(right);
    const float cos_outer = std::clamp(-light.cone_offset / light.cone_scale, -1.0f, 1.0f);
    const float half = std::clamp(std::acos(cos_outer), kLeastHalf_rad, kMostHalf_rad);
    return {view_matrix({right, glm::cross(forward, right), forward}, glm::dvec3(light.position)),
            square_projection(1.0f / std::tan(half), kLampNear_m)};
}

glm::dmat4 reflection(const std::array<double, 4>& plane) {
    const glm::dvec3 normal(plane[0], plane[1], plane[2]);
    glm::dmat4 matrix(1);
    for (int column = 0; column < kAxes; ++column)
        for (int row = 0; row < kAxes; ++row) matrix[column][row] -= 2 * normal[row] * normal[column];
    for (int row = 0; row < kAxes; ++row) matrix[3][row] = -2 * plane[3] * normal[row];
    return matrix;
}

glm::dvec4 row_of(const glm::dmat4& matrix, int row) {
    return {matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]};
}

void replace_row(glm::mat4& matrix, int row, const glm::dvec4& values) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = static_cast<float>(values[column]);
}

// Returns a new third row (the row that gives z) for `to_clip`, a matrix to clip space. With this row, points
// on the plane have depth 1, points on the positive side of the plane have less, and no point in the picture
// has less than 0. Returns nullopt for a parallel projection, and if the viewer is in the plane. `plane` is
// in the space that the matrix transforms, and `from_clip` is the inverse of the matrix. Source: Lengyel
// 2005, "Oblique View Frustum Depth Projection and Clipping", changed for reversed depth and a far plane that
// is infinitely far.
std::optional<glm::dvec4> oblique_depth(const glm::dmat4& to_clip, const glm::dmat4& from_clip,
                                        const glm::dvec4& plane) {
    const glm::dvec4 w = row_of(to_clip, 3);
    if (glm::dvec3(w) == glm::dvec3(0)) return std::nullopt;
    // The value of the plane equation at a point of the picture is a linear function of the position in clip
    // space. So it is largest in one of the corners of the picture.
    double fastest = 0;
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}})
        fastest = std::max(fastest, std::abs(glm::dot(plane, from_clip * glm::dvec4(corner, 0, 1))));
    if (!(fastest > 0)) return std::nullopt;
    return w - plane / fastest;
}

// Returns the distance at which depth is 1.
float near_of(const glm::mat4& projection) {
    const float factor = projection[2][2] - projection[2][3];
    return factor == 0 ? 0 : (projection[3][2] - projection[3][3]) / factor;
}

}  // namespace

ViewInput cube_face(const glm::dvec3& at, uint32_t face, double near_m) {
    return {view_matrix(face_axes(face), at), square_projection(1, static_cast<float>(near_m))};
}

uint32_t count_lamp_views(const shared::Light& light) {
    if (light.type == shared::kLightSpot) return 1;
    return light.type == shared::kLightPoint ? kCubeFaces : 0;
}

std::vector<ViewInput> lamp_views(std::span<const shared::Light> lights) {
    std::vector<ViewInput> views;
    for (const shared::Light& light : lights) {
        if (light.type == shared::kLightSpot) views.push_back(spot_view(light));
        if (light.type != shared::kLightPoint) continue;
        for (uint32_t face = 0; face < kCubeFaces; ++face)
            views.push_back(cube_face(glm::dvec3(light.position), face, kLampNear_m));
    }
    return views;
}

shared::ViewConstants constants_of(const ViewInput& input) {
    shared::ViewConstants view{};
    view.view = input.view;
    view.projection = input.projection;
    const glm::dmat4 to_clip = glm::dmat4(input.projection) * glm::dmat4(input.view);
    view.view_projection = view.steady_view_projection = view.prev_view_projection =
        input.projection * input.view;
    view.inverse_view_projection = glm::mat4(glm::inverse(to_clip));
    view.eye = glm::vec3(glm::inverse(glm::dmat4(input.view))[3]);
    view.near_m = near_of(input.projection);
    view.viewport_px = view.inverse_viewport = glm::vec2(1);
    return view;
}

shared::ViewConstants mirrored(const shared::ViewConstants& source, const std::array<double, 4>& plane) {
    const glm::dmat4 mirror = reflection(plane);
    shared::ViewConstants view = source;
    for (glm::mat4* matrix :
         {&view.view, &view.view_projection, &view.steady_view_projection, &view.prev_view_projection})
        *matrix = glm::mat4(glm::dmat4(*matrix) * mirror);
    // A reflection is its own inverse.
    const glm::dmat4 from_clip = mirror * glm::dmat4(source.inverse_view_projection);
    view.inverse_view_projection = glm::mat4(from_clip);
    view.eye = glm::vec3(mirror * glm::dvec4(glm::dvec3(source.eye), 1));
    const glm::dvec4 front = glm::dvec4(plane[0], plane[1], plane[2], plane[3]);
    const double height_m = glm::dot(front, glm::dvec4(glm::dvec3(source.eye), 1));
    const std::optional<glm::dvec4> depth =
        oblique_depth(glm::dmat4(view.view_projection), from_clip, height_m < 0 ? -front : front);
    if (height_m == 0 || !depth) return view;
    for (glm::mat4* matrix :
         {&view.view_projection, &view.steady_view_projection, &view.prev_view_projection})
        replace_row(*matrix, 2, *depth);
    replace_row(view.projection, 2, *depth * glm::inverse(glm::dmat4(view.view)));
    view.inverse_view_projection = glm::mat4(glm::inverse(glm::dmat4(view.view_projection)));
    return view;
}

// The rows of the matrix give the directions in which x, y and the distance from the viewer grow. In a
// parallel projection, w does not grow with the distance. There, the distance grows when the reversed depth
// falls.
bool is_mirrored(const glm::mat4& view_projection) {
    const auto row = [&](int i) {
        return glm::dvec3(view_projection[0][i], view_projection[1][i], view_projection[2][i]);
    };
    const glm::dvec3 w = row(3);
    const glm::dvec3 away = glm::dot(w, w) > 0 ? w : -row(2);
    return glm::dot(glm::cross(row(0), row(1)), away) < 0;
}

}  // namespace weft::render
