// Purpose: adds to random texts: passes that draw lists of views of every kind, arrays of mips or layers,
// indirect dispatches and draws, buffers of the scene, and resources with files.
#pragma once

#include "tests/graph/samples/random_text_repeats.h"

namespace weft::test {

class RandomTextFeatures : public RandomTextRepeats {
 public:
    using RandomTextRepeats::RandomTextRepeats;

 protected:
    // Adds a pass that draws the views of a list of the program, of a part of it, of a mirror or of a cube.
    void view_list() {
        const std::string list = fresh_name("list");
        const auto add = [&](const std::string& keys, uint32_t count) {
            model_.view_lists.push_back("\"" + list + "\": {" + keys + "}");
            draw_views(list, count);
        };
        switch (below(6)) {
            case 0:
                return draw_views("lamps", kLamps);
            case 1:
                return add(R"j("of": "lamps", "first": 1, "count": 2)j", 2);
            case 2:
                return add(R"j("of": "camera", "plane": [0, 1, 0, "0.5 * steps"])j", 1);
            case 3:
                return add(R"j("of": "sun", "plane": [1, 0, 0, -1])j", 4);
            default:
                return add(R"j("cube": {"at": ["steps", 1, 0]})j", 6);
        }
    }

    // Adds a pass that writes views to a buffer, and a pass that draws them. Sometimes another pass then
    // changes one of the views, and sometimes the views are those of the last frame.
    void buffer_views() {
        const uint32_t count = between(1, 4);
        const bool past = chance(25);
        TextResource buffer{fresh_name("matrices")};
        const std::string name = buffer.name, list = fresh_name("list");
        buffer.verbatim = "\"buffer\": \"ViewConstants\", \"count\": " + std::to_string(count) +
                          (past ? ", \"history\": 1" : "");
        add_resource(std::move(buffer));
        const bool one_by_one = chance(40);
        TextPass& fit = add_pass("fit", "compute", "pack.comp");
        const std::string writer = fit.name;
        fit.more += ", \"groups\": 1";
        if (one_by_one) fit.more += ", \"repeat\": {\"i\": \"0.." + std::to_string(count - 1) + "\"}";
        read_colors(1);
        model_.passes.back().out = {said("dst", name + (one_by_one ? ".range(i)" : ""))};
        const bool changes = !past && chance(40), pinned = changes && chance(50);
        model_.view_lists.push_back("\"" + list + "\": {\"buffer\": \"" + name +
                                    (past     ? "[-1]"
                                     : pinned ? "@" + writer
                                              : "") +
                                    "\", \"count\": " + std::to_string(count) + "}");
        if (changes && !pinned) change_view(name, below(count));
        if (chance(50))
            draw_views(list, count);
        else
            draw_view(list + "(" + std::to_string(below(count)) + ")");
        // The pass that draws sees the version before this change.
        if (pinned) change_view(name, below(count));
    }

    // Adds a pass that reads an array of mips or layers, or one that writes such an array. The arrays of the
    // shaders have four elements, which is often more than the image has.
    void arrays() {
        const uint32_t parts = between(1, 4);
        const bool mips = chance(50);
        const size_t image = new_image("stack", mips ? parts : 1, mips ? 1 : parts);
        model_.resources[image].format = "rgba16f";
        const std::string name = model_.resources[image].name;
        const std::string range = mips ? ".mip(0.." : ".layer(0..", last = std::to_string(parts - 1) + ")";
        const std::string each = std::string(", \"each\": ") + (mips ? "\"mip\"" : "\"layer\"");
        if (chance(50)) {
            add_pass("wipe", "clear", nullptr).out = {said("dst", name)};
        } else {
            add_pass("spread", "compute", "spread.comp");
            choose_sampled(plain_color());
            model_.passes.back().out = {said("dst", name + range + last, each)};
        }
        add_pass("gather", "compute", "gather.comp").in = {said("a", name + range + last, each)};
        write("dst", target());
        for (uint32_t part = 0; part < parts; ++part)
            add_closed_value(image, mips ? part_of(parts, part, 1, 0) : part_of(1, 0, parts, part));
    }

