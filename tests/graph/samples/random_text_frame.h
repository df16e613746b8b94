// Purpose: holds the state of a random text while it is generated: the random numbers, the values that passes
// can read and write, and the passes.
#pragma once

#include <algorithm>
#include <random>
#include <utility>

#include "tests/graph/samples/random_text.h"
#include "tests/graph/samples/random_text_model.h"

namespace weft::test {

class RandomTextFrame {
 public:
    // Keeps a reference to the profile.
    RandomTextFrame(uint32_t seed, const DeviceProfile& profile) : random_(seed), profile_(profile) {}

 protected:
    // These functions replace the distributions of <random>, whose results differ between standard libraries.
    // So a seed gives the same result everywhere.
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    uint32_t between(uint32_t low, uint32_t high) { return low + below(high - low + 1); }
    bool chance(uint32_t percent) { return below(100) < percent; }

    std::string fresh_name(const char* what) {
        const std::string number = std::to_string(1000 + names_++).substr(1);
        return std::string(1, static_cast<char>('a' + below(26))) + "_" + what + "_" + number;
    }

    void add_parameters() {
        for (const char* name : {"p0", "p1", "p2"}) model_.defaults[name] = below(2);
        model_.defaults["steps"] = below(4);
        for (const auto& [name, value] : model_.defaults)
            if (chance(30)) params_[name] = name == "steps" ? below(4) : below(2);
    }
    double parameter(const std::string& name) const {
        const auto found = params_.find(name);
        return found == params_.end() ? model_.defaults.at(name) : found->second;
    }

    // Adds two conditions and returns their indices. The second condition is the negation of the first.
    std::pair<size_t, size_t> opposite_conditions() {
        const std::string p = "p" + std::to_string(below(3));
        const bool on = parameter(p) != 0;
        model_.conditions.push_back({p, on});
        model_.conditions.push_back({"1 - " + p, !on});
        return {model_.conditions.size() - 2, model_.conditions.size() - 1};
    }
    size_t new_condition() {
        const std::string a = "p" + std::to_string(below(3)), b = "p" + std::to_string(below(3));
        const bool on_a = parameter(a) != 0, on_b = parameter(b) != 0;
        switch (below(5)) {
            case 0:
                return opposite_conditions().first;
            case 1:
                return opposite_conditions().second;
            case 2:
                model_.conditions.push_back({a + " * " + b, on_a && on_b});
                break;
            case 3:
                model_.conditions.push_back({"max(" + a + ", " + b + ")", on_a || on_b});
                break;
            default:
                model_.conditions.push_back({"max(0, steps - 1)", parameter("steps") > 1});
        }
        return model_.conditions.size() - 1;
    }

    size_t add_resource(TextResource r) {
        model_.resources.push_back(std::move(r));
        return model_.resources.size() - 1;
    }
    size_t new_image(const char* what, uint32_t mips = 1, uint32_t layers = 1) {
        constexpr const char* kFormats[] = {"rgba16f", "rgba8", "r32f", "rgba32f|rgba16f"};
        constexpr uint32_t kSides[] = {64, 64, 32, 48};
        TextResource r{fresh_name(what)};
        r.format = kFormats[below(4)];
        r.side_px = kSides[below(4)];
        r.mips = mips;
        r.layers = layers;
        return add_resource(r);
    }
    size_t new_words() {
        TextResource r{fresh_name("words"), ValueKind::words};
        r.words = 256 * between(1, 4);
        return add_resource(r);
    }

    size_t add_value(size_t resource, std::string part = "", uint32_t mip = 0) {
        TextValue v;
        v.resource = resource;
        v.part = std::move(part);
        v.side_px = std::max(1u, model_.resources[resource].side_px >> mip);
        model_.values.push_back(v);
        return model_.values.size() - 1;
    }
    // Adds a value that already has content, although its list of writers is empty. For example, passes wrote
    // the content through ports that said() made. No further pass may write the value.
    size_t add_closed_value(size_t resource, std::string part = "", bool single = true) {
        const size_t id = add_value(resource, std::move(part));
        model_.values[id].closed = true;
        model_.values[id].single = single;
        return id;
    }

    TextResource& resource_of(size_t value) { return model_.resources[model_.values[value].resource]; }
    ValueKind kind_of(size_t value) { return resource_of(value).kind; }
    bool one_format(size_t value) { return resource_of(value).format.find('|') == std::string::npos; }

    template <class Accept>
    std::vector<size_t> values_that(Accept accept) {
        std::vector<size_t> found;
        for (size_t v = 0; v < model_.values.size(); ++v) {
            const bool written = model_.values[v].closed || !model_.values[v].writers.empty();
            if (written && accept(v)) found.push_back(v);
        }
        return found;
    }
    // Returns a random value of the list, or kNone if the list is empty. Usually returns one of the last
    // four values, so that lifetimes are short and memory is reused.
    size_t pick(const std::vector<size_t>& from) {
        if (from.empty()) return kNone;
        const auto n = static_cast<uint32_t>(from.size());
        return from[n > 4 && chance(75) ? n - 1 - below(4) : below(n)];
    }
    template <class Accept>
    size_t pick_value(Accept accept) {
        return pick(values_that(accept));
    }
    size_t plain_color() {
        return pick_value(
            [&](size_t v) { return kind_of(v) == ValueKind::color && model_.values[v].condition == kNone; });
    }

