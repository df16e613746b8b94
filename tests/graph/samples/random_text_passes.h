// Purpose: adds the ordinary passes of random texts. These passes mix, draw, modify, copy and clear images
// and buffers.
#pragma once

#include "tests/graph/samples/random_text_frame.h"

namespace weft::test {

class RandomTextPasses : public RandomTextFrame {
 public:
    using RandomTextFrame::RandomTextFrame;

 protected:
    // Adds a value for the next pass to write, and returns the index of the value. The value is in a new
    // image, or it is an unwritten mip or layer of an image that is partly written.
    size_t target() {
        if (!unwritten_.empty() && chance(60)) {
            const uint32_t i = below(static_cast<uint32_t>(unwritten_.size()));
            const auto [resource, part, mip] = unwritten_[i];
            unwritten_.erase(unwritten_.begin() + i);
            return add_value(resource, part, mip);
        }
        const uint32_t mips = chance(25) ? between(2, 3) : 1, layers = chance(15) ? 2 : 1;
        const size_t image = new_image("image", mips, layers);
        for (uint32_t layer = 0; layer < layers; ++layer)
            for (uint32_t mip = 0; mip < mips; ++mip)
                if (mip + layer > 0) unwritten_.push_back({image, part_of(mips, mip, layers, layer), mip});
        return add_value(image, part_of(mips, 0, layers, 0));
    }
    // Returns a buffer to write, or a range of a buffer whose other ranges further passes may write.
    size_t words_target() {
        constexpr uint32_t kPartWords = 64;  // Ranges of 256 bytes: every device accepts this alignment.
        if (!unwritten_words_.empty() && chance(70)) {
            const uint32_t i = below(static_cast<uint32_t>(unwritten_words_.size()));
            const auto [resource, part, unused] = unwritten_words_[i];
            unwritten_words_.erase(unwritten_words_.begin() + i);
            return add_value(resource, part);
        }
        const size_t words = new_words();
        if (chance(40)) return add_value(words);
        const auto part = [&](uint32_t first, uint32_t last) {
            return ".range(" + std::to_string(first * kPartWords) + ".." +
                   std::to_string(last * kPartWords + kPartWords - 1) + ")";
        };
        const uint32_t parts = model_.resources[words].words / kPartWords;
        for (uint32_t first = 1; first < parts;) {
            const uint32_t last = std::min(parts - 1, first + below(3));
            unwritten_words_.push_back({words, part(first, last), 0});
            first = last + 1;
        }
        return add_value(words, part(0, 0));
    }
    static std::string part_of(uint32_t mips, uint32_t mip, uint32_t layers, uint32_t layer) {
        return (mips > 1 ? ".mip(" + std::to_string(mip) + ")" : "") +
               (layers > 1 ? ".layer(" + std::to_string(layer) + ")" : "");
    }

    // With a probability of `percent`, gives the last added pass a condition. Such a pass either modifies a
    // value in place, or is the first writer of a new resource. In the second case, the value is missing if
    // the condition is false.
    void choose_condition(uint32_t percent) {
        if (chance(percent)) model_.passes.back().condition = new_condition();
        settle_condition();
    }
    size_t output_of_last_pass() {
        return model_.passes.back().condition == kNone ? target() : add_value(new_image("image"));
    }

    size_t any_color() {
        return pick_value([&](size_t v) { return kind_of(v) == ValueKind::color; });
    }
    void read_colors(uint32_t count) {
        constexpr const char* kPorts[] = {"a", "b", "c"};
        const size_t condition = model_.passes.back().condition;
        for (uint32_t i = 0; i < count; ++i) {
            TextPort port = input(kPorts[i], i == 0 ? plain_color() : any_color(), condition, i > 0);
            const bool linear = port.more.empty() && port.otherwise.value == kNone;
            if (linear && chance(25)) port.more = ", \"sampler\": {" + sampler_keys() + "}";
            model_.passes.back().in.push_back(std::move(port));
        }
    }

