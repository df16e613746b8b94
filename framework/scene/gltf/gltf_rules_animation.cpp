#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "scene/gltf/gltf_document.h"
#include "scene/gltf/gltf_rules.h"

namespace weft::scene::gltf {
namespace {

// A node and the property that a channel changes: the translation, the rotation or the scale. Two channels
// that are played must not have the same target.
using Target = std::pair<uint32_t, MotionPath>;

constexpr const char* kExportAnimation = "export the animation again";

bool is_float(const AccessorShape& shape) {
    return shape.component_type == static_cast<uint64_t>(ComponentType::f32);
}

std::string text_of(const AccessorShape& shape) {
    return "an accessor with " + std::to_string(shape.components) + " components of type " +
           std::to_string(shape.component_type);
}

void report_data(const Fields& at, const char* key, const std::string& found, const std::string& wanted,
                 Report& report) {
    report.error("S115", at.pointer_to(key),
                 "\"" + std::string(key) + "\" is " + found + "; wanted " + wanted, kExportAnimation);
}

// Checks one animation. Stores the channels of the animation in `out`, except the channels that Weft does not
// play.
class AnimationCheck {
 public:
    AnimationCheck(Checker& c, const Fields& animation, const std::vector<bool>& has_matrix,
                   AnimationSource& out)
        : c_(c), animation_(animation), has_matrix_(has_matrix), out_(out) {}

    void run() {
        animation_.each("samplers", c_.limits.array_items, [&](const Fields& s) { check_sampler(s); });
        out_.samplers.resize(animation_.array_size("samplers", c_.limits.array_items));
        animation_.each("channels", c_.limits.array_items, [&](const Fields& s) { check_channel(s); });
    }
    [[nodiscard]] const std::set<Target>& targets() const { return targets_; }
    [[nodiscard]] size_t ignored() const { return ignored_; }

 private:
    void check_sampler(const Fields& sampler) {
        AnimationSamplerSource source;
        source.input = sampler.index("input", Need::required, c_.accessors.size(), "accessors");
        source.output = sampler.index("output", Need::required, c_.accessors.size(), "accessors");
        const std::string kind = sampler.text("interpolation", Need::optional).value_or("LINEAR");
        if (kind == "STEP") source.interpolation = Interpolation::step;
        if (kind == "CUBICSPLINE") source.interpolation = Interpolation::cubic_spline;
        if (kind != "STEP" && kind != "CUBICSPLINE" && kind != "LINEAR")
            sampler.wrong("interpolation", "LINEAR, STEP or CUBICSPLINE");
        if (source.input != kNone) check_input(sampler, source);
        out_.samplers.push_back(source);
    }

    void check_input(const Fields& sampler, const AnimationSamplerSource& source) {
        const AccessorShape& input = c_.accessors[source.input];
        if (input.components != 1 || !is_float(input))
            report_data(sampler, "input", text_of(input), "a SCALAR accessor of floats", c_.report);
        if (source.interpolation == Interpolation::cubic_spline && input.count < 2)
            report_data(sampler, "input", "an accessor with one key", "two keys or more for CUBICSPLINE",
                        c_.report);
    }

    void check_channel(const Fields& channel) {
        const uint32_t sampler =
            channel.index("sampler", Need::required, out_.samplers.size(), "samplers in this animation");
        const std::optional<Fields> target = channel.object("target", Need::required);
        if (!target) return;
        const uint32_t node = target->index("node", Need::optional, c_.sizes["nodes"], "nodes");
        const std::string path = target->text("path", Need::required).value_or("translation");
        static constexpr std::array<std::string_view, 3> kPaths{"translation", "rotation", "scale"};
        const auto* const known = std::find(kPaths.begin(), kPaths.end(), path);
        if (known == kPaths.end() && path != "weights" && path != "pointer")
            target->wrong("path", "translation, rotation, scale or weights");
        // glTF lets a program ignore a channel without a node.
        if (known == kPaths.end() || node == kNone) {
            ++ignored_;
            return;
        }
        const auto kind = static_cast<MotionPath>(known - kPaths.begin());
        check_target(*target, {node, kind});
        if (sampler == kNone) return;
        check_output(sampler, kind);
        out_.channels.push_back({node, kind, sampler});
    }

    void check_target(const Fields& target, const Target& wanted) {
        if (has_matrix_[wanted.first])
            report_data(target, "node", "node " + std::to_string(wanted.first) + ", which has a \"matrix\"",
                        "a node with \"translation\", \"rotation\" and \"scale\"", c_.report);
        if (!targets_.insert(wanted).second)
            report_data(target, "path", "the target of two channels of this animation", "one channel for it",
                        c_.report);
    }

