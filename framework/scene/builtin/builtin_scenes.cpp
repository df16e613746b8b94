#include "weft/scene/builtin_scenes.h"

#include "scene/builtin/builtin_atrium.h"
#include "scene/builtin/builtin_brushed.h"
#include "scene/builtin/builtin_cornell.h"
#include "scene/builtin/builtin_materials.h"
#include "scene/builtin/builtin_spheres.h"
#include "scene/builtin/builtin_stage.h"
#include "scene/builtin/daylight.h"
#include "scene/builtin/seeded_lights.h"

namespace weft::scene {
namespace {

constexpr float kNight = 22;  // Hour of the day.

Scene make_lights(const BuiltinOptions& options) {
    Scene scene = make_atrium(options.hour.value_or(kNight));
    scene.name = "lights";
    scene.lights = moving_lights(scene, options.lights, options.seed);
    return scene;
}

}  // namespace

std::vector<std::string> builtin_scene_names() {
    return {"atrium", "brushed", "cornell", "lights", "materials", "mirror", "spheres", "stage"};
}

bool has_hours(std::string_view name) {
    return name == "atrium" || name == "lights";
}

Result<Scene> make_builtin(std::string_view name, const BuiltinOptions& options) {
    if (name == "atrium") return make_atrium(options.hour.value_or(kDefaultHour));
    if (name == "lights") return make_lights(options);
    if (name == "brushed") return make_brushed();
    if (name == "cornell") return make_cornell();
    if (name == "materials") return make_materials();
    if (name == "mirror") return make_mirror();
    if (name == "spheres") return make_spheres();
    if (name == "stage") return make_stage();
    Diagnostic error;
    error.code = "S120";
    error.message = "there is no built-in scene \"" + std::string(name) + "\"";
    const std::string hint = did_you_mean_text(std::string(name), builtin_scene_names());
    if (!hint.empty()) error.help.push_back(hint);
    std::string known = "the built-in scenes are:";
    for (const std::string& scene : builtin_scene_names()) known += " builtin:" + scene;
    error.help.push_back(known);
    return error;
}

}  // namespace weft::scene
