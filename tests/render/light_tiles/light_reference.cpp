#include "tests/render/light_tiles/light_reference.h"

#include <algorithm>
#include <cmath>

namespace weft::test {
namespace {

double distance_to_core(const shared::Light& light, const glm::dvec3& from_center) {
    const glm::dvec3 direction(light.direction), side(light.side);
    if (light.type == shared::kLightCapsule) {
        const double half = light.half_size_m.x, along = glm::dot(from_center, direction);
        return glm::length(from_center - direction * std::clamp(along, -half, half));
    }
    if (light.type == shared::kLightRectangle) {
        const glm::dvec3 up = glm::cross(side, direction), half(light.half_size_m.x, light.half_size_m.y, 0);
        const glm::dvec3 local(glm::dot(from_center, side), glm::dot(from_center, up),
                               glm::dot(from_center, direction));
        return glm::length(local - glm::clamp(local, -half, half));
    }
    return glm::length(from_center);
}

}  // namespace

bool reaches(const shared::Light& light, const glm::dvec3& place) {
    if (light.type == shared::kLightDirectional) return true;
    const glm::dvec3 from_center = place - glm::dvec3(light.position);
    if (light.range_m > 0 && distance_to_core(light, from_center) >= light.range_m) return false;
    const double along = glm::dot(from_center, glm::dvec3(light.direction));
    if (light.type == shared::kLightRectangle) return along > 0;
    if (light.type == shared::kLightSpot)
        return along / glm::length(from_center) * double{light.cone_scale} + double{light.cone_offset} > 0;
    return true;
}

BoundingSphere sphere_around(const shared::Light& light) {
    double core = 0;
    if (light.type == shared::kLightCapsule) core = light.half_size_m.x;
    if (light.type == shared::kLightRectangle) core = std::hypot(light.half_size_m.x, light.half_size_m.y);
    return {glm::dvec3(light.position), core + light.range_m, light.range_m <= 0};
}

TilePlaces tile_places(const std::vector<float>& depth, Extent3D size, const shared::ViewConstants& view) {
    const glm::dmat4 to_world = glm::inverse(glm::dmat4(view.projection) * glm::dmat4(view.view));
    const uint32_t across = (size.width + kTilePx - 1) / kTilePx,
                   down = (size.height + kTilePx - 1) / kTilePx;
    TilePlaces tiles(size_t{across} * down);
    for (uint32_t y = 0; y < size.height; ++y)
        for (uint32_t x = 0; x < size.width; ++x) {
            const float z = depth.at(size_t{y} * size.width + x);
            if (z <= 0) continue;
            const glm::dvec4 clip((x + 0.5) / size.width * 2 - 1, (y + 0.5) / size.height * 2 - 1, z, 1);
            const glm::dvec4 place = to_world * clip;
            tiles[size_t{y / kTilePx} * across + x / kTilePx].emplace_back(glm::dvec3(place) / place.w);
        }
    return tiles;
}

std::vector<uint32_t> lights_of_tile(const std::vector<glm::dvec3>& places,
                                     const std::vector<shared::Light>& lights,
                                     const std::vector<BoundingSphere>& spheres, uint32_t first) {
    std::vector<uint32_t> found;
    if (places.empty()) return found;
    glm::dvec3 low = places.front(), high = places.front();
    for (const glm::dvec3& place : places) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    for (uint32_t i = first; i < lights.size(); ++i) {
        const glm::dvec3 gap = glm::clamp(spheres[i].center, low, high) - spheres[i].center;
        const double radius_m = spheres[i].radius_m;
        if (!spheres[i].endless && glm::dot(gap, gap) > radius_m * radius_m * (1 + 1e-9)) continue;
        const auto lit = [&](const glm::dvec3& place) { return reaches(lights[i], place); };
        if (std::ranges::any_of(places, lit)) found.push_back(i);
    }
    return found;
}

}  // namespace weft::test
