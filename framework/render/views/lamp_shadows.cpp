#include "render/views/lamp_shadows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "render/views/plain_light.h"
#include "render/views/view_matrices.h"
#include "shared/lamp_shadow.glsl"

namespace weft::render {
namespace {

static_assert(shared::kFirstLampMap == shared::kMostSuns + 1);

// The influence of a lamp that has maps counts this many times, so that two lamps with nearly the same
// influence do not take the maps from each other again and again.
constexpr float kKeeps = 1.25f;
// Factor for the influence of a lamp whose light does not reach the picture. Such a lamp may light surfaces
// in a mirror, or may soon be in the picture.
constexpr float kUnseen = 0.05f;

float cone_cosine(const shared::Light& light) {
    return -light.cone_offset / light.cone_scale;
}

// Luminous intensity in the direction in which it is largest, in cd.
float intensity_cd(const shared::Light& light) {
    const float largest = std::max({light.intensity.r, light.intensity.g, light.intensity.b});
    const glm::vec2 half = light.half_size_m;
    if (light.type == shared::kLightRectangle) return largest * 4 * half.x * half.y;
    if (light.type != shared::kLightCapsule) return largest;
    return largest * half.y * (4 * half.x + std::numbers::pi_v<float> * half.y);
}

// Returns true if the sphere is at least partly in the frustum of the camera.
bool sees_sphere(const shared::ViewConstants& camera, const glm::vec3& middle, float radius_m) {
    const glm::mat4 rows = glm::transpose(camera.steady_view_projection);
    for (const glm::vec4& plane :
         {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]})
        if (glm::dot(plane, glm::vec4(middle, 1)) < -radius_m * glm::length(glm::vec3(plane))) return false;
    return true;
}

// Returns the distance that the light can reach, measured from the middle of the lamp. 0: no limit.
float reach_of(const shared::Light& light) {
    return light.range_m > 0 ? light.range_m + light.half_size_m.x + light.half_size_m.y : 0;
}

// Makes the view wider or narrower, so that half its width at the distance 1 is `half`, and gives it a far
// plane at the distance that the light can reach.
shared::ViewConstants map_view(const shared::Light& light, ViewInput view, float half) {
    view.projection[0][0] = 1 / half;
    view.projection[1][1] = -1 / half;
    if (const float reach_m = reach_of(light); reach_m > 0)
        view.projection[2][2] = shared::kLampMapNear_m / reach_m;
    return constants_of(view);
}

shared::ViewConstants map_view(const shared::Light& light, uint32_t map) {
    if (count_lamp_maps(light) > 1)
        return map_view(light, cube_face(glm::dvec3(light.position), map, shared::kLampMapNear_m),
                        shared::kLampMapMargin);
    const float cosine = cone_cosine(light);
    return map_view(light, lamp_views({&light, 1})[0],
                    shared::kLampMapMargin * std::sqrt(1 - cosine * cosine) / cosine);
}

// Finds `count` maps in a row that are free.
std::optional<uint32_t> free_maps(const std::vector<bool>& used, uint32_t count) {
    uint32_t run = 0;
    for (uint32_t i = 0; i < used.size(); ++i) {
        run = used[i] ? 0 : run + 1;
        if (run == count) return i + 1 - count;
    }
    return std::nullopt;
}

}  // namespace

uint32_t count_lamp_maps(const shared::Light& light) {
    if (light.type == shared::kLightDirectional) return 0;
    const bool narrow = light.type == shared::kLightSpot && cone_cosine(light) >= shared::kLeastSpotCosine;
    return narrow ? 1 : kCubeFaces;
}

uint32_t drawn_lamp_maps(const FramePlan& plan) {
    const auto list = std::ranges::find(plan.graph.views, kLampShadowViews, &ViewListDecl::name);
    if (list == plan.graph.views.end()) return 0;
    uint32_t maps = 0;
    const std::string prefix = std::string(kLampShadowViews) + "(";
    for (const PassDecl& pass : plan.graph.passes)
        for (const std::string& view : pass.drawn_views())
            if (view.starts_with(prefix))
                maps = std::max(maps, static_cast<uint32_t>(std::stoul(view.substr(prefix.size()))) + 1);
    return maps;
}

