#include "viewer/commands/scene_source.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/builtin/seeded_lights.h"
#include "scene/pictures/load_environment.h"
#include "viewer/files/files.h"
#include "viewer/options/numbers.h"
#include "viewer/output/progress_text.h"
#include "weft/scene/builtin_scenes.h"
#include "weft/scene/camera_path.h"
#include "weft/scene/load_gltf.h"

namespace weft::viewer {
namespace {

constexpr std::string_view kBuiltinPrefix = "builtin:";

// The aspect ratio (width / height) for which the cameras of the built-in scenes were placed. In a portrait
// picture, the default camera of such a scene shows as much to the left and right as in a picture of this
// aspect ratio. Exception: a camera inside the scene does not change.
constexpr float kShownAspect = 4.0f / 3.0f;

// Allowed coordinates of --camera. For places that are farther from the origin, 32-bit floats are too coarse.
constexpr NumberRange kPlace{-1e9, 1e9, "m"};
constexpr NumberRange kFieldOfView{0.01, 179, "degrees"};

// Colours of the default sky in cd/m². The values are near 1, so that lights of a few candela or lux in a
// scene file are visible beside the sky at exposure 0.
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

// Returns the directional light for a sun of the environment picture. `number`: 0 for the brightest sun.
scene::Light light_of_sun(const scene::PictureSun& sun, const std::string& picture, size_t number) {
    const glm::vec3& lx = sun.illuminance_lx;
    scene::Light light;
    light.name = picture + " sun " + std::to_string(number + 1);
    light.type = scene::LightType::directional;
    light.intensity = std::max({lx.r, lx.g, lx.b});
    light.color = lx / light.intensity;
    light.direction = -sun.to_sun;
    light.angular_radius_rad = sun.angular_radius_rad;
    return light;
}

Status apply_environment(scene::Scene& scene, const SceneChoice& choice, const SceneLimits& limits) {
    const std::string& env = choice.env;
    if (env != "sky") scene.sky_zenith = scene.sky_horizon = glm::vec3(0);
    if (env == "none") return Unit{};
    if (env != "sky") {
        Result<scene::Environment> picture = scene::load_environment(env, limits, choice.env_gain);
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

// Parses numbers separated by commas. Returns an empty list if one of them is not a finite number.
std::vector<double> numbers(const std::string& text) {
    std::vector<double> values;
    for (size_t at = 0; at <= text.size();) {
        const size_t end = std::min(text.find(',', at), text.size());
        const std::optional<double> value = finite_number(std::string_view(text).substr(at, end - at));
        if (!value) return {};
        values.push_back(*value);
        at = end + 1;
    }
    return values;
}

Diagnostic choice_error(const std::string& code, std::string message, std::string help) {
    Diagnostic d;
    d.code = code;
    d.message = std::move(message);
    d.help = {std::move(help)};
    return d;
}

Diagnostic no_hours(const std::string& scene) {
    return choice_error(
        "X521", "\"" + scene + "\" has no time of day",
        "remove --time, or choose builtin:atrium or builtin:lights, which have a time of day");
}

Result<scene::Camera> placed_camera(const std::string& choice) {
    const std::vector<double> n = numbers(choice);
    const std::string help = "give --camera EYE_X,EYE_Y,EYE_Z,AT_X,AT_Y,AT_Z,FOVY_DEG, in metres and degrees";
    if (n.size() != 7)
        return choice_error("X520", "\"" + choice + "\" is not a camera; wanted a name or seven numbers",
                            help);
    for (size_t i = 0; i < n.size(); ++i) {
        const NumberRange& range = i == 6 ? kFieldOfView : kPlace;
        if (n[i] < range.least || n[i] > range.most)
            return choice_error(
                "X520",
                "number " + std::to_string(i + 1) + " of the camera is out of range: \"" + choice + "\"",
                std::string(i == 6 ? "give a field of view of " : "give a coordinate of ") + describe(range));
    }
    const glm::vec3 eye(n[0], n[1], n[2]), at(n[3], n[4], n[5]);
    if (glm::distance(eye, at) < 1e-6f)
        return choice_error(
            "X520",
            "the camera has no view direction, because it looks at its own position: \"" + choice + "\"",
            "give two different points: the position of the camera, and the point that it looks at");
    scene::Camera camera = scene::camera_looking_at(eye, at, static_cast<float>(glm::radians(n[6])));
    camera.name = "placed";
    return camera;
}

bool is_inside(const scene::Camera& camera, const scene::Bounds& bounds) {
    const glm::vec3 eye(camera.transform[3]);
    return glm::all(glm::greaterThan(eye, bounds.min)) && glm::all(glm::lessThan(eye, bounds.max));
}

scene::Camera default_camera(const scene::Scene& scene, const CameraChoice& choice) {
    if (scene.cameras.empty()) return scene::framing_camera(scene, choice.aspect);
    scene::Camera camera = scene.cameras.front();
    const bool portrait = choice.aspect < 1 && choice.scene.starts_with(kBuiltinPrefix);
    if (!portrait || is_inside(camera, world_bounds(scene))) return camera;
    const float sideways = std::tan(camera.fov_y_rad / 2) * kShownAspect;
    camera.fov_y_rad = 2 * std::atan(sideways / choice.aspect);
    return camera;
}

// Loads a glTF file and prints the progress to stderr.
Result<scene::Scene> load_file(const std::string& name, const SceneLimits& limits, Diagnostics& warnings) {
    const auto begin = std::chrono::steady_clock::now();
    ProgressText text("loading " + std::filesystem::path(name).filename().string(),
                      isatty(STDERR_FILENO) == 1);
    scene::LoadOptions options;
    options.progress = [&](const scene::LoadProgress& now) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        std::fputs(text.at(elapsed.count(), now.what, now.done, now.total).c_str(), stderr);
    };
    Result<scene::Scene> scene = scene::load_gltf(name, warnings, limits, options);
    std::fputs(text.finish().c_str(), stderr);
    return scene;
}

}  // namespace

Status expect_scene(const std::string& name) {
    if (name.starts_with(kBuiltinPrefix) || std::filesystem::path(name).extension() != ".json") return Unit{};
    const std::optional<std::string> text = read_file(name, GraphLimits{}.json_bytes);
    if (!text || text->find("\"passes\"") == std::string::npos ||
        text->find("\"asset\"") != std::string::npos)
        return Unit{};
    return choice_error("X522", "\"" + name + "\" is a graph, not a scene",
                        "to render a scene with this graph, use `weft render --graph " + name + "`");
}

Result<scene::Scene> open_scene(const SceneChoice& choice, const SceneLimits& limits, Diagnostics& warnings) {
    const bool builtin = choice.name.starts_with(kBuiltinPrefix);
    const std::string name = builtin ? choice.name.substr(kBuiltinPrefix.size()) : choice.name;
    if (choice.hour && !(builtin && scene::has_hours(name))) return no_hours(choice.name);
    scene::BuiltinOptions options;
    options.hour = choice.hour;
    options.lights = choice.lights.value_or(options.lights);
    options.seed = choice.seed;
    Result<scene::Scene> scene =
        builtin ? scene::make_builtin(name, options) : load_file(name, limits, warnings);
    if (!scene) return scene;
    // The environment picture may use only the part of the memory limit that the scene does not use.
    SceneLimits rest = limits;
    rest.memory_bytes -= std::min(rest.memory_bytes, scene->memory_bytes);
    if (Status applied = apply_environment(*scene, choice, rest); !applied) return applied.take_errors();
    const bool has_seeded_lights = builtin && name == "lights";
    if (choice.lights && !has_seeded_lights)
        scene->lights = scene::seeded_lights(*scene, *choice.lights, choice.seed);
    const std::vector<scene::PictureSun>& suns = scene->environment.suns;
    for (size_t i = 0; i < suns.size(); ++i)
        scene->lights.push_back(light_of_sun(suns[i], scene->environment.name, i));
    return scene;
}

Result<scene::Camera> choose_camera(const scene::Scene& scene, const CameraChoice& choice) {
    const std::string& wanted = choice.camera;
    if (wanted.empty()) return default_camera(scene, choice);
    const auto found = std::find_if(scene.cameras.begin(), scene.cameras.end(),
                                    [&](const scene::Camera& camera) { return camera.name == wanted; });
    if (found != scene.cameras.end()) return *found;
    if (wanted.find(',') != std::string::npos) return placed_camera(wanted);
    std::vector<std::string> names;
    for (const scene::Camera& camera : scene.cameras) names.push_back(camera.name);
    std::string known = "the scene has no cameras: give seven numbers, or remove --camera";
    for (size_t i = 0; i < names.size(); ++i)
        known = (i == 0 ? "the cameras of the scene are: " : known + ", ") + names[i];
    Diagnostic fault = choice_error("S130", "the scene has no camera \"" + wanted + "\"", known);
    const std::string guess = did_you_mean_text(wanted, names);
    if (!guess.empty()) fault.help.insert(fault.help.begin(), guess);
    return fault;
}

}  // namespace weft::viewer
