#include "render/views/visible_patches.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>

namespace weft::render {
namespace {

// Rays along the width and the height of the picture.
constexpr size_t kColumns = 48, kRows = 27;
// Step in radians to which the angles of the camera are rounded.
constexpr double kAngleStep_rad = 1.0 / 32;
// Two neighbouring rays meet the same surface if the farther hit is at most this factor farther away.
constexpr double kSameSurface = 1.5;
// A ray that meets no known surface is divided into this number of parts. The length of a part is
// proportional to its distance from the eye.
constexpr size_t kParts = 4;
// Lower limit for the start of the first part when the lengths of the parts are computed, as a share of the
// distance at which the last part ends. If the ray enters the box before this limit, the patch of the first
// part also covers the ray from there.
constexpr double kFirstPartShare = 1.0 / 256;

struct Ray {
    glm::dvec3 direction;
    double distance_m = 0;  // 0: the ray meets no surface.
};

class Rays {
 public:
    Rays(const scene::Camera& camera, double aspect, const SeenScene& seen) : eye_(camera.transform[3]) {
        const double half_y = std::min(double{camera.fov_y_rad} * 0.5 + kAngleStep_rad * 0.5, 1.55);
        tan_y_ = std::tan(half_y);
        tan_x_ = std::tan(
            std::min(std::atan(std::tan(camera.fov_y_rad * 0.5) * aspect) + kAngleStep_rad * 0.5, 1.55));
        const glm::dmat3 turn(camera.transform);
        for (size_t row = 0; row < kRows; ++row)
            for (size_t column = 0; column < kColumns; ++column) {
                const double x = 2.0 * static_cast<double>(column) / (kColumns - 1) - 1;
                const double y = 1 - 2.0 * static_cast<double>(row) / (kRows - 1);
                Ray& ray = rays_[row * kColumns + column];
                ray.direction = glm::normalize(turn * glm::dvec3(x * tan_x_, y * tan_y_, -1));
                auto to_m = static_cast<float>(seen.reach_m);
                for (const SurfaceTree* tree : seen.surfaces)
                    if (const auto hit = tree->first_entry(glm::vec3(eye_), glm::vec3(ray.direction), to_m))
                        ray.distance_m = to_m = *hit;
            }
    }