float lamp_influence(const shared::Light& light, const shared::ViewConstants& camera) {
    const float intensity = intensity_cd(light);
    const float reach_m = reach_of(light);
    if (reach_m <= 0) return intensity;
    const float share = reach_m / std::max(glm::distance(light.position, camera.eye), reach_m);
    const float seen = sees_sphere(camera, light.position, reach_m) ? 1 : kUnseen;
    return intensity * share * share * seen;
}

// Returns the indices of the lamps with the largest influence, as many as have room.
std::vector<uint32_t> LampShadows::choose(const shared::ViewConstants& camera, uint32_t maps) const {
    std::vector<uint32_t> order(lights_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<float> influence(lights_.size());
    for (uint32_t i = 0; i < lights_.size(); ++i)
        influence[i] = lamp_influence(lights_[i], camera) * (first_maps_.contains(i) ? kKeeps : 1);
    // There may be many thousands of lights, so only the first of them are sorted. Twice as many as maps are
    // enough to find lamps with one map if the next lamp with six maps has no room.
    const auto sorted = order.begin() + std::min<ptrdiff_t>(std::ssize(order), ptrdiff_t{2} * maps);
    std::partial_sort(order.begin(), sorted, order.end(), [&](uint32_t a, uint32_t b) {
        return influence[a] != influence[b] ? influence[a] > influence[b] : a < b;
    });
    order.erase(sorted, order.end());
    std::vector<uint32_t> chosen;
    uint32_t left = maps;
    for (const uint32_t i : order) {
        const uint32_t needed = count_lamp_maps(lights_[i]);
        if (needed == 0 || needed > left) continue;
        chosen.push_back(i);
        left -= needed;
    }
    return chosen;
}

// Gives maps to all chosen lamps that have none yet. Returns false if the free maps are too scattered.
bool LampShadows::place(std::span<const uint32_t> chosen, uint32_t maps) {
    std::vector<bool> used(maps, false);
    const auto take = [&](uint32_t light, uint32_t first) {
        std::fill_n(used.begin() + first, count_lamp_maps(lights_[light]), true);
    };
    for (const auto& [light, first] : first_maps_) take(light, first);
    for (const uint32_t light : chosen) {
        if (first_maps_.contains(light)) continue;
        const std::optional<uint32_t> first = free_maps(used, count_lamp_maps(lights_[light]));
        if (!first) return false;
        first_maps_.emplace(light, *first);
        take(light, *first);
    }
    return true;
}

void LampShadows::update(std::span<const shared::Light> lights, const shared::ViewConstants& camera,
                         uint32_t maps) {
    // If the lights are others than before, their indices do not tell which lamps had maps.
    const bool same =
        std::ranges::equal(lights, lights_, {}, count_lamp_maps, count_lamp_maps) && views_.size() == maps;
    if (!same) first_maps_.clear();
    lights_.assign(lights.begin(), lights.end());
    views_.assign(maps, {});
    if (maps == 0) return order();
    const std::vector<uint32_t> chosen = choose(camera, maps);
    std::erase_if(first_maps_,
                  [&](const auto& entry) { return std::ranges::find(chosen, entry.first) == chosen.end(); });
    if (!place(chosen, maps)) {
        first_maps_.clear();
        (void)place(chosen, maps);
    }
    for (const auto& [light, first] : first_maps_) {
        for (uint32_t i = 0; i < count_lamp_maps(lights_[light]); ++i)
            views_[first + i] = map_view(lights_[light], i);
        lights_[light].shadow = shared::kFirstLampMap + first;
    }
    order();
}

void LampShadows::order() {
    ordered_ = lights_;
    const auto first_other = std::ranges::find_if_not(ordered_, is_plain);
    const auto shadowed = std::stable_partition(
        ordered_.begin(), first_other,
        [](const shared::Light& light) { return light.shadow < shared::kFirstLampMap; });
    count_unshadowed_ = static_cast<uint32_t>(shadowed - ordered_.begin());
}

}  // namespace weft::render
