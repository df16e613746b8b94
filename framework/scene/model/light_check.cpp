#include "scene/model/light_check.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace weft::scene {
namespace {

// Upper limit for the intensity of a light, in cd, lx or cd/m² (see Light::intensity). For comparison: the
// sun's disc has a luminance of 1.6e9 cd/m².
constexpr float kMaxIntensity = 1e12f;
constexpr float kMaxLength_m = 1e9f;
constexpr float kMinHalfSize_m = 1e-4f;
constexpr float kMaxHalfSize_m = 1e6f;
constexpr float kHalfPi = 1.5707963268f;
constexpr float kMostAngularRadius_rad = 0.5235987756f;
constexpr float kMinSoftness = 1e-4f;
constexpr float kMaxFactor = 1e6f;
constexpr size_t kMaxNamed = 8;  // Number of faults that have their own warning.

class Faults {
 public:
    void add(const char* what) { text_ += (text_.empty() ? "" : ", ") + std::string(what); }
    // Clamps `value` to the range from `low` to `high`; NaN becomes `low`. If this changes the value, the
    // text `what` is added to the list of faults.
    void clamp(float& value, float low, float high, const char* what) {
        const float within = std::isnan(value) ? low : std::clamp(value, low, high);
        if (within == value) return;
        value = within;
        add(what);
    }
    [[nodiscard]] std::string take() { return std::move(text_); }

 private:
    std::string text_;
};

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool within_world(const glm::vec3& v) {
    return finite(v) && std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= kMaxLength_m;
}

// Returns a horizontal unit vector (y = 0) perpendicular to the unit vector `direction`. If `direction` is
// almost vertical, the result is +x.
glm::vec3 across(const glm::vec3& direction) {
    const glm::vec3 level(-direction.z, 0, direction.x);
    const float length = glm::length(level);
    return length > 1e-3f ? level / length : glm::vec3(1, 0, 0);
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& fallback) {
    const float length = glm::length(v);
    return std::isfinite(length) && length > 1e-20f ? v / length : fallback;
}

bool is_unit(const glm::vec3& v) {
    return std::abs(glm::dot(v, v) - 1) < 1e-3f;
}

void clamp_axes(Light& light, Faults& faults) {
    if (!is_unit(light.direction)) {
        faults.add("the direction was not a unit vector");
        light.direction = unit_or(light.direction, {0, 0, -1});
    }
    const glm::vec3 side = light.side - light.direction * glm::dot(light.side, light.direction);
    if (light.side != glm::vec3(0) && !(glm::length(side) > 1e-3f && finite(side)))
        faults.add("the side was not perpendicular to the direction");
    light.side = finite(side) && glm::length(side) > 1e-3f ? glm::normalize(side) : across(light.direction);
}

void clamp_shape(Light& light, Faults& faults) {
    if (light.type == LightType::rectangle || light.type == LightType::capsule) {
        const float least = light.type == LightType::rectangle ? kMinHalfSize_m : 0;
        faults.clamp(light.half_size_m.x, least, kMaxHalfSize_m, "the size was out of range");
        faults.clamp(light.half_size_m.y, kMinHalfSize_m, kMaxHalfSize_m, "the size was out of range");
    }
    if (light.type == LightType::directional)
        faults.clamp(light.angular_radius_rad, 0, kMostAngularRadius_rad,
                     "the angular radius was not within 0 to 30°");
    if (light.type != LightType::spot) return;
    faults.clamp(light.outer_cone_rad, 0, kHalfPi, "the outer cone was not within 0 to 90°");
    faults.clamp(light.inner_cone_rad, 0, light.outer_cone_rad,
                 "the inner cone was not within the outer cone");
}

void clamp_place(Light& light, Faults& faults) {
    if (!within_world(light.position)) {
        faults.add("the position was not finite");
        light.position = glm::vec3(0);
        light.intensity = 0;
    }
    const LightPath& path = light.path;
    const bool goes_round = path.turns_per_s != 0;
    if (!goes_round || (within_world(path.across) && within_world(path.along) && std::isfinite(path.phase) &&
                        std::isfinite(path.turns_per_s)))
        return;
    faults.add("the path was not finite");
    light.path = {};
}

std::string named(const char* kind, size_t index, const std::string& name) {
    return std::string(kind) + " " + (name.empty() ? std::to_string(index) : "\"" + name + "\"");
}

Diagnostic warning(std::string message, std::string help) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::warning;
    diagnostic.code = "S158";
    diagnostic.message = std::move(message);
    diagnostic.help = {std::move(help)};
    return diagnostic;
}

