#include "scene_source.h"

#include <algorithm>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/builtin_scenes.h"
#include "scene/load_environment.h"
#include "scene/load_gltf.h"

namespace weft::viewer {
namespace {

constexpr std::string_view kBuiltinPrefix = "builtin:";

// Luminances near 1, so that a file's own lights of a few candela or lux show at exposure 0.
constexpr glm::vec3 kPlainSkyZenith{0.28f, 0.42f, 0.70f};
constexpr glm::vec3 kPlainSkyHorizon{0.75f, 0.82f, 0.90f};

scene::Light plain_sun() {
    scene::Light sun;
    sun.name = "sun of the plain sky";
    sun.type = scene::LightType::directional;
    sun.color = {1.0f, 0.96f, 0.9f};
    sun.intensity = 3.0f;
    sun.direction = glm::normalize(glm::vec3(-0.45f, -0.8f, -0.4f));
    return sun;
}

Status apply_environment(scene::Scene& scene, const std::string& env) {
    if (env != "sky") scene.sky_zenith = scene.sky_horizon = glm::vec3(0);
    if (env == "none") return Unit{};
    if (env != "sky") {
        Result<scene::Environment> picture = scene::load_environment(env);
        if (!picture) return picture.take_errors();
        scene.environment = std::move(*picture);
        return Unit{};
    }
    const bool has_sky = scene.sky_zenith != glm::vec3(0) || scene.sky_horizon != glm::vec3(0);
    if (has_sky) return Unit{};
    scene.sky_zenith = kPlainSkyZenith;
    scene.sky_horizon = kPlainSkyHorizon;
    if (scene.lights.empty()) scene.lights.push_back(plain_sun());
    return Unit{};
}

std::vector<float> numbers(const std::string& text) {
    std::vector<float> values;
    const char* at = text.c_str();
    while (*at) {
        char* end = nullptr;
        const float value = std::strtof(at, &end);
        if (end == at || !std::isfinite(value)) return {};
        values.push_back(value);
        at = *end == ',' ? end + 1 : end;
        if (*end && *end != ',') return {};
    }
    return values;
}

Diagnostic camera_error(const std::string& code, std::string message, std::string help) {
    Diagnostic d;
    d.code = code;
    d.message = std::move(message);
    d.help = {std::move(help)};
    return d;
}

Result<scene::Camera> placed_camera(const std::string& choice) {
    const std::vector<float> n = numbers(choice);
    const std::string help = "--camera EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG: metres and degrees";
    if (n.size() != 7)
        return camera_error("X520", "a camera is a name or seven numbers, not \"" + choice + "\"", help);
    const glm::vec3 eye(n[0], n[1], n[2]), at(n[3], n[4], n[5]);
    if (glm::distance(eye, at) < 1e-6f || n[6] <= 0 || n[6] >= 180)
        return camera_error(
            "X520", "this camera looks nowhere: \"" + choice + "\"",
            "eye and target must differ, and the field of view lie between 0 and 180 degrees");
    const glm::vec3 forward = glm::normalize(at - eye);
    const glm::vec3 up = std::abs(forward.y) > 0.999f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    scene::Camera camera;
    camera.name = "placed";
    camera.transform = glm::inverse(glm::lookAt(eye, at, up));
    camera.fov_y_rad = glm::radians(n[6]);
    return camera;
}

}  // namespace

Result<scene::Scene> open_scene(const std::string& name, const std::string& env, Diagnostics& warnings) {
    Result<scene::Scene> scene = name.starts_with(kBuiltinPrefix)
                                     ? scene::make_builtin(name.substr(kBuiltinPrefix.size()))
                                     : scene::load_gltf(name, warnings);
    if (!scene) return scene;
    if (Status applied = apply_environment(*scene, env); !applied) return applied.take_errors();
    return scene;
}

Result<scene::Camera> choose_camera(const scene::Scene& scene, const std::string& choice, float aspect) {
    if (choice.empty())
        return scene.cameras.empty() ? scene::framing_camera(scene, aspect) : scene.cameras.front();
    const auto found = std::find_if(scene.cameras.begin(), scene.cameras.end(),
                                    [&](const scene::Camera& camera) { return camera.name == choice; });
    if (found != scene.cameras.end()) return *found;
    if (choice.find(',') != std::string::npos) return placed_camera(choice);
    std::vector<std::string> names;
    for (const scene::Camera& camera : scene.cameras) names.push_back(camera.name);
    std::string known = "this scene has no cameras of its own: give seven numbers, or leave --camera out";
    for (size_t i = 0; i < names.size(); ++i) known = (i == 0 ? "its cameras are " : known + ", ") + names[i];
    Diagnostic fault = camera_error("S130", "the scene has no camera \"" + choice + "\"", known);
    const std::string guess = did_you_mean_text(choice, names);
    if (!guess.empty()) fault.help.insert(fault.help.begin(), guess);
    return fault;
}

}  // namespace weft::viewer
