#include <algorithm>
#include <cmath>

#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {
namespace {

constexpr double kMaxFovRad = 3.1;

void warn_of_cones(const Fields& cone, Report& report) {
    const double inner = cone.number("innerConeAngle", Need::optional).value_or(0);
    const double outer = cone.number("outerConeAngle", Need::optional).value_or(kHalfPi / 2);
    if (inner < outer) return;
    report.warn("S154", cone.pointer(),
                "innerConeAngle is " + describe(inner) + ", which is not less than outerConeAngle, " +
                    describe(outer) + "; the light gets a hard edge",
                "make innerConeAngle less than outerConeAngle");
}

void check_light(const Fields& light, Report& report) {
    light.text("name", Need::optional);
    const std::string type = light.text("type", Need::required).value_or("point");
    if (type != "point" && type != "spot" && type != "directional")
        light.wrong("type", "directional, point or spot");
    light.numbers("color", 3);
    light.number_in("intensity", 0, kUnbounded);
    if (const std::optional<double> range = light.number("range", Need::optional); range && *range <= 0)
        report.warn("S154", light.pointer_to("range"),
                    "\"range\" is " + describe(*range) + " and is ignored, so the light has no limit",
                    "give the light a range above 0, or remove \"range\"");
    const std::optional<Fields> cone = light.object("spot", type == "spot" ? Need::required : Need::optional);
    if (!cone) return;
    cone->number_in("innerConeAngle", 0, kHalfPi);
    cone->number_in("outerConeAngle", 0, kHalfPi);
    if (!report.failed()) warn_of_cones(*cone, report);
}

// Warns of wrong values of "zfar" and "aspectRatio". Weft ignores both members: the far plane is always at
// infinity, and the size of the rendered picture sets the aspect ratio.
void warn_of_unused(const Fields& perspective, double near, Report& report) {
    const std::optional<double> far = perspective.number("zfar", Need::optional);
    if (far && *far <= near)
        report.warn("S154", perspective.pointer_to("zfar"),
                    "\"zfar\" is " + describe(*far) + ", which is not greater than \"znear\", " +
                        describe(near) + "; \"zfar\" is ignored",
                    "make \"zfar\" greater than \"znear\", or remove \"zfar\"");
    const std::optional<double> aspect = perspective.number("aspectRatio", Need::optional);
    if (aspect && *aspect <= 0)
        report.warn("S154", perspective.pointer_to("aspectRatio"),
                    "\"aspectRatio\" is " + describe(*aspect) + " and is ignored",
                    "give the camera an \"aspectRatio\" above 0, or remove the key");
}

void check_camera(Checker& c, const Fields& camera, size_t self) {
    const std::string name = camera.text("name", Need::optional).value_or("");
    const std::string type = camera.text("type", Need::required).value_or("perspective");
    if (type == "orthographic") {
        camera.object("orthographic", Need::required);
        c.report.warn("S153", camera.pointer(),
                      label("camera", self, name) + " is orthographic and is ignored",
                      "use a perspective camera");
        return;
    }
    if (type != "perspective") camera.wrong("type", "perspective or orthographic");
    const std::optional<Fields> perspective = camera.object("perspective", Need::required);
    if (!perspective) return;
    const std::optional<double> fov = perspective->number("yfov", Need::required);
    if (fov && (*fov <= 0 || *fov > kMaxFovRad))
        perspective->wrong("yfov", "an angle above 0 and at most 3.1 radians");
    const std::optional<double> near = perspective->number("znear", Need::required);
    if (near && *near <= 0) perspective->wrong("znear", "a number above 0");
    warn_of_unused(*perspective, near.value_or(0), c.report);
}

// Checks that the nodes form trees. Every node has at most one parent. So the nodes form trees if each path
// from a node to its parent, to the parent of this parent, and so on, ends at a root.
void check_forest(Checker& c, const std::vector<uint32_t>& parent) {
    // Depth of each node below its root, where a root has depth 1; 0 means that the depth is not computed
    // yet.
    std::vector<uint32_t> depth(parent.size(), 0);
    std::vector<uint32_t> path;
    for (uint32_t start = 0; start < parent.size(); ++start) {
        path.clear();
        uint32_t node = start;
        while (node != kNone && depth[node] == 0 && path.size() <= parent.size()) {
            path.push_back(node);
            node = parent[node];
        }
        const std::string pointer = "/nodes/" + std::to_string(start);
        if (path.size() > parent.size()) {
            c.report.error(
                "S109", pointer + "/children",
                "node " + std::to_string(start) + " is its own descendant, because \"children\" form a cycle",
                "remove the child that closes the cycle");
            return;
        }
        uint32_t levels = node == kNone ? 0 : depth[node];
        for (size_t i = path.size(); i-- > 0;) depth[path[i]] = ++levels;
        if (levels > c.limits.node_depth) {
            c.report.error("S109", pointer,
                           "the node is " + std::to_string(levels) + " levels deep, the limit is " +
                               std::to_string(c.limits.node_depth),
                           "use fewer levels of nodes, " + raise_limit_text("scene.nodeDepth"));
            return;
        }
    }
}

// Warns of a rotation whose length is not 1. Weft normalises such rotations, as other loaders do, and
// replaces a quaternion of length 0 by the identity.
void check_rotation(const Fields& node, Report& report) {
    constexpr double kRounding = 0.01, kNone_length = 1e-6;
    const std::vector<double> xyzw = node.numbers("rotation", 4);
    if (xyzw.empty()) return;
    const double length = std::hypot(std::hypot(xyzw[0], xyzw[1]), std::hypot(xyzw[2], xyzw[3]));
    if (std::abs(length - 1) <= kRounding) return;
    const bool is_zero = length <= kNone_length;
    report.warn(is_zero ? "S152" : "S154", node.pointer_to("rotation"),
                is_zero ? "the rotation is zero and was replaced by [0, 0, 0, 1], which means no rotation"
                        : "the rotation has length " + describe(length) + " and was normalised to length 1",
                "write rotations as unit quaternions [x, y, z, w]");
}

// Warns of a scale of 0. It is legal, and some files hide objects with it, but usually it is a mistake.
void check_scale(const Fields& node, Report& report) {
    const std::vector<double> scale = node.numbers("scale", 3);
    const auto zeros = std::count(scale.begin(), scale.end(), 0.0);
    if (zeros == 0) return;
    report.warn("S152", node.pointer_to("scale"),
                std::string("the scale is zero along ") +
                    (zeros == 1   ? "one axis"
                     : zeros == 2 ? "two axes"
                                  : "all axes") +
                    (zeros == 1 ? ", so the node and its descendants are flat"
                                : ", so the node and its descendants are invisible"),
                "give the node a scale above 0, or remove it");
}

// Warns of a matrix whose last row is not 0, 0, 0, 1, and of a matrix with the determinant 0. The matrix is
// column-major. Translation, rotation and scale always result in the last row 0, 0, 0, 1.
void check_matrix(const Fields& node, Report& report) {
    const std::vector<double> m = node.numbers("matrix", 16);
    if (m.empty()) return;
    constexpr double kRounding = 1e-4;
    const double last_row = std::abs(m[3]) + std::abs(m[7]) + std::abs(m[11]) + std::abs(m[15] - 1);
    if (last_row > kRounding)
        report.warn("S154", node.pointer_to("matrix"),
                    "the last row of the matrix is not 0, 0, 0, 1 and was replaced by it",
                    "end the four columns of the matrix in 0, 0, 0 and 1");
    const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) +
                               m[8] * (m[1] * m[6] - m[2] * m[5]);
    if (determinant == 0)
        report.warn("S152", node.pointer_to("matrix"),
                    "the matrix has the determinant 0, so the node and its descendants are flat",
                    "give the node a scale above 0, or remove it");
}

