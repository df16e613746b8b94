#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {
namespace {

constexpr double kMaxLength_m = 1e6;
constexpr double kMinLength_m = 1e-3;
constexpr double kMaxFactor = 1e6;
constexpr double kQuarterPi = kHalfPi / 2;

float number_within(const Fields& fields, const char* key, double fallback, double low, double high) {
    const std::optional<double> value = fields.number(key, Need::optional);
    if (!value) return static_cast<float>(fallback);
    fields.number_in(key, low, high);
    return static_cast<float>(std::clamp(*value, low, high));
}

void warn_of_clamps(Checker& c, const Fields& fields, const char* key, double low, double high) {
    c.report.warn("S154", fields.pointer_to(key),
                  "\"" + std::string(key) + "\" has numbers out of range, which were clamped",
                  "keep the numbers between " + describe(low) + " and " + describe(high));
}

template <class Vector>
Vector vector_within(Checker& c, const Fields& fields, const char* key, const Vector& fallback, double low,
                     double high) {
    const std::vector<double> values = fields.numbers(key, static_cast<size_t>(Vector::length()));
    if (values.empty()) return fallback;
    Vector out;
    bool within = true;
    for (int i = 0; i < Vector::length(); ++i) {
        const double value = values[static_cast<size_t>(i)];
        within = within && value >= low && value <= high;
        out[i] = static_cast<float>(std::clamp(value, low, high));
    }
    if (!within) warn_of_clamps(c, fields, key, low, high);
    return out;
}

void read_shape(Checker& c, const Fields& extras, LightSource& out) {
    const std::optional<std::string> type = extras.text("type", Need::optional);
    if (!type) return;
    if (*type == "rectangle") {
        out.shape = LightType::rectangle;
        out.half_size_m = vector_within(c, extras, "size", glm::vec2(1), kMinLength_m, kMaxLength_m) * 0.5f;
    } else if (*type == "capsule") {
        out.shape = LightType::capsule;
        out.half_size_m.x = 0.5f * number_within(extras, "length", 1, 0, kMaxLength_m);
        out.half_size_m.y = number_within(extras, "radius", 0.02, kMinLength_m, kMaxLength_m);
    } else {
        extras.wrong("type", "rectangle or capsule");
    }
}

LightFunction read_function(Checker& c, const Fields& fields, bool parallel) {
    warn_of_other_keys(c, fields, {"doors", "softness", "falloff", "picture"});
    LightFunction out;
    out.parallel = parallel;
    const double widest = parallel ? kMaxLength_m : kHalfPi;
    out.doors = vector_within(c, fields, "doors", out.doors, -widest, widest);
    out.softness = number_within(fields, "softness", 0.01, 0, widest);
    if (const std::optional<Fields> falloff = fields.object("falloff", Need::optional)) {
        warn_of_other_keys(c, *falloff, {"curve", "reach"});
        out.curve = vector_within(c, *falloff, "curve", out.curve, 0, kMaxFactor);
        out.reach_m = number_within(*falloff, "reach", 1, kMinLength_m, kMaxLength_m);
    }
    if (const std::optional<Fields> picture = fields.object("picture", Need::optional)) {
        warn_of_other_keys(c, *picture, {"index", "halfSize"});
        out.picture = picture->index("index", Need::required, c.sizes["textures"], "textures");
        const glm::vec2 usual(parallel ? 1.0f : static_cast<float>(kQuarterPi));
        out.picture_half_size = vector_within(c, *picture, "halfSize", usual, kMinLength_m, widest);
    }
    return out;
}

void check_extras(Checker& c, const Fields& extras, const std::string& type, LightSource& out) {
    warn_of_other_keys(c, extras, {"type", "size", "length", "radius", "function"});
    read_shape(c, extras, out);
    const bool parallel = type == "directional";
    if (out.shape && parallel) extras.wrong("type", "no \"type\", because the light is directional");
    if (const std::optional<Fields> function = extras.object("function", Need::optional))
        out.function = read_function(c, *function, parallel);
}

}  // namespace

void warn_of_other_keys(Checker& c, const Fields& fields, std::initializer_list<const char*> known) {
    std::string names;
    for (const char* name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    for (const std::string& key : fields.keys()) {
        if (std::ranges::find(known, key) != known.end()) continue;
        c.report.warn("S153", fields.pointer_to(key),
                      "\"" + shortened(key) + "\" is not a key of this object and is ignored",
                      "remove it, or use one of the keys " + names);
    }
}

std::optional<Fields> extras_object(Checker& c, const nlohmann::json& ours, const std::string& place,
                                    const std::string& example) {
    if (ours.is_null()) return std::nullopt;
    if (ours.is_object()) return Fields(ours, place, c.report);
    const std::string name = place.substr(place.rfind('/') + 1);
    c.report.error("S108", place, "\"" + name + "\" is " + describe(ours) + "; wanted an object", example);
    return std::nullopt;
}

void check_light_extras(Checker& c, const nlohmann::json& extras) {
    const std::optional<Fields> punctual = c.root.extension("KHR_lights_punctual");
    if (!punctual || c.report.failed()) return;
    size_t self = 0;
    punctual->each("lights", c.limits.array_items, [&](const Fields& light) {
        const nlohmann::json& ours = extras[self++];
        c.out.lights.emplace_back();
        const std::optional<Fields> fields = extras_object(
            c, ours, light.pointer_to("extras/weft"),
            "write for example { \"type\": \"rectangle\", \"size\": [1, 1] }, or remove the key");
        if (!fields) return;
        const std::string type = light.text("type", Need::required).value_or("");
        check_extras(c, *fields, type, c.out.lights.back());
    });
}

}  // namespace weft::scene::gltf
