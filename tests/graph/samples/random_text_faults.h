// Purpose: adds one fault to a random text, such as a read of unwritten memory. resolve() must find every
// fault.
#pragma once

#include "tests/graph/samples/random_text_features.h"

namespace weft::test {

struct RandomFault {
    const char* code;
    std::string how;
};

class RandomTextFaults : public RandomTextFeatures {
 public:
    using RandomTextFeatures::RandomTextFeatures;

 protected:
    RandomFault plant() {
        switch (below(12)) {
            case 0:
            case 1:
                return part_of_nothing();
            case 2:
            case 3:
                chain_slices_wrongly();
                return {"W124", "chained slices"};
            case 4:
                return stencil_without_attachment();
            case 5:
                return points_without_size();
            case 6:
                return clear_out_of_range();
            case 7:
                return empty_resource();
            case 8:
                return bad_index();
            case 9:
                return float_groups();
            case 10:
                return foreign_set();
            default:
                return unwritten_output();
        }
    }

 private:
    // Adds a pass that writes only a part of a new resource (`partial`). No pass has written the other part,
    // so it would contain old data of another resource in the same memory. The pass has no attachments.
    // With an attachment there would be no fault, because Weft clears an attachment without earlier content.
    RandomFault part_of_nothing() {
        const uint32_t roll = below(5);
        const size_t target = roll == 3 ? new_words() : new_image("lone");
        const std::string name = model_.resources[target].name;
        if (roll < 3) {
            add_pass("lone", "compute", "fill.comp").out = {said("dst", name)};
        } else if (roll == 3) {
            add_pass("lone", "compute", "pack.comp").more += ", \"groups\": 1";
            model_.passes.back().in = {input("a", plain_color(), kNone, false)};
            model_.passes.back().out = {said("dst", name)};
        } else {
            add_pass("lone", "blit", nullptr).in = {said("src", "noise")};
            model_.passes.back().out = {said("dst", name)};
        }
        const std::string type = model_.passes.back().type;
        model_.passes.back().more += ", \"partial\": true";
        add_pass("see", "readback", nullptr).in = {said("src", name)};
        return {"W110", "partial " + type + " pass with nothing before it"};
    }

    RandomFault stencil_without_attachment() {
        add_pass("cut", "fullscreen", "draw_1.frag").more +=
            R"j(, "state": {"stencil": {"compare": "equal"}})j";
        model_.passes.back().in = {input("a", plain_color(), kNone, false)};
        model_.passes.back().out = {said("color", model_.resources[new_image("cut")].name)};
        return {"W182", "stencil without an attachment"};
    }

    RandomFault points_without_size() {
        const char* state = chance(50) ? R"j("topology": "points")j" : R"j("fill": "point")j";
        add_pass("dots", "raster", nullptr).more +=
            std::string(R"j(, "draws": ["opaque"], "shader": "scene", "state": {)j") + state + "}";
        model_.passes.back().out = {said("color", model_.resources[new_image("dots")].name)};
        return {"W186", "points without a size"};
    }

    RandomFault clear_out_of_range() {
        constexpr struct {
            const char* format;
            const char* value;
        } kValues[] = {{"rgba8", "2"},     {"rgba8", "[0, -0.5, 0, 1]"},
                       {"r8u", "300"},     {"r8u", "-1"},
                       {"r16f", "1e6"},    {"r32u", "0.5"},
                       {"r8_snorm", "-2"}, {"rgba8", "\"steps + 2\""},
                       {"r32i", "5e9"},    {"b10g11r11f", "-1"},
                       {"r32u", "1e20"}};
        const auto& bad = kValues[below(std::size(kValues))];
        const size_t image = new_image("wiped");
        model_.resources[image].format = bad.format;
        add_pass("wipe", "clear", nullptr).more += std::string(", \"clear\": ") + bad.value;
        model_.passes.back().out = {said("dst", model_.resources[image].name)};
        return {"W109", std::string("clear ") + bad.format + " to " + bad.value};
    }

    RandomFault empty_resource() {
        constexpr const char* kResources[] = {
            R"j("format": "rgba8", "size": 0)j",
            R"j("format": "rgba8", "size": ["output.x", -3])j",
            R"j("format": "rgba8", "size": "output - 64")j",
            R"j("format": "rgba8", "mips": 0)j",
            R"j("format": "rgba8", "mips": "1 - steps - 1")j",
            R"j("format": "rgba8", "layers": -2)j",
            R"j("format": "rgba8", "kind": "3d", "depth": 0)j",
            R"j("buffer": "u32", "count": 0)j",
            R"j("buffer": "u32", "count": "0 - steps")j",
        };
        TextResource r{fresh_name("empty")};
        r.verbatim = kResources[below(std::size(kResources))];
        const std::string name = r.name;
        add_resource(std::move(r));
        add_pass("see", "readback", nullptr).in = {said("src", name)};
        return {"W109", model_.resources.back().verbatim};
    }

    RandomFault bad_index() {
        constexpr const char* kParts[] = {".mip(0.5)",
                                          ".mip(1 / 2)",
                                          ".layer(1.5)",
                                          ".mip(99999999999999999999999)",
                                          ".layer(0 - 99999999999999999999999)",
                                          ".mip(-1)",
                                          ".mip(0..1.5)"};
        const char* part = kParts[below(std::size(kParts))];
        const size_t image = new_image("split", 3, 3);
        add_pass("wipe", "clear", nullptr).out = {said("dst", model_.resources[image].name)};
        add_pass("see", "readback", nullptr).in = {said("src", model_.resources[image].name + part)};
        return {"W105", part};
    }

    RandomFault float_groups() {
        constexpr const char* kElements[] = {"vec4", "f32", "vec2", "mat4"};
        TextResource r{fresh_name("groups")};
        r.verbatim = std::string("\"buffer\": \"") + kElements[below(4)] + "\", \"count\": 3";
        const std::string name = r.name;
        add_resource(std::move(r));
        add_pass("count", "clear", nullptr).out = {said("dst", name)};
        add_pass("run", "compute", "fill.comp").more += R"j(, "groups": {"indirect": ")j" + name + "\"}";
        model_.passes.back().out = {said("dst", model_.resources[new_image("run")].name)};
        return {"W114", "groups from " + model_.resources.back().name};
    }

    RandomFault foreign_set() {
        add_pass("foreign", "compute", "foreign.comp").out = {
            said("dst", model_.resources[new_image("foreign")].name)};
        return {"W185", "a descriptor set that nothing binds"};
    }

    RandomFault unwritten_output() {
        std::erase_if(model_.passes,
                      [](const TextPass& p) { return p.name.find("_present_") != std::string::npos; });
        model_.idle_output = true;
        return {"W184", "an output that nobody writes"};
    }
};

}  // namespace weft::test
