#include "render/imports/light_changes.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace weft::render {
namespace {

using shared::Light;
using shared::LightChange;
using LightBytes = std::array<std::byte, sizeof(Light)>;

LightBytes bytes_of(const Light& light) {
    LightBytes bytes;
    std::memcpy(bytes.data(), &light, sizeof light);
    return bytes;
}

glm::vec3 place_of(const Light& light) {
    return light.type == shared::kLightDirectional ? -light.direction * shared::kFarLight_m : light.position;
}

// The luminous intensity in candela in the direction in which the light is strongest. Light of an area goes
// to all directions of its front by the cosine; a capsule also shines from its side.
float candela_of(const Light& light) {
    const float strongest = std::max({light.intensity.r, light.intensity.g, light.intensity.b});
    const glm::vec2 half = light.half_size_m;
    switch (light.type) {
        case shared::kLightDirectional:
            return strongest * shared::kFarLight_m * shared::kFarLight_m;
        case shared::kLightRectangle:
            return strongest * 4 * half.x * half.y;
        case shared::kLightCapsule:
            return strongest * half.y * (4 * half.x + 3.14159265f * half.y);
        default:
            return strongest;
    }
}

LightChange going_off(const Light& light) {
    return {place_of(light), candela_of(light), place_of(light), 0};
}

LightChange going_on(const Light& light) {
    return {place_of(light), 0, place_of(light), candela_of(light)};
}

// Returns true if only the position and the intensity of the lights differ.
bool differ_in_place(Light before, const Light& now) {
    before.position = now.position;
    before.intensity = now.intensity;
    const bool turns = now.type == shared::kLightDirectional;
    if (turns) before.direction = now.direction;
    return bytes_of(before) == bytes_of(now);
}

// Removes the lights that are in both lists.
void remove_common(std::vector<Light>& before, std::vector<Light>& now) {
    std::map<LightBytes, int> counts;
    for (const Light& light : now) ++counts[bytes_of(light)];
    const auto take = [&](const Light& light) { return counts[bytes_of(light)]-- > 0; };
    std::map<LightBytes, int> common;
    std::erase_if(before, [&](const Light& light) {
        const bool found = take(light);
        if (found) ++common[bytes_of(light)];
        return found;
    });
    std::erase_if(now, [&](const Light& light) { return common[bytes_of(light)]-- > 0; });
}

}  // namespace

std::vector<LightChange> light_changes(std::span<const Light> before, std::span<const Light> now) {
    std::vector<LightChange> changes;
    const auto add = [&](const Light& old, const Light& light) {
        if (bytes_of(old) == bytes_of(light)) return;
        if (differ_in_place(old, light)) {
            changes.push_back({place_of(old), candela_of(old), place_of(light), candela_of(light)});
        } else {
            changes.push_back(going_off(old));
            changes.push_back(going_on(light));
        }
    };
    if (before.size() == now.size()) {
        for (size_t i = 0; i < now.size(); ++i) add(before[i], now[i]);
    } else {
        std::vector<Light> gone(before.begin(), before.end()), come(now.begin(), now.end());
        remove_common(gone, come);
        for (const Light& light : gone) changes.push_back(going_off(light));
        for (const Light& light : come) changes.push_back(going_on(light));
    }
    std::ranges::stable_sort(changes, std::greater{}, [](const LightChange& change) {
        return std::max(change.intensity_before, change.intensity);
    });
    changes.resize(std::min<size_t>(changes.size(), shared::kMostLightChanges));
    return changes;
}

}  // namespace weft::render
