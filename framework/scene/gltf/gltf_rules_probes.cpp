#include <nlohmann/json.hpp>

#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {

void check_probe_extras(Checker& c, const nlohmann::json& extras) {
    uint32_t self = 0;
    c.root.each("nodes", c.limits.array_items, [&](const Fields& node) {
        const uint32_t index = self++;
        const std::optional<Fields> fields =
            extras_object(c, extras[index], node.pointer_to("extras/weft/probe"),
                          "write {}, or for example { \"position\": [0, 0.5, 0] }, or remove the key");
        if (!fields) return;
        ProbeSource probe;
        const std::vector<double> position = fields->numbers("position", 3);
        if (!position.empty()) probe.position = glm::vec3(position[0], position[1], position[2]);
        warn_of_other_keys(c, *fields, {"position"});
        c.out.probes[index] = probe;
    });
}

}  // namespace weft::scene::gltf