void check_node(Checker& c, const Fields& node, uint32_t self, std::vector<uint32_t>& parent) {
    node.text("name", Need::optional);
    node.index("mesh", Need::optional, c.sizes["meshes"], "meshes");
    node.index("camera", Need::optional, c.sizes["cameras"], "cameras");
    check_matrix(node, c.report);
    node.numbers("translation", 3);
    check_rotation(node, c.report);
    check_scale(node, c.report);
    if (const std::optional<Fields> light = node.extension("KHR_lights_punctual")) {
        light->index("light", Need::required, c.sizes["lights"], "lights");
    }
    for (const uint32_t child : node.indices("children", c.limits.array_items, parent.size(), "nodes")) {
        if (parent[child] == kNone) {
            parent[child] = self;
            continue;
        }
        c.report.error(
            "S109", node.pointer_to("children"),
            "node " + std::to_string(child) + " is already a child of node " + std::to_string(parent[child]),
            "give every node one parent; to show a mesh twice, use two nodes");
    }
}

void check_scene(Checker& c, const Fields& scene, const std::vector<uint32_t>& parent) {
    scene.text("name", Need::optional);
    std::vector<uint32_t> roots = scene.indices("nodes", c.limits.array_items, parent.size(), "nodes");
    std::sort(roots.begin(), roots.end());
    const bool twice = std::adjacent_find(roots.begin(), roots.end()) != roots.end();
    const bool child =
        std::any_of(roots.begin(), roots.end(), [&](uint32_t n) { return parent[n] != kNone; });
    if (!twice && !child) return;
    c.report.error(
        "S109", scene.pointer_to("nodes"),
        twice ? "the scene lists a node twice" : "the scene lists a node that is the child of another node",
        "list each root node once, and no other nodes");
}