    void fill() {
        add_pass("fill", "compute", "fill.comp");
        write("dst", target());
    }
    void mix() {
        constexpr const char* kShaders[] = {"mix_1.comp", "mix_2.comp", "mix_3.comp"};
        const uint32_t inputs = between(1, 3);
        // Some passes also sample a table of textures. No random number decides about it, so that all other
        // passes stay the same.
        const bool table = inputs == 1 && model_.passes.size() % 2 == 0;
        add_pass("mix", "compute", table ? "look_up.comp" : kShaders[inputs - 1]);
        choose_condition(20);
        read_colors(inputs);
        if (table) model_.passes.back().in.push_back(said("pictures", "pictures"));
        write("dst", output_of_last_pass());
    }
    void draw() {
        constexpr const char* kShaders[] = {"draw_1.frag", "draw_2.frag"};
        const uint32_t inputs = between(1, 2);
        const bool partial = chance(10);
        add_pass("draw", "fullscreen", kShaders[inputs - 1]).more += partial ? ", \"partial\": true" : "";
        choose_condition(20);
        read_colors(inputs);
        const size_t output = output_of_last_pass();
        write("color", output);
        // A partial draw counts as a write in place. Weft runs writes in place after the other writers of a
        // resource. So no later pass may overwrite the whole image.
        if (partial) model_.values[output].fresh = false;
    }

    // Picks a value that passes may still modify; kNone if there is none. If the writers of the value depend
    // on a condition, the caller gives the modifying pass the same condition.
    template <class Accept>
    size_t changeable(Accept accept) {
        return pick_value([&](size_t v) {
            const TextValue& value = model_.values[v];
            return !value.closed && value.single && !value.writers.empty() && accept(v);
        });
    }
    // Picks a colour value of another resource than the resource of value `than`. The caller modifies `than`,
    // and a pass must not sample the content that it modifies.
    size_t other_color(size_t than) {
        return pick_value([&](size_t v) {
            return kind_of(v) == ValueKind::color && model_.values[v].condition == kNone &&
                   model_.values[v].resource != model_.values[than].resource;
        });
    }
    void under_condition_of(size_t value, uint32_t percent) {
        model_.passes.back().condition = model_.values[value].condition;
        if (model_.passes.back().condition == kNone) return choose_condition(percent);
        settle_condition();
    }

    void update() {
        const size_t v =
            changeable([&](size_t c) { return kind_of(c) == ValueKind::color && one_format(c); });
        if (v == kNone) return;
        const size_t other = other_color(v);
        if (other == kNone) return;
        const std::string shader = "update_" + resource_of(v).format + ".comp";
        add_pass("update", "compute", shader.c_str());
        under_condition_of(v, 50);
        model_.passes.back().in = {input("a", other, model_.passes.back().condition, false)};
        change(v, "x", "x");
    }
    void blend() {
        const size_t v = changeable(
            [&](size_t c) { return kind_of(c) == ValueKind::color && resource_of(c).format != "r32f"; });
        if (v == kNone) return;
        const size_t other = other_color(v);
        if (other == kNone) return;
        add_pass("blend", "fullscreen", "draw_1.frag").more += ", \"state\": {\"blend\": \"add\"}";
        under_condition_of(v, 50);
        model_.passes.back().in = {input("a", other, model_.passes.back().condition, false)};
        change(v, nullptr, "color");
    }
    // Picks a colour value that later passes may overwrite. The value has no condition, and its first writer
    // ignores the older content.
    size_t overwritable_color() {
        return changeable([&](size_t c) {
            return kind_of(c) == ValueKind::color && model_.values[c].fresh &&
                   model_.values[c].condition == kNone;
        });
    }
    void overwrite() {
        const size_t v = overwritable_color();
        if (v == kNone) return;
        const size_t other = other_color(v);
        if (other == kNone) return;
        add_pass("over", "compute", "mix_1.comp");
        model_.passes.back().in = {input("a", other, kNone, false)};
        write_after_others("dst", v);
    }

