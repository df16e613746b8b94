// Purpose: chooses the lamps that have shadow maps, and the views of these maps. If a graph draws fewer maps
// than the lamps of the scene need, the lamps with the largest influence on the picture get them. A lamp
// keeps its maps as long as it is chosen, so that maps of lamps that do not move stay the same. Layout of the
// maps: shaders/include/shared/lamp_shadow.glsl. Units: metres.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "shared/frame.glsl"
#include "shared/light.glsl"
#include "weft/plan.h"

namespace weft::render {

// Name of the list with the views of the shadow maps.
inline constexpr const char* kLampShadowViews = "lampShadows";

// Returns the number of maps that a light needs: 0 for directional lights.
[[nodiscard]] uint32_t count_lamp_maps(const shared::Light& light);
// Returns the number of maps that the passes of a plan draw.
[[nodiscard]] uint32_t drawn_lamp_maps(const FramePlan& plan);
// Returns how much of the picture a lamp lights, and how brightly, as a number to compare lamps with.
[[nodiscard]] float lamp_influence(const shared::Light& light, const shared::ViewConstants& camera);

class LampShadows {
 public:
    // Chooses the lamps of a frame for `maps` shadow maps.
    void update(std::span<const shared::Light> lights, const shared::ViewConstants& camera, uint32_t maps);
    // Returns the lights of the last update(). Light::shadow of each chosen lamp tells its maps.
    [[nodiscard]] const std::vector<shared::Light>& lights() const { return lights_; }
    // Returns the same lights in the order of the buffer `lights`: the chosen ones of the plain lights (see
    // plain_light.h) follow after the others.
    [[nodiscard]] const std::vector<shared::Light>& ordered() const { return ordered_; }
    // Returns how many plain lights are before the chosen ones.
    [[nodiscard]] uint32_t count_unshadowed() const { return count_unshadowed_; }
    // Returns the view of each map. Maps that no lamp uses have a view that shows nothing.
    [[nodiscard]] const std::vector<shared::ViewConstants>& views() const { return views_; }

 private:
    [[nodiscard]] std::vector<uint32_t> choose(const shared::ViewConstants& camera, uint32_t maps) const;
    [[nodiscard]] bool place(std::span<const uint32_t> chosen, uint32_t maps);
    void order();

    std::vector<shared::Light> lights_, ordered_;
    uint32_t count_unshadowed_ = 0;
    std::vector<shared::ViewConstants> views_;
    std::map<uint32_t, uint32_t>
        first_maps_;  // The first map of each chosen lamp, by the index of the light.
};

}  // namespace weft::render