    [[nodiscard]] const std::array<Ray, kColumns * kRows>& all() const { return rays_; }
    [[nodiscard]] glm::dvec3 at(const Ray& ray, double distance_m) const {
        return eye_ + ray.direction * distance_m;
    }
    [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
    // Returns half the distance between neighbouring rays at 1 m from the eye.
    [[nodiscard]] double half_width() const {
        return std::max(tan_x_ / (kColumns - 1), tan_y_ / (kRows - 1));
    }
    // Returns a rectangle in the plane of the axes around the point where a ray meets a surface. The
    // rectangle reaches halfway to the points of those neighbouring rays that meet the same surface.
    [[nodiscard]] LightRect patch(size_t i, const LightAxes& axes) const {
        const Ray& ray = rays_[i];
        const glm::dvec2 center = axes.place(at(ray, ray.distance_m));
        const double half_m = half_width() * ray.distance_m;
        LightRect rect{center - half_m, center + half_m};
        const size_t row = i / kColumns, column = i % kColumns;
        const auto reach_to = [&](size_t j) {
            const double other_m = rays_[j].distance_m;
            if (other_m > 0 &&
                std::max(ray.distance_m, other_m) <= kSameSurface * std::min(ray.distance_m, other_m))
                rect.add((center + axes.place(at(rays_[j], other_m))) * 0.5);
        };
        if (column > 0) reach_to(i - 1);
        if (column + 1 < kColumns) reach_to(i + 1);
        if (row > 0) reach_to(i - kColumns);
        if (row + 1 < kRows) reach_to(i + kColumns);
        return rect;
    }

 private:
    glm::dvec3 eye_;
    double tan_x_ = 1, tan_y_ = 1;
    std::array<Ray, kColumns * kRows> rays_;
};

// Returns the part of a ray that is in a box, as distances from the eye.
glm::dvec2 span_in_box(const scene::Bounds& box, const glm::dvec3& eye, const glm::dvec3& direction) {
    glm::dvec2 span(0, std::numeric_limits<double>::max());
    for (int axis = 0; axis < 3; ++axis) {
        const double along = std::abs(direction[axis]) > 1e-12 ? direction[axis] : 1e-12;
        const double a = (double{box.min[axis]} - eye[axis]) / along,
                     b = (double{box.max[axis]} - eye[axis]) / along;
        span = {std::max(span.x, std::min(a, b)), std::min(span.y, std::max(a, b))};
    }
    return span;
}

// An object may be at any place where the ray is inside the box `seen.unknown`. Adds patches for all these
// places.
void add_unknown(const Rays& rays, const Ray& ray, const SeenScene& seen, double near_m,
                 const LightAxes& axes, std::vector<VisiblePatch>& patches) {
    const glm::dvec2 span = span_in_box(*seen.unknown, rays.eye(), ray.direction);
    const double to_m = std::min(span.y, seen.reach_m);
    const double first_m = std::max(span.x, near_m);
    double from_m = std::max({span.x, near_m, to_m * kFirstPartShare});
    if (from_m >= to_m) return;
    const double ratio = std::pow(to_m / from_m, 1.0 / kParts);
    for (size_t part = 0; part < kParts; ++part, from_m *= ratio) {
        VisiblePatch patch;
        for (const double distance_m : {part == 0 ? first_m : from_m, from_m * ratio}) {
            const glm::dvec2 at = axes.place(rays.at(ray, distance_m));
            const double half_m = rays.half_width() * distance_m;
            patch.rect.add(LightRect{at - half_m, at + half_m});
        }
        patch.distance_m = from_m * std::sqrt(ratio);
        patch.share = 1.0 / kParts;
        patches.push_back(patch);
    }
}

double rounded(double x, double step) {
    return std::round(x / step) * step;
}

}  // namespace

scene::Camera rounded_camera(const scene::Camera& camera, double step_m) {
    const glm::dvec3 back = glm::normalize(glm::dvec3(camera.transform[2]));
    const double pitch = std::asin(std::clamp(back.y, -1.0, 1.0)), yaw = std::atan2(back.x, back.z);
    const auto upright = [](double yaw_rad, double pitch_rad) {
        return glm::rotate(glm::rotate(glm::dmat4(1), yaw_rad, glm::dvec3(0, 1, 0)), -pitch_rad,
                           glm::dvec3(1, 0, 0));
    };
    const glm::dvec3 right =
        glm::transpose(glm::dmat3(upright(yaw, pitch))) * glm::dvec3(camera.transform[0]);
    const double roll = std::atan2(right.y, right.x);
    glm::dmat4 turn = upright(rounded(yaw, kAngleStep_rad), rounded(pitch, kAngleStep_rad));
    turn = glm::rotate(turn, rounded(roll, kAngleStep_rad), glm::dvec3(0, 0, 1));
    for (int axis = 0; axis < 3; ++axis) turn[3][axis] = rounded(double{camera.transform[3][axis]}, step_m);
    scene::Camera result = camera;
    result.transform = glm::mat4(turn);
    return result;
}

std::vector<VisiblePatch> visible_patches(const scene::Camera& camera, double aspect, const SeenScene& seen,
                                          const LightAxes& axes) {
    const Rays rays(camera, aspect, seen);
    std::vector<VisiblePatch> patches;
    for (size_t i = 0; i < rays.all().size(); ++i) {
        const Ray& ray = rays.all()[i];
        if (ray.distance_m > 0)
            patches.push_back({rays.patch(i, axes), ray.distance_m, 1});
        else if (seen.unknown)
            add_unknown(rays, ray, seen, double{camera.near_m}, axes, patches);
    }
    return patches;
}

}  // namespace weft::render
