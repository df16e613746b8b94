#include "viewer/pictures/probe_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/probes/triangle_tree.h"

namespace weft::viewer {
namespace {

constexpr int kPanelSide_px = 720;
constexpr int kGap_px = 12;
// Side of the squares in which the geometry is drawn.
constexpr int kBlock_px = 2;

struct Color {
    uint8_t r, g, b;
};
constexpr Color kSomewhere{232, 232, 232}, kSection{110, 110, 110}, kBlack{0, 0, 0}, kDropped{214, 120, 120},
    kReflection{204, 0, 153};
// Colours that colour-blind readers can distinguish. Source: Okabe and Ito 2008, "Color Universal Design".
constexpr std::array<Color, 4> kLevels{{{0, 114, 178}, {0, 158, 115}, {230, 159, 0}, {213, 94, 0}}};

// Returns the part of the scene that the picture shows: the box around the probes, with a margin on all
// sides. The margin is half the spacing of the coarsest level, but at least one metre.
scene::Bounds shown_part(const scene::Scene& scene, const scene::Probes& probes) {
    const scene::ProbeVolume& volume = probes.volume;
    if (volume.probes.empty() && probes.reflections.empty()) return scene.bounds;
    constexpr float kFar = 1e30f;
    scene::Bounds box{glm::vec3(kFar), glm::vec3(-kFar)};
    const auto grow = [&](const glm::vec3& place) {
        box.min = glm::min(box.min, place);
        box.max = glm::max(box.max, place);
    };
    for (const scene::Probe& probe : volume.probes) grow(position_of(volume, probe));
    for (const scene::ReflectionProbe& probe : probes.reflections) grow(probe.position);
    const glm::vec3 margin(
        std::max(1.0f, 0.5f * volume.spacing_m * static_cast<float>(volume.strides.back())));
    return {box.min - margin, box.max + margin};
}

// Returns the median of the coordinates of the probes along an axis; `otherwise` if there are no probes.
float middle_of(const scene::ProbeVolume& volume, int axis, float otherwise) {
    std::vector<float> values;
    for (const scene::Probe& probe : volume.probes)
        if (probe.state != scene::ProbeState::dropped) values.push_back(position_of(volume, probe)[axis]);
    if (values.empty()) return otherwise;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

class Canvas {
 public:
    Canvas(int width_px, int height_px) : width_(width_px), height_(height_px) {
        picture_.width_px = static_cast<uint32_t>(width_px);
        picture_.height_px = static_cast<uint32_t>(height_px);
        picture_.rgba.assign(static_cast<size_t>(width_px) * static_cast<size_t>(height_px) * 4, 255);
    }
    void put(int x, int y, Color color) {
        if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
        uint8_t* texel =
            &picture_
                 .rgba[(static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x)) * 4];
        texel[0] = color.r;
        texel[1] = color.g;
        texel[2] = color.b;
    }
    void square(int x, int y, int half, Color color) {
        for (int j = y - half; j <= y + half; ++j)
            for (int i = x - half; i <= x + half; ++i) put(i, j, color);
    }
    void disc(int x, int y, int radius, Color color) {
        for (int j = -radius; j <= radius; ++j)
            for (int i = -radius; i <= radius; ++i)
                if (i * i + j * j <= radius * radius + 1) put(x + i, y + j, color);
    }
    void cross(int x, int y, int half, Color color) {
        for (int i = -half; i <= half; ++i) {
            put(x + i, y + i, color);
            put(x + i, y - i, color);
        }
    }
    [[nodiscard]] ProbePicture take() { return std::move(picture_); }

 private:
    int width_;
    int height_;
    ProbePicture picture_;
};

// A view along an axis of the world. `right`, `down` and `along` are numbers of axes: 0 for x, 1 for y, 2 for
// z. The axis `along` is the direction of the view. In the picture, the axis `right` points to the right, and
// the axis `down` points downwards; if down_sign is −1, it points upwards.
struct Panel {
    int right = 0;
    int down = 2;
    int along = 1;
    float down_sign = 1;
    int left_px = 0;
    float pixels_per_m = 1;
    scene::Bounds shown;
    float section = 0;  // Place on the axis `along` at which the geometry is cut.

