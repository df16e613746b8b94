// Purpose: adds the atrium's small lamps: strings of bulbs over the court, and candles around the pool. They
// are on at night.
#include <cmath>

#include "scene/builtin/builtin_atrium_parts.h"

namespace weft::scene::atrium {
namespace {

constexpr uint32_t kGarlands = 9, kBulbs = 20;
constexpr float kHookY = 4.72f;
constexpr float kSag = 0.75f;
constexpr uint32_t kWireParts = 10;
constexpr float kBulbRadius = 0.045f;
// A bulb of 10 cd has 130 lm, as a small bulb of 15 W.
constexpr float kBulb_cd = 10, kCandle_cd = 1;
constexpr uint32_t kCandlesAlongSide = 8, kCandlesAcross = 4;

// Returns a point on the wire that hangs between two hooks. `share` is 0 at the first hook and 1 at the
// second.
glm::vec3 on_wire(float z, float share) {
    const float from_middle = 2 * share - 1;
    return {from_middle * kCourtHalfX, kHookY - kSag * (1 - from_middle * from_middle), z};
}

float garland_z(uint32_t garland) {
    return (static_cast<float>(garland) + 0.5f - kGarlands * 0.5f) * 2 * (kCourtHalfZ - 0.8f) / kGarlands;
}

void add_lamp(Parts& parts, const std::string& name, glm::vec3 at, float intensity_cd, float range_m) {
    Light light;
    light.name = name + "_" + std::to_string(parts.scene.lights.size());
    light.type = LightType::point;
    light.color = glm::vec3(1, 0.66f, 0.34f);
    light.intensity = parts.daylight.lamps * intensity_cd;
    light.position = at;
    light.range_m = range_m;
    parts.scene.lights.push_back(light);
}

std::vector<glm::vec3> candle_places() {
    constexpr float kInset = 0.16f;
    const float x = kPoolHalfX - kInset, z = kPoolHalfZ - kInset;
    std::vector<glm::vec3> places;
    const auto spread = [](uint32_t i, uint32_t count) {
        return (static_cast<float>(i) + 0.5f) / static_cast<float>(count) * 2 - 1;
    };
    for (const float side : {-1.0f, 1.0f}) {
        for (uint32_t i = 0; i < kCandlesAlongSide; ++i)
            places.push_back({side * x, kPoolRim, spread(i, kCandlesAlongSide) * z});
        for (uint32_t i = 0; i < kCandlesAcross; ++i)
            places.push_back({spread(i, kCandlesAcross) * x, kPoolRim, side * z});
    }
    return places;
}

}  // namespace

void add_garlands(Parts& parts) {
    MeshBuilder builder;
    std::vector<glm::vec3> wire;
    for (uint32_t i = 0; i <= kWireParts; ++i) wire.push_back(on_wire(0, static_cast<float>(i) / kWireParts));
    builder.add_tube(wire, {0.008f, 0.008f, 3});
    const uint32_t wire_mesh = add_mesh(parts, builder.finish("garland_wire"));
    builder.add_sphere({0, 0, 0}, kBulbRadius, 6, 3);
    const uint32_t bulb_mesh = add_mesh(parts, builder.finish("bulb"));
    for (uint32_t garland = 0; garland < kGarlands; ++garland) {
        const float z = garland_z(garland);
        place_copy(parts, wire_mesh, parts.materials.iron, moved({0, 0, z}));
        for (uint32_t i = 0; i < kBulbs; ++i) {
            const glm::vec3 at =
                on_wire(z, (static_cast<float>(i) + 0.5f) / kBulbs) - glm::vec3(0, kBulbRadius, 0);
            place_copy(parts, bulb_mesh, parts.materials.bulb, moved(at));
            add_lamp(parts, "bulb", at, kBulb_cd, 7);
        }
    }
}

void add_candles(Parts& parts) {
    MeshBuilder builder;
    builder.add_lathe({{0.03f, 0}, {0.055f, 0.05f}, {0.045f, 0.05f}}, {6, 0, 6.283185307f, 0.1f, 0.3f});
    const uint32_t bowl = add_mesh(parts, builder.finish("candle_bowl"));
    builder.add_lathe({{0.022f, 0.01f}, {0.022f, 0.075f}, {0, 0.078f}}, {6, 0, 6.283185307f, 0.1f, 0.14f});
    const uint32_t wax = add_mesh(parts, builder.finish("candle_wax"));
    builder.add_lathe({{0.002f, -0.02f}, {0.013f, 0}, {0.009f, 0.02f}, {0, 0.05f}},
                      {6, 0, 6.283185307f, 0.1f, 0.1f});
    const uint32_t flame = add_mesh(parts, builder.finish("candle_flame"));
    for (const glm::vec3& at : candle_places()) {
        place_copy(parts, bowl, parts.materials.bronze, moved(at));
        place_copy(parts, wax, parts.materials.marble, moved(at));
        if (parts.daylight.lamps > 0)
            place_copy(parts, flame, parts.materials.bulb, moved(at + glm::vec3(0, 0.095f, 0)));
        add_lamp(parts, "candle", at + glm::vec3(0, 0.12f, 0), kCandle_cd, 4);
    }
}

}  // namespace weft::scene::atrium
