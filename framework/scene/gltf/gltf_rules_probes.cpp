#include <nlohmann/json.hpp>

#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {

void check_probe_extras(Checker& c, const nlohmann::json& extras) {
    uint32_t self = 0;
    c.root.each("nodes", c.limits.array_items, [&](const Fields& node) {
        const uint32_t index = self++;
        const nlohmann::json& ours = extras[index];
        if (ours.is_null()) return;
        const std::string place = node.pointer_to("extras/weft/probe");
        if (!ours.is_object()) {
            c.report.error("S108", place, "\"probe\" is " + describe(ours) + "; wanted an object",
                           "write {}, or for example { \"position\": [0, 0.5, 0] }, or remove the key");
            return;
        }
        const Fields fields(ours, place, c.report);
        ProbeSource probe;
        const std::vector<double> position = fields.numbers("position", 3);
        if (!position.empty()) probe.position = glm::vec3(position[0], position[1], position[2]);
        warn_of_other_keys(c, fields, {"position"});
        c.out.probes[index] = probe;
    });
}

}  // namespace weft::scene::gltf