    [[nodiscard]] int x_of(const glm::vec3& p) const {
        return left_px + static_cast<int>(std::lround((p[right] - shown.min[right]) * pixels_per_m));
    }
    [[nodiscard]] int y_of(const glm::vec3& p) const {
        const float from = down_sign > 0 ? p[down] - shown.min[down] : shown.max[down] - p[down];
        return static_cast<int>(std::lround(from * pixels_per_m));
    }
    [[nodiscard]] int width_px() const { return extent_px(right); }
    [[nodiscard]] int height_px() const { return extent_px(down); }

 private:
    [[nodiscard]] int extent_px(int axis) const {
        return static_cast<int>(std::ceil((shown.max[axis] - shown.min[axis]) * pixels_per_m)) + 1;
    }
};

void draw_geometry(const scene::TriangleTree& tree, const Panel& panel, Canvas& canvas) {
    const float block_m = kBlock_px / panel.pixels_per_m;
    for (int y = 0; y < panel.height_px(); y += kBlock_px)
        for (int x = 0; x < panel.width_px(); x += kBlock_px) {
            scene::Bounds box = panel.shown;
            box.min[panel.right] += static_cast<float>(x) / panel.pixels_per_m;
            box.max[panel.right] = box.min[panel.right] + block_m;
            const float from = static_cast<float>(y) / panel.pixels_per_m;
            if (panel.down_sign > 0) {
                box.min[panel.down] += from;
                box.max[panel.down] = box.min[panel.down] + block_m;
            } else {
                box.max[panel.down] -= from;
                box.min[panel.down] = box.max[panel.down] - block_m;
            }
            if (!tree.touches(box)) continue;
            box.min[panel.along] = panel.section - block_m / 2;
            box.max[panel.along] = panel.section + block_m / 2;
            const Color color = tree.touches(box) ? kSection : kSomewhere;
            for (int j = 0; j < kBlock_px; ++j)
                for (int i = 0; i < kBlock_px; ++i) canvas.put(panel.left_px + x + i, y + j, color);
        }
}

void draw_panel(const scene::TriangleTree& tree, const scene::Probes& probes, const Panel& panel,
                Canvas& canvas) {
    draw_geometry(tree, panel, canvas);
    const scene::ProbeVolume& volume = probes.volume;
    for (const scene::Probe& probe : volume.probes) {
        const glm::vec3 place = position_of(volume, probe);
        if (probe.state == scene::ProbeState::dropped)
            canvas.cross(panel.x_of(place), panel.y_of(place), 3, kDropped);
    }
    // Fine probes are small and drawn last, so that they do not hide behind coarse ones.
    for (uint32_t level = static_cast<uint32_t>(volume.strides.size()); level-- > 0;)
        for (const scene::Probe& probe : volume.probes) {
            if (probe.level != level || probe.state == scene::ProbeState::dropped) continue;
            const glm::vec3 place = position_of(volume, probe);
            const int radius = 3 + static_cast<int>(std::min<uint32_t>(level, 3));
            if (probe.state == scene::ProbeState::moved)
                canvas.disc(panel.x_of(place), panel.y_of(place), radius + 2, kBlack);
            canvas.disc(panel.x_of(place), panel.y_of(place), radius,
                        kLevels[std::min<size_t>(level, kLevels.size() - 1)]);
        }
    for (const scene::ReflectionProbe& probe : probes.reflections)
        canvas.square(panel.x_of(probe.position), panel.y_of(probe.position), 5, kReflection);
}

}  // namespace

ProbePicture draw_probes(const scene::Scene& scene, const scene::Probes& probes) {
    const scene::TriangleTree tree(scene::collect_triangles(scene, {}), {});
    Panel top;
    top.shown = shown_part(scene, probes);
    const glm::vec3 size = glm::max(top.shown.max - top.shown.min, glm::vec3(1e-3f));
    top.pixels_per_m = kPanelSide_px / std::max({size.x, size.y, size.z});
    top.section = middle_of(probes.volume, 1, top.shown.min.y);
    Panel side = top;
    side.down = 1;
    side.along = 2;
    side.down_sign = -1;
    side.left_px = top.width_px() + kGap_px;
    side.section = middle_of(probes.volume, 2, side.shown.min.z);
    Canvas canvas(side.left_px + side.width_px(), std::max(top.height_px(), side.height_px()));
    draw_panel(tree, probes, top, canvas);
    draw_panel(tree, probes, side, canvas);
    return canvas.take();
}

}  // namespace weft::viewer
