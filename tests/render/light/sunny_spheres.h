// Purpose: the built-in scene "spheres" in the light of a picture with a sun.
#pragma once

#include <gtest/gtest.h>

#include "scene/pictures/load_environment.h"
#include "weft/scene/builtin_scenes.h"

namespace weft::test {

// The lights are those that `weft render --env` makes of the suns of the picture. `gain` multiplies all
// light.
inline scene::Scene sunny_spheres(float gain = 1) {
    Result<scene::Scene> made = scene::make_builtin("spheres");
    Result<scene::Environment> picture =
        scene::load_environment(WEFT_SOURCE_DIR "/tests/reference/environments/day.hdr", {}, gain);
    EXPECT_TRUE(made && picture);
    if (!made || !picture) return {};
    scene::Scene scene = std::move(*made);
    scene.lights.clear();
    scene.environment = std::move(*picture);
    for (const scene::PictureSun& sun : scene.environment.suns) {
        scene::Light light;
        light.type = scene::LightType::directional;
        light.intensity = sun.illuminance_lx.g;
        light.color = sun.illuminance_lx / light.intensity;
        light.direction = -sun.to_sun;
        light.angular_radius_rad = sun.angular_radius_rad;
        scene.lights.push_back(light);
    }
    return scene;
}

}  // namespace weft::test