// Weft loads only one scene of a file. The warning lists the other scenes, at most eight of them by name.
void warn_of_other_scenes(Checker& c, uint32_t chosen) {
    constexpr uint32_t kMaxNamed = 8;
    if (c.sizes["scenes"] < 2) return;
    std::string others;
    uint32_t self = 0;
    uint32_t named = 0;
    c.root.each("scenes", c.limits.array_items, [&](const Fields& scene) {
        const uint32_t index = self++;
        if (index == chosen || named++ >= kMaxNamed) return;
        const std::string name = scene.has("name") ? scene.text("name", Need::optional).value_or("") : "";
        others += (others.empty() ? "" : ", ") + std::to_string(index);
        if (!name.empty()) others += " \"" + shortened(name) + "\"";
    });
    if (named > kMaxNamed) others += ", ...";
    c.report.warn("S153", "/scenes", "only scene " + std::to_string(chosen) + " is shown; ignored: " + others,
                  "set \"scene\" to the index of the scene to show");
}

}  // namespace

void check_nodes(Checker& c) {
    if (const std::optional<Fields> punctual = c.root.extension("KHR_lights_punctual")) {
        c.sizes["lights"] = punctual->array_size("lights", c.limits.array_items);
        punctual->each("lights", c.limits.array_items,
                       [&](const Fields& light) { check_light(light, c.report); });
    }
    size_t cameras = 0;
    c.root.each("cameras", c.limits.array_items,
                [&](const Fields& camera) { check_camera(c, camera, cameras++); });
    std::vector<uint32_t> parent(c.sizes["nodes"], kNone);
    uint32_t self = 0;
    c.root.each("nodes", c.limits.array_items,
                [&](const Fields& node) { check_node(c, node, self++, parent); });
    check_forest(c, parent);
    const uint32_t chosen = c.root.index("scene", Need::optional, c.sizes["scenes"], "scenes");
    c.root.each("scenes", c.limits.array_items, [&](const Fields& scene) { check_scene(c, scene, parent); });
    warn_of_other_scenes(c, chosen == kNone ? 0 : chosen);
}

}  // namespace weft::scene::gltf
