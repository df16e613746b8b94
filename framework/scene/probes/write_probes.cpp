#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "weft/scene/place_probes.h"

namespace weft::scene {
namespace {

// Returns the shortest text that gives the same number again.
std::string number(float value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string list(const glm::vec3& v) {
    return "[" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + "]";
}

std::string whole_list(const glm::ivec3& v) {
    return "[" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + "]";
}

std::string point_text(const Probe& probe) {
    std::string text = "{ \"at\": " + whole_list(probe.at);
    if (probe.state == ProbeState::moved) text += ", \"offset\": " + list(probe.offset);
    if (probe.state == ProbeState::dropped) text += ", \"dropped\": true";
    if (const std::optional<glm::ivec3>& other = probe.substitute)
        text += ", \"substitute\": " + whole_list(*other);
    return text + " }";
}

std::string reflection_text(const ReflectionProbe& probe) {
    const nlohmann::json name = probe.name;
    std::string text = "{ \"name\": " + name.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) +
                       ", \"position\": " + list(probe.position);
    if (probe.box) {
        const glm::quat& q = probe.box->rotation;
        text += ", \"box\": { \"center\": " + list(probe.box->center) +
                ", \"size\": " + list(probe.box->half_size_m * 2.0f) + ", \"rotation\": [" + number(q.x) +
                ", " + number(q.y) + ", " + number(q.z) + ", " + number(q.w) + "] }";
    }
    return text + " }";
}

// Writes each item on a line of its own.
template <class Item, class Text>
std::string lines(const std::vector<Item>& items, const char* indent, const Text& text) {
    std::string out = "[";
    for (size_t i = 0; i < items.size(); ++i)
        out += std::string(i == 0 ? "\n" : ",\n") + indent + "  " + text(items[i]);
    return out + (items.empty() ? "]" : std::string("\n") + indent + "]");
}

}  // namespace

std::string probes_to_json(const Probes& probes) {
    const ProbeVolume& volume = probes.volume;
    std::string strides;
    for (const uint32_t stride : volume.strides)
        strides += (strides.empty() ? "" : ", ") + std::to_string(stride);
    return "{\n  \"version\": 1,\n  \"volume\": {\n    \"origin\": " + list(volume.origin) +
           (volume.yaw_deg == 0 ? "" : ",\n    \"yaw\": " + number(volume.yaw_deg)) +
           ",\n    \"spacing\": " + number(volume.spacing_m) + ",\n    \"strides\": [" + strides +
           "],\n    \"probes\": " + lines(volume.probes, "    ", point_text) +
           "\n  },\n  \"reflections\": " + lines(probes.reflections, "  ", reflection_text) + "\n}\n";
}

}  // namespace weft::scene