    TextRef last_version(size_t value) {
        model_.values[value].read = true;
        return {value, model_.values[value].writers.size(), chance(50), {}};
    }

    // Returns an input port that reads `value`, for a pass with this `condition`. A value with another
    // condition may be missing when the pass runs. Then the port gets an `else` input or, if `may_be_empty`
    // is true, may be optional instead.
    TextPort input(const char* name, size_t value, size_t condition, bool may_be_empty) {
        TextPort port{name, last_version(value), {}, false, {}};
        bool nearest = resource_of(value).format == "r32f" || chance(20);
        const size_t needs = model_.values[value].condition;
        if (needs != kNone && (needs != condition || chance(10))) {
            if (may_be_empty && chance(50)) {
                port.optional = true;
            } else {
                const size_t other = plain_of(kind_of(value));
                port.otherwise = last_version(other);
                nearest |= resource_of(other).format == "r32f";
            }
            if (model_.holds(condition) && !model_.holds(needs)) omitted_ = true;
        }
        if (nearest && kind_of(value) == ValueKind::color)
            port.more = ", \"sampler\": {\"filter\": \"nearest\", \"mipFilter\": \"nearest\"}";
        return port;
    }
    // Returns the keys of a sampler that filters linearly.
    std::string sampler_keys() {
        constexpr const char* kKeys[] = {"\"lodBias\": 0.5", "\"minLod\": 0.5, \"maxLod\": 2",
                                         "\"wrap\": \"mirror\"", "\"anisotropy\": 4"};
        return kKeys[below(profile_.max_sampler_anisotropy >= 4 ? 4 : 3)];
    }
    // Returns a sampler that gives the least or the greatest of several texels, if the device has it for this
    // format; otherwise one that reads the nearest texel.
    std::string reducing_sampler(Format format) {
        const auto found = profile_.formats.find(format);
        const bool reduces = found != profile_.formats.end() &&
                             (found->second & format_feature::kSampledMinMax) != 0 && chance(60);
        return std::string(", \"sampler\": {") +
               (reduces ? chance(50) ? "\"reduction\": \"max\", " : "\"reduction\": \"min\", "
                        : "\"filter\": \"nearest\", ") +
               "\"mipFilter\": \"nearest\"}";
    }
    bool counts_draws() const {
        return profile_.draw_indirect_count && profile_.max_draw_indirect_count >= 8;
    }
    size_t plain_of(ValueKind kind) {
        return pick_value(
            [&](size_t v) { return kind_of(v) == kind && model_.values[v].condition == kNone; });
    }
    // Returns a port whose reference is the given text, such as "ring[-1]" or the import "noise". The port
    // has no TextValue.
    static TextPort said(const char* name, std::string words, std::string more = "") {
        return {name, {kNone, 0, false, std::move(words)}, {}, false, std::move(more)};
    }

    TextPass& add_pass(const char* what, const char* type, const char* shader) {
        TextPass pass;
        pass.name = fresh_name(what);
        pass.type = type;
        if (shader != nullptr)
            pass.more = std::string(", \"shader\": \"") + shader +
                        "\", \"params\": {\"seed\": " + std::to_string(below(1000)) + "}";
        constexpr const char* kQueues[] = {"async", "transfer", "graphics"};
        if (chance(50)) pass.more += std::string(", \"queue\": \"") + kQueues[below(3)] + "\"";
        model_.passes.push_back(std::move(pass));
        return model_.passes.back();
    }
    // Records that the last added pass writes the value through the output port `port`. The first writer of
    // a value gives the value its condition.
    void write(const char* port, size_t value) {
        TextValue& v = model_.values[value];
        TextPass& pass = model_.passes.back();
        pass.out.push_back({port, {value, 0, false, {}}, {}, false, {}});
        if (v.writers.empty()) v.condition = pass.condition;
        v.writers.push_back(model_.passes.size() - 1);
        v.read = false;
    }
    // Does the same as write(), and makes the last added pass run after all earlier writers of the value.
    void write_after_others(const char* port, size_t value) {
        model_.passes.back().after = model_.values[value].writers;
        write(port, value);
    }
    // Records that the last added pass modifies the value in place. The port `in` refers to the version
    // before the change. If `in` is null, the port `out` refers to this version.
    void change(size_t value, const char* in, const char* out) {
        TextValue& v = model_.values[value];
        TextPass& pass = model_.passes.back();
        const TextRef before{value, v.writers.size(), true, {}};
        if (in != nullptr) pass.in.push_back({in, before, {}, false, {}});
        const TextRef whole{value, 0, false, {}};
        pass.out.push_back({out, in != nullptr ? whole : before, {}, false, {}});
        v.writers.push_back(model_.passes.size() - 1);
        v.read = false;
    }
    void settle_condition() {
        if (!model_.holds(model_.passes.back().condition)) omitted_ = true;
    }

    std::mt19937 random_;
    const DeviceProfile& profile_;
    TextModel model_;
    std::map<std::string, double> params_;
    uint32_t names_ = 0;
    bool omitted_ = false;
};

}  // namespace weft::test