    // Adds a pass whose number of workgroups or draw commands is in a range of a buffer.
    void indirect() {
        if (chance(40)) return indirect_groups();
        const bool list = chance(50), counted = counts_draws() && chance(60);
        TextResource commands{fresh_name("commands")};
        const std::string name = commands.name, number = counted ? count_buffer() : "";
        const uint32_t extra = below(3);
        commands.verbatim = std::string("\"buffer\": \"") + (list ? "DrawCommand" : "DrawVerticesCommand") +
                            "\", \"count\": " + std::to_string(kOpaqueDraws + extra);
        add_resource(std::move(commands));
        add_pass("list", "compute", "pack.comp").more += ", \"groups\": 1";
        read_colors(1);
        model_.passes.back().out = {said("dst", name)};
        const size_t image = new_image("listed");
        model_.resources[image].format = "rgba16f";
        TextPass& pass = add_pass("listed", "raster", nullptr);
        const std::string range =
            ".range(" + std::to_string(extra) + ".." + std::to_string(kOpaqueDraws + extra - 1) + ")";
        pass.more += std::string(", \"draws\": {") + (list ? R"j("list": "opaque", )j" : "") +
                     "\"indirect\": \"" + name + range + "\"" +
                     (counted ? ", \"count\": \"" + number + "\"" : "") +
                     R"j(}, "shader": "scene", "state": {"cull": "none"})j";
        write("color", add_value(image));
        model_.values.back().fresh = false;
    }

    // Adds a pass that reads a buffer with the objects of the scene, which the program provides.
    void scene_buffer() {
        add_pass("placed", "compute", "unpack.comp").in = {said("a", "instances")};
        write("dst", target());
    }

    // Adds a pass that reads a resource whose content comes from a file.
    void file() {
        const bool picture = chance(50);
        TextResource r{fresh_name("file")};
        const std::string name = r.name;
        r.verbatim = picture ? R"j("file": "picture.png", "format": "rgba8", "mips": ")j" +
                                   std::string(chance(50) ? "full\"" : "2\"")
                             : R"j("file": "words.bin", "buffer": "u32")j";
        add_resource(std::move(r));
        add_pass("load", "compute", picture ? "mix_1.comp" : "unpack.comp").in = {said("a", name)};
        write("dst", target());
    }

 private:
    static constexpr uint32_t kLamps = 3;        // Number of views in the list "lamps".
    static constexpr uint32_t kOpaqueDraws = 5;  // Number of draws in the list "opaque".

    void choose_sampled(size_t value) {
        TextPort a = input("a", value, kNone, false);
        model_.passes.back().in = {std::move(a)};
    }

    void change_view(const std::string& buffer, uint32_t number) {
        const std::string part = buffer + ".range(" + std::to_string(number) + ")";
        add_pass("refit", "compute", "slice_words.comp").more += ", \"groups\": 1";
        model_.passes.back().in = {said("x", part)};
        model_.passes.back().out = {said("x", part)};
    }

    void draw_view(const std::string& view) {
        TextResource color{fresh_name("seen")};
        color.format = "rgba16f";
        const size_t v = add_value(add_resource(color));
        model_.values[v].fresh = false;
        add_pass("view", "raster", nullptr).more +=
            R"j(, "draws": ["opaque"], "shader": "seen", "view": ")j" + view + "\"";
        choose_condition(25);
        write("color", v);
    }

    // Adds a buffer with numbers of draws, and a pass that writes it. Returns a reference to one number.
    std::string count_buffer() {
        const std::string name = model_.resources[new_words()].name;
        add_pass("count", "clear", nullptr).out = {said("dst", name)};
        const std::string word = std::to_string(below(256));
        return name + ".range(" + word + ".." + word + ")";
    }

    void indirect_groups() {
        const std::string name = model_.resources[new_words()].name;
        add_pass("args", "compute", "pack.comp").more += ", \"groups\": 4";
        read_colors(1);
        model_.passes.back().out = {said("dst", name)};
        const uint32_t first = 3 * below(64);
        TextPass& pass = add_pass("many", "compute", "fill.comp");
        pass.more += R"j(, "groups": {"indirect": ")j" + name + ".range(" + std::to_string(first) + ".." +
                     std::to_string(first + 2) + ")\"}";
        write("dst", target());
    }
};

}  // namespace weft::test