// Returns a text if the picture of `function` cannot be used, otherwise an empty text. `pictures` is the set
// of pictures that earlier functions use; picture_fault() adds the picture of `function` to this set.
std::string picture_fault(const LightFunction& function, const Scene& scene, std::set<uint32_t>& pictures) {
    if (function.picture == kNone) return {};
    if (function.picture >= scene.textures.size())
        return "the scene has no texture with the index of the picture";
    pictures.insert(function.picture);
    const bool room = pictures.size() <= kMaxLightPictures;
    return room ? ""
                : "the picture is ignored, because Weft uses only " + std::to_string(kMaxLightPictures) +
                      " pictures for lights";
}

}  // namespace

std::string clamp_light(Light& light) {
    Faults faults;
    clamp_place(light, faults);
    faults.clamp(light.intensity, 0, kMaxIntensity, "the intensity was out of range");
    for (int i = 0; i < 3; ++i) faults.clamp(light.color[i], 0, kMaxFactor, "the colour was out of range");
    faults.clamp(light.range_m, 0, kMaxLength_m, "the range was not within its limits");
    clamp_axes(light, faults);
    clamp_shape(light, faults);
    return faults.take();
}

std::string clamp_light_function(LightFunction& function) {
    Faults faults;
    for (int i = 0; i < 4; ++i) {
        faults.clamp(function.doors[i], -kMaxLength_m, LightFunction::kNoDoor, "the doors were out of range");
        faults.clamp(function.curve[i], 0, kMaxFactor, "the curve was out of range");
    }
    faults.clamp(function.softness, kMinSoftness, kMaxLength_m, "the softness was out of range");
    faults.clamp(function.reach_m, 1e-3f, kMaxLength_m, "the reach was out of range");
    for (int i = 0; i < 2; ++i)
        faults.clamp(function.picture_half_size[i], 1e-3f, kMaxLength_m,
                     "the size of the picture was out of range");
    return faults.take();
}

Diagnostics light_warnings(const Scene& scene) {
    Diagnostics warnings;
    size_t faults = 0;
    const auto note = [&](const char* kind, size_t index, const std::string& name, const std::string& fault) {
        if (fault.empty() || ++faults > kMaxNamed) return;
        warnings.push_back(warning(
            named(kind, index, name) + ": " + fault,
            "correct the value in the program that made the scene; Weft clamped it or made the light dark"));
    };
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        Light light = scene.lights[i];
        note("light", i, light.name, clamp_light(light));
        if (light.function != kNone && light.function >= scene.light_functions.size())
            note("light", i, light.name, "the scene has no light function with the index of its function");
    }
    std::set<uint32_t> pictures;
    for (size_t i = 0; i < scene.light_functions.size(); ++i) {
        LightFunction function = scene.light_functions[i];
        note("light function", i, function.name, clamp_light_function(function));
        note("light function", i, function.name, picture_fault(function, scene, pictures));
    }
    if (faults > kMaxNamed)
        warnings.push_back(warning(
            std::to_string(faults - kMaxNamed) + " further lights or light functions have wrong values, too",
            "correct the values in the program that made the scene"));
    return warnings;
}

}  // namespace weft::scene
