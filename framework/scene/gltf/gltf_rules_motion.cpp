#include <algorithm>

#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {
namespace {

std::vector<std::string> labels_of(const Checker& c, const char* array, const char* kind) {
    std::vector<std::string> labels;
    c.root.each(array, c.limits.array_items, [&](const Fields& item) {
        labels.push_back(label(kind, labels.size(), item.text("name", Need::optional).value_or("")));
    });
    return labels;
}

void check_skins(Checker& c, const std::vector<std::string>& nodes, const std::vector<std::string>& meshes) {
    size_t self = 0;
    c.root.each("nodes", c.limits.array_items, [&](const Fields& node) {
        const std::string& name = nodes[self++];
        if (!node.has("skin")) return;
        node.index("skin", Need::optional, c.sizes["skins"], "skins");
        const uint32_t mesh = node.index("mesh", Need::optional, meshes.size(), "meshes");
        if (mesh == kNone || mesh >= meshes.size()) return;
        c.report.warn("S153", node.pointer_to("skin"),
                      name + ": the skin is ignored, so " + meshes[mesh] + " is shown without a pose",
                      "apply the wanted pose to the mesh before exporting");
    });
}

void check_morphs(Checker& c, const std::vector<std::string>& meshes) {
    size_t self = 0;
    c.root.each("meshes", c.limits.array_items, [&](const Fields& mesh) {
        const std::string& name = meshes[self++];
        size_t targets = 0;
        mesh.each("primitives", c.limits.array_items, [&](const Fields& primitive) {
            targets = std::max(targets, primitive.array_size("targets", c.limits.array_items));
        });
        if (targets == 0) return;
        c.report.warn("S153", mesh.pointer(),
                      name + ": morph targets (" + std::to_string(targets) +
                          ") are ignored, so the base shape is shown",
                      "apply the wanted shape before exporting");
    });
}

}  // namespace

void check_motion(Checker& c) {
    // After an error the check ends here. If an array has wrong items, labels_of() skips them, so the labels
    // would not match the nodes and meshes.
    if (c.report.failed()) return;
    const std::vector<std::string> nodes = labels_of(c, "nodes", "node");
    const std::vector<std::string> meshes = labels_of(c, "meshes", "mesh");
    check_skins(c, nodes, meshes);
    check_morphs(c, meshes);
}

}  // namespace weft::scene::gltf
