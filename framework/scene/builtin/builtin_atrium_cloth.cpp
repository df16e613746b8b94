// Purpose: adds the atrium's banners and curtains, which hang from iron rods.
#include <algorithm>
#include <cmath>

#include "scene/builtin/builtin_atrium_materials.h"
#include "scene/model/angles.h"

namespace weft::scene::atrium {
namespace {

// Width of a banner in metres. The pattern of the cloth repeats after the same length.
constexpr float kBannerWidth = 1.2f;
constexpr float kRodRadius = 0.018f;

// Makes a banner that hangs down from y = 0 in the plane z = 0 and faces +z. Its lower edge is pointed, and
// the folds get deeper downwards.
Mesh banner(float length, uint32_t seed) {
    constexpr uint32_t kCols = 17;
    constexpr uint32_t kRows = 9;
    Random random(seed);
    const float phase = random.range(0, 2 * kPi);
    const float lean = random.range(-0.5f, 0.5f);
    MeshBuilder builder;
    builder.add_grid(kCols, kRows, [&](uint32_t i, uint32_t j) {
        const float u = static_cast<float>(i) / (kCols - 1);
        const float t = 1 - static_cast<float>(j) / (kRows - 1);
        const float point = 0.26f * (1 - std::abs(2 * u - 1));
        const float down = t * (length - 0.26f + point);
        const float depth = 0.010f + 0.045f * t;
        const float wave = std::sin(2 * kPi * 2.4f * u + phase + lean * 2 * t) +
                           0.35f * std::sin(2 * kPi * 3.6f * u - phase + 1.5f * t);
        const float narrow = 1 - 0.05f * t;
        return GridPoint{{(u - 0.5f) * kBannerWidth * narrow, -down, depth * wave + 0.02f * t},
                         {u * kBannerWidth, down}};
    });
    return builder.finish("banner");
}

// Makes one curtain of a pair. `side` is +1 or -1 and selects the curtain. The curtain is tied at 0.56 of its
// length below the rod. The tie gathers the cloth between x = -1.07 · side and x = -0.98 · side.
Mesh curtain(float side, float length) {
    constexpr uint32_t kCols = 21;
    constexpr uint32_t kRows = 8;
    constexpr float kTie = 0.56f;
    MeshBuilder builder;
    builder.add_grid(kCols, kRows, [&](uint32_t i, uint32_t j) {
        const float across = static_cast<float>(i) / (kCols - 1);
        // Position across the curtain: 0 at the edge next to the column, 1 at the edge in the opening.
        const float u = side > 0 ? across : 1 - across;
        const float t = 1 - static_cast<float>(j) / (kRows - 1);
        const float above = std::clamp(t / kTie, 0.0f, 1.0f);
        const float below = std::clamp((t - kTie) / (1 - kTie), 0.0f, 1.0f);
        const float inner = 1.12f - 0.96f * std::pow(above, 1.6f) + 0.34f * smooth_step(0, 1, below);
        const float outer = 0.07f * std::sin(kPi * 0.5f * above) - 0.06f * below;
        const float x = -1.14f + outer + (inner - outer) * u;
        const float gathered = 1 - (inner - outer) / 1.12f;
        const float depth = 0.022f + 0.05f * gathered * (0.4f + 0.6f * below) + 0.012f * t;
        const float wave = std::sin(2 * kPi * 4.0f * u + 0.6f * t) + 0.3f * std::sin(2 * kPi * 2.2f * u + 2);
        const float sag = 0.16f * u * (1 - below) * above;
        return GridPoint{{x * side, -t * length - sag * (1 - t), depth * wave}, {u * 1.2f, t * length}};
    });
    return builder.finish("curtain");
}

Mesh rod(float half_length, bool brackets) {
    MeshBuilder builder;
    builder.add_tube({{-half_length, 0, 0}, {half_length, 0, 0}}, {kRodRadius, kRodRadius, 6});
    builder.add_sphere({-half_length, 0, 0}, 0.04f, 5, 3);
    builder.add_sphere({half_length, 0, 0}, 0.04f, 5, 3);
    if (brackets) {
        for (const float x : {-0.5f, 0.5f}) {
            builder.add_tube({{x, 0.01f, -0.4f}, {x, -0.01f, 0}}, {0.014f, 0.014f, 4});
        }
    }
    return builder.finish("cloth_rod");
}

struct Hanging {
    // Position of the banner along the side of the court, in metres from the middle of the side.
    float along;
    uint32_t cloth;
};

void add_banners(Parts& parts) {
    const Materials& m = parts.materials;
    const uint32_t rod_mesh = add_mesh(parts, rod(0.68f, true));
    const uint32_t wide = add_mesh(parts, banner(2.75f, 1));
    const uint32_t other = add_mesh(parts, banner(2.75f, 2));
    const std::vector<Hanging> hangings{{-6, m.cloth_red}, {0, m.cloth_indigo}, {6, m.cloth_red}};
    for (const float turn : {0.5f * kPi, -0.5f * kPi}) {
        for (const Hanging& hanging : hangings) {
            const glm::mat4 at = moved({0, 0, 0}, turn) * moved({hanging.along, 5.84f, 0.6f - kCourtHalfX});
            place_copy(parts, rod_mesh, m.iron, at);
            place_copy(parts, hanging.cloth == m.cloth_red ? wide : other, hanging.cloth, at);
        }
    }
}

void add_curtains(Parts& parts) {
    const Materials& m = parts.materials;
    constexpr float kLength = kSpring - 0.1f - kFloor - 0.06f;
    const uint32_t rod_mesh = add_mesh(parts, rod(1.2f, false));
    const uint32_t left = add_mesh(parts, curtain(1, kLength));
    const uint32_t right = add_mesh(parts, curtain(-1, kLength));
    MeshBuilder builder;
    builder.add_torus(0.085f, 0.016f, 10, 3);
    const uint32_t tie = add_mesh(parts, builder.finish("curtain_tie"));
    struct Bay {
        float turn;
        float distance;
        float along;
        uint32_t cloth;
    };
    const std::vector<Bay> bays{{0, kCourtHalfZ, -1.5f, m.cloth_saffron},
                                {0, kCourtHalfZ, 1.5f, m.cloth_saffron},
                                {-0.5f * kPi, kCourtHalfX, -1.5f, m.cloth_red},
                                {0.5f * kPi, kCourtHalfX, 4.5f, m.cloth_saffron}};
    for (const Bay& bay : bays) {
        const glm::mat4 at = moved({0, 0, 0}, bay.turn) * moved({bay.along, kSpring - 0.1f, -bay.distance});
        place_copy(parts, rod_mesh, m.iron, at);
        place_copy(parts, left, bay.cloth, at);
        place_copy(parts, right, bay.cloth, at);
        for (const float side : {-1.0f, 1.0f})
            place_copy(parts, tie, m.gold, at * moved({side * 0.99f, -0.56f * kLength - 0.04f, 0}));
    }
}

}  // namespace

void add_cloth(Parts& parts) {
    add_banners(parts);
    add_curtains(parts);
}

}  // namespace weft::scene::atrium