    // Checks the output values of the sampler with this index: their type and their number. `path` is the
    // property that a channel changes with these values.
    void check_output(uint32_t index, MotionPath path) {
        const AnimationSamplerSource& sampler = out_.samplers[index];
        if (sampler.input == kNone || sampler.output == kNone) return;
        const std::string pointer =
            animation_.pointer_to("samplers") + "/" + std::to_string(index) + "/output";
        const AccessorShape& values = c_.accessors[sampler.output];
        const bool rotates = path == MotionPath::rotation;
        const bool is_u32 = values.component_type == static_cast<uint64_t>(ComponentType::u32);
        if (values.components != (rotates ? 4u : 3u) || is_u32 || (!rotates && !is_float(values)))
            c_.report.error("S115", pointer,
                            "\"output\" is " + text_of(values) + "; wanted " +
                                (rotates ? "a VEC4 accessor of floats or normalised 8- or 16-bit integers"
                                         : "a VEC3 accessor of floats"),
                            kExportAnimation);
        const uint64_t keys = c_.accessors[sampler.input].count;
        const bool is_spline = sampler.interpolation == Interpolation::cubic_spline;
        if (values.count == (is_spline ? 3 * keys : keys)) return;
        c_.report.error("S115", pointer,
                        "\"output\" has " + std::to_string(values.count) + " elements for " +
                            std::to_string(keys) + " keys; wanted " + (is_spline ? "three" : "one") +
                            " for each key",
                        kExportAnimation);
    }

    Checker& c_;
    const Fields& animation_;
    const std::vector<bool>& has_matrix_;
    AnimationSource& out_;
    std::set<Target> targets_;
    size_t ignored_ = 0;
};

void warn_not_played(const Fields& animation, const std::string& name, const std::string& reason,
                     const char* help, Report& report) {
    report.warn("S153", animation.pointer(), name + " is not played" + reason, help);
}

}  // namespace

void check_animations(Checker& c) {
    std::vector<bool> has_matrix;
    c.root.each("nodes", c.limits.array_items,
                [&](const Fields& node) { has_matrix.push_back(node.has("matrix")); });
    std::set<Target> taken;
    size_t self = 0;
    c.root.each("animations", c.limits.array_items, [&](const Fields& animation) {
        AnimationSource source;
        source.name = animation.text("name", Need::optional).value_or("");
        source.index = self;
        const std::string name = label("animation", self++, source.name);
        AnimationCheck check(c, animation, has_matrix, source);
        check.run();
        if (source.channels.empty()) {
            warn_not_played(animation, name, ", because it moves no node", "animate the nodes", c.report);
            return;
        }
        const bool twice =
            std::ranges::any_of(check.targets(), [&](const Target& t) { return taken.contains(t); });
        if (twice) {
            warn_not_played(animation, name, ", because an earlier animation moves the same node",
                            "remove the other animations of this node from the file", c.report);
            return;
        }
        if (check.ignored() > 0)
            c.report.warn("S153", animation.pointer(),
                          name + ": channels (" + std::to_string(check.ignored()) +
                              ") that do not move, rotate or scale a node are ignored",
                          "animate the transforms of nodes");
        taken.insert(check.targets().begin(), check.targets().end());
        c.out.animations.push_back(std::move(source));
    });
}

void check_instancing(Checker& c) {
    static constexpr std::array<std::pair<const char*, uint32_t>, 3> kRead{
        {{"TRANSLATION", 3}, {"ROTATION", 4}, {"SCALE", 3}}};
    uint32_t self = 0;
    c.root.each("nodes", c.limits.array_items, [&](const Fields& node) {
        const uint32_t index = self++;
        const std::optional<Fields> extension = node.extension("EXT_mesh_gpu_instancing");
        if (!extension) return;
        const std::optional<Fields> attributes = extension->object("attributes", Need::required);
        if (!attributes) return;
        std::optional<uint64_t> count;
        InstancingSource source;
        for (const auto& [key, components] : kRead) {
            const uint32_t accessor = attributes->index(key, Need::optional, c.accessors.size(), "accessors");
            if (accessor == kNone) continue;
            const AccessorShape& shape = c.accessors[accessor];
            const bool is_signed = shape.component_type == static_cast<uint64_t>(ComponentType::i8) ||
                                   shape.component_type == static_cast<uint64_t>(ComponentType::i16);
            const auto report = [&](const std::string& found, const std::string& wanted) {
                c.report.error("S116", attributes->pointer_to(key),
                               "\"" + std::string(key) + "\" is " + found + "; wanted " + wanted,
                               "export the instances again");
            };
            if (shape.components != components || !(is_float(shape) || (components == 4 && is_signed)))
                report(text_of(shape), components == 4
                                           ? "a VEC4 accessor of floats or normalised 8- or 16-bit integers"
                                           : "a VEC3 accessor of floats");
            if (count && *count != shape.count)
                report("an accessor with " + std::to_string(shape.count) + " elements",
                       std::to_string(*count) + ", as the other attributes have");
            count = shape.count;
            (components == 4 ? source.rotation
             : key[0] == 'T' ? source.translation
                             : source.scale) = accessor;
        }
        if (count) c.out.instancing[index] = source;
    });
}

}  // namespace weft::scene::gltf