    // Adds a pass that overwrites only a part of a value. The other part keeps its content.
    void overwrite_part() {
        const size_t v = overwritable_color();
        if (v == kNone) return;
        const size_t other = other_color(v);
        if (other == kNone) return;
        const bool draws = chance(40);
        add_pass("part", draws ? "fullscreen" : "compute", draws ? "draw_1.frag" : "mix_1.comp").more +=
            ", \"partial\": true";
        model_.passes.back().in = {input("a", other, kNone, false)};
        write_after_others(draws ? "color" : "dst", v);
    }

    // Adds two passes with opposite conditions that write the same value, so that exactly one of them runs.
    void alternatives() {
        const auto [one, two] = opposite_conditions();
        const size_t v = add_value(new_image("either"));
        for (const size_t condition : {one, two}) {
            add_pass("either", "compute", condition == one ? "mix_1.comp" : "fill.comp").condition =
                condition;
            settle_condition();
            if (condition == one) model_.passes.back().in = {input("a", plain_color(), condition, false)};
            write("dst", v);
        }
        model_.values[v].condition = kNone;
        model_.values[v].closed = true;
        model_.values[v].fresh = false;
    }

    void scene() {
        TextResource color{fresh_name("color")}, depth{fresh_name("depth"), ValueKind::depth};
        color.format = "rgba16f";
        depth.format = chance(50) ? "d32f" : "d16";
        const size_t c = add_value(add_resource(color)), d = add_value(add_resource(depth));
        model_.values[c].fresh = model_.values[d].fresh = false;
        add_pass("scene", "raster", nullptr).more +=
            chance(25) ? R"j(, "draws": ["opaque"], "shader": "points", "state": {"topology": "points"})j"
                       : R"j(, "draws": ["opaque"], "shader": "scene")j";
        write("color", c);
        model_.passes.back().depth = {{"depth", {d, 0, false, {}}, {}, false, {}}};
        model_.values[d].writers.push_back(model_.passes.size() - 1);
        if (chance(70)) sky(c, d);
        if (chance(70)) show_depth(d);
        model_.values[d].closed = true;
    }
    void views() { draw_views("sun", 4); }
    // Adds a pass that draws all views of a list, each to its own layer or rectangle of two images.
    void draw_views(const std::string& list, uint32_t count) {
        const bool rects = chance(50);
        TextResource color{fresh_name("seen")}, depth{fresh_name("maps"), ValueKind::depth};
        color.format = "rgba16f";
        depth.format = "d32f";
        color.layers = depth.layers = rects ? 1 : count;
        const std::string name = color.name, maps = depth.name, last = std::to_string(count - 1);
        const uint32_t side_px = color.side_px;
        const size_t seen = add_resource(color);
        add_resource(depth);
        TextPass& pass = add_pass("views", "raster", nullptr);
        pass.more += std::string(R"j(, "draws": ["opaque"], "shader": )j") +
                     (chance(50) ? R"j("scene")j" : R"j("seen")j");
        const auto attachments = [&](const std::string& part) {
            return R"j(, "out": {"color": ")j" + name + part + R"j("}, "depth": ")j" + maps + part + "\"";
        };
        const std::string plain =
            R"j(, "repeat": {"view": "0..)j" + last + R"j("}, "view": ")j" + list + "(view)\"";
        pass.more_text =
            ", \"views\": \"" + list + "\"" + (rects ? ", \"into\": \"rects\"" : "") + attachments("");
        if (rects) {
            const std::string rect = grid_cell(count, side_px);
            pass.more_plain = plain + R"j(, "partial": true, "state": {"viewport": )j" + rect +
                              ", \"scissor\": " + rect + "}" + attachments("");
        } else {
            pass.more_plain = plain + attachments(count > 1 ? ".layer(view)" : "");
        }
        const size_t value = add_value(seen, rects || count == 1 ? "" : ".layer(" + last + ")");
        model_.values[value].fresh = false;
        model_.values[value].closed = true;
    }
    // Returns the cell of the view in a grid, as an expression.
    static std::string grid_cell(uint32_t count, uint32_t side_px) {
        uint32_t columns = 1;
        while (columns * columns < count) ++columns;
        const std::string width = std::to_string(side_px / columns),
                          height = std::to_string(side_px / ((count + columns - 1) / columns)),
                          number = std::to_string(columns);
        return "[\"view % " + number + " * " + width + "\", \"floor(view / " + number + ") * " + height +
               "\", " + width + ", " + height + "]";
    }
    // Adds a pass that draws with a depth test, and that sometimes samples the same depth image.
    void sky(size_t color, size_t depth) {
        const bool samples = chance(50);
        add_pass("sky", "fullscreen", samples ? "sky_2.frag" : "sky_1.frag").more +=
            R"j(, "state": {"blend": "add", "depth": "equal"})j";
        choose_condition(40);
        if (samples) model_.passes.back().in = {{"depth", last_version(depth), {}, false, {}}};
        model_.passes.back().depth = {{"depth", last_version(depth), {}, false, {}}};
        change(color, nullptr, "color");
    }
    void show_depth(size_t depth) {
        add_pass("fog", "compute", "mix_1.comp");
        const Format format = *format_from_name(resource_of(depth).format);
        model_.passes.back().in = {{"a", last_version(depth), {}, false, reducing_sampler(format)}};
        write("dst", target());
    }

    void wipe() {
        if (chance(40)) {
            add_pass("wipe", "clear", nullptr).more += ", \"clear\": " + std::to_string(below(9));
            return write("dst", add_value(new_words()));
        }
        const uint32_t mips = between(1, 3);
        const size_t image = new_image("image", mips);
        add_pass("wipe", "clear", nullptr);
        choose_condition(20);
        write("dst", add_value(image));
        model_.values.back().single = mips == 1;
    }
    void copy() {
        const size_t from = pick_value([&](size_t v) {
            return kind_of(v) == ValueKind::color && model_.values[v].condition == kNone && one_format(v);
        });
        if (from == kNone) return;
        TextResource twin = resource_of(from);
        twin.name = fresh_name("copy");
        twin.more.clear();
        const TextValue like = model_.values[from];
        const size_t v = add_value(add_resource(twin), like.part);
        model_.values[v].side_px = like.side_px;
        model_.values[v].single = like.single;
        add_pass("copy", "copy", nullptr);
        choose_condition(20);
        model_.passes.back().in = {{"src", last_version(from), {}, false, {}}};
        write("dst", v);
    }
    void stretch() {
        const size_t from = pick_value([&](size_t v) {
            return kind_of(v) == ValueKind::color && model_.values[v].condition == kNone &&
                   model_.values[v].single;
        });
        if (from == kNone) return;
        add_pass("blit", "blit", nullptr);
        TextPort src = input("src", from, kNone, false);
        model_.passes.back().in = {std::move(src)};
        write("dst", target());
    }

    void buffers() {
        const size_t words = pick_value([&](size_t v) { return kind_of(v) == ValueKind::words; });
        const uint32_t roll = below(4);
        if (words == kNone || roll == 0) {
            add_pass("pack", "compute", "pack.comp").more += ", \"groups\": 4";
            read_colors(1);
            return write("dst", words_target());
        }
        if (roll == 1 && !model_.values[words].closed && model_.values[words].fresh) {
            add_pass("slice", "compute", "slice_words.comp").more += ", \"groups\": 4";
            under_condition_of(words, 50);
            return change(words, "x", "x");
        }
        const size_t from = plain_of(ValueKind::words);
        if (from == kNone) return;
        add_pass("words", "compute", roll == 2 ? "words.comp" : "unpack.comp");
        if (roll == 2) model_.passes.back().more += ", \"groups\": 4";
        model_.passes.back().in = {{"a", last_version(from), {}, false, {}}};
        write("dst", roll == 2 ? words_target() : target());
    }

    void read_back() {
        const size_t v = plain_color();
        add_pass("show", "readback", nullptr).in = {{"src", last_version(v), {}, false, {}}};
    }

 private:
    struct Part {
        size_t resource;
        std::string part;
        uint32_t mip;
    };
    std::vector<Part> unwritten_;
    std::vector<Part> unwritten_words_;
};

}  // namespace weft::test
