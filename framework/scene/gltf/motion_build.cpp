#include "scene/gltf/motion_build.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf/accessor_reader.h"
#include "scene/model/node_placement.h"

namespace weft::scene::gltf {
namespace {

// Largest number that a key (a keyframe) of an animation may have. A node with a larger number in its
// transform is invisible; see transforms_at().
constexpr float kMaxKeyValue = 1e15f;
// Number of copies of the keys in memory: one in the loaded scene, and one that is used for drawing.
constexpr uint64_t kCopies = 2;

struct SamplerPlace {
    const Document& document;
    const AnimationSamplerSource& source;
    std::string pointer;
};

void report_keys(const SamplerPlace& at, const char* key, const std::string& message, Report& report) {
    report.error("S115", at.pointer + "/" + key, message, "export the animation again");
}

void read_times(const SamplerPlace& at, const AccessorReader& input, MotionSampler& out, Report& report) {
    float least = 0;
    for (uint64_t i = 0; i < input.count(); ++i) {
        const float time = input.component(i, 0);
        const bool ascends = i == 0 ? time >= 0 : time > least;
        if (!ascends || !std::isfinite(time)) {
            report_keys(at, "input",
                        "the time of key " + std::to_string(i) + " is " + describe(double{time}) +
                            (i == 0 ? "; wanted a finite time of 0 or more"
                                    : "; wanted a finite time after that of the key before, " +
                                          describe(double{least})),
                        report);
            return;
        }
        out.times_s.push_back(time);
        least = time;
    }
}

void read_values(const SamplerPlace& at, const AccessorReader& output, MotionSampler& out, Report& report) {
    const int components = out.rotates ? 4 : 3;
    const bool is_spline = out.interpolation == Interpolation::cubic_spline;
    uint64_t without_direction = 0;
    for (uint64_t i = 0; i < output.count(); ++i) {
        glm::vec4 value(0);
        for (int k = 0; k < components; ++k) value[k] = output.component(i, static_cast<uint32_t>(k));
        for (int k = 0; k < components; ++k) {
            if (std::abs(value[k]) <= kMaxKeyValue) continue;
            report_keys(at, "output",
                        "component " + std::to_string(k) + " of element " + std::to_string(i) + " is " +
                            describe(double{value[k]}) + "; wanted a number between -1e15 and 1e15",
                        report);
            return;
        }
        const bool is_value = !is_spline || i % 3 == 1;
        if (out.rotates && is_value && glm::length(value) <= 1e-6f) ++without_direction;
        out.values.push_back(out.rotates && !is_spline ? unit_quaternion(value) : value);
    }
    if (without_direction == 0) return;
    report.warn("S152", at.pointer + "/output",
                "rotations of length 0 (" + std::to_string(without_direction) +
                    ") were replaced by [0, 0, 0, 1], which means no rotation",
                "write rotations as unit quaternions [x, y, z, w]");
}

// Reads the keys of one sampler. Returns false after an error.
bool read_sampler(const SamplerPlace& at, bool rotates, MemoryBudget& memory, Report& report,
                  MotionSampler& out) {
    out.interpolation = at.source.interpolation;
    out.rotates = rotates;
    const auto input = AccessorReader::open(at.document, at.source.input);
    const auto output = AccessorReader::open(at.document, at.source.output);
    if (!input || !output) {
        report.error("S104", at.pointer + (input ? "/output" : "/input"),
                     "the accessor reaches past the end of its data, or its sparse indices do not ascend",
                     "export the animation again");
        return false;
    }
    const bool is_integer = at.document.accessors[at.source.output].type != ComponentType::f32;
    if (is_integer && !at.document.accessors[at.source.output].normalized) {
        report_keys(at, "output",
                    "\"output\" is an accessor of integers that are not normalised; wanted "
                    "floats, or integers with \"normalized\": true",
                    report);
        return false;
    }
    const uint64_t bytes = saturating_add(saturating_mul(input->count(), sizeof(float)),
                                          saturating_mul(output->count(), sizeof(glm::vec4)));
    if (!take_memory(memory, {saturating_mul(bytes, kCopies), "S107", at.pointer, "the animation"}, report))
        return false;
    out.times_s.reserve(input->count());
    out.values.reserve(output->count());
    read_times(at, *input, out, report);
    read_values(at, *output, out, report);
    return !report.failed();
}

// Reads the animation. Leaves out channels of nodes that are not shown, and unused samplers.
Animation read_animation(const Document& document, const AnimationSource& source,
                         std::span<const uint32_t> moving, MemoryBudget& memory, Report& report) {
    Animation out;
    out.name = source.name;
    std::vector<uint32_t> place(source.samplers.size(), kNone);
    for (const AnimationChannelSource& channel : source.channels) {
        if (moving[channel.node] == kNone) continue;
        uint32_t& sampler = place[channel.sampler];
        if (sampler == kNone) {
            sampler = static_cast<uint32_t>(out.samplers.size());
            const SamplerPlace at{document, source.samplers[channel.sampler],
                                  "/animations/" + std::to_string(source.index) + "/samplers/" +
                                      std::to_string(channel.sampler)};
            const bool rotates = channel.path == MotionPath::rotation;
            if (!read_sampler(at, rotates, memory, report, out.samplers.emplace_back())) return out;
        }
        out.length_s = std::max(out.length_s, double{out.samplers[sampler].times_s.back()});
        out.channels.push_back({moving[channel.node], channel.path, sampler});
    }
    return out;
}

}  // namespace

std::vector<bool> animated_nodes(const Document& document) {
    std::vector<bool> animated(document.nodes.size(), false);
    for (const AnimationSource& animation : document.animations)
        for (const AnimationChannelSource& channel : animation.channels) animated[channel.node] = true;
    return animated;
}

void build_animations(const Document& document, std::span<const uint32_t> moving, MemoryBudget& memory,
                      Report& report, Motion& motion) {
    for (const AnimationSource& source : document.animations) {
        const uint64_t bytes =
            source.channels.size() * 2 * kCopies * sizeof(MotionChannel) + source.name.size();
        if (!take_memory(memory,
                         {bytes, "S107", "/animations/" + std::to_string(source.index), "the animation"},
                         report))
            return;
        Animation animation = read_animation(document, source, moving, memory, report);
        if (report.failed()) return;
        if (!animation.channels.empty()) motion.animations.push_back(std::move(animation));
    }
}

}  // namespace weft::scene::gltf
