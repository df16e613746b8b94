// Purpose: adds repeats and persistent resources to random texts.
#pragma once

#include "tests/graph/samples/random_text_passes.h"

namespace weft::test {

class RandomTextRepeats : public RandomTextPasses {
 public:
    using RandomTextPasses::RandomTextPasses;

 protected:
    // Adds passes that write the mips of an image with one or two layers, from the largest mip to the
    // smallest, and often back again. An `if` may remove the passes on the way back.
    void pyramid() {
        const uint32_t mips = between(3, 5), layers = chance(30) ? 2 : 1;
        const size_t image = new_image("pyramid", mips, layers);
        const std::string name = model_.resources[image].name;
        const std::string layer = layers > 1 ? ".layer(l)" : "";
        const std::string outer = layers > 1 ? R"j("l": "0..1", )j" : "";
        add_pass("base", "compute", "mix_1.comp");
        if (layers > 1) model_.passes.back().more += R"j(, "repeat": {"l": "0..1"})j";
        model_.passes.back().in = {input("a", plain_color(), kNone, false)};
        model_.passes.back().out = {said("dst", name + ".mip(0)" + layer)};
        const bool up = chance(60) && one_format_of(image);
        TextPass& down = add_pass("down", "compute", "mix_1.comp");
        down.more += ", \"repeat\": {" + outer + "\"i\": \"1..mips(" + name + ")-1\"}";
        const std::string pin = up || chance(50) ? "@" + down.name : "";
        down.in = {said("a", name + pin + ".mip(i-1)" + layer, nearest(image))};
        down.out = {said("dst", name + ".mip(i)" + layer)};
        const std::string down_name = down.name;
        if (up && chance(50)) read_on_the_way(name + "@" + down_name, mips, layers, image);
        if (up) climb(image, outer, layer);
        for (uint32_t l = 0; l < layers; ++l)
            for (uint32_t mip = 0; mip < mips; ++mip) {
                const size_t v = add_closed_value(image, part_of(mips, mip, layers, l));
                model_.values[v].side_px = std::max(1u, model_.resources[image].side_px >> mip);
            }
        if (layers == 1) add_closed_value(image, "", false);
    }

    // Adds a repeat that modifies a value in place. The repeat has zero to four iterations. Sometimes an `if`
    // removes every second iteration.
    void rounds() {
        const size_t v = changeable([&](size_t c) {
            return kind_of(c) == ValueKind::color && one_format(c) && model_.values[c].condition == kNone;
        });
        if (v == kNone) return;
        const size_t other = other_color(v);
        if (other == kNone) return;
        const std::string shader = "update_" + resource_of(v).format + ".comp";
        TextPass& pass = add_pass("round", "compute", shader.c_str());
        count_rounds(pass);
        pass.after = model_.values[v].writers;
        const std::string name = resource_of(v).name + model_.values[v].part;
        TextPort a = input("a", other, kNone, false);
        model_.passes.back().in = {std::move(a), said("x", name)};
        model_.passes.back().out = {said("x", name)};
        model_.values[v].writers.push_back(model_.passes.size() - 1);
        model_.values[v].closed = true;
        model_.values[v].read = false;
    }

    // Adds a repeat that copies from one layer of an image to the other, and back in the next iteration.
    void bounce() {
        const size_t image = new_image("bounce", 1, 2);
        const std::string name = model_.resources[image].name;
        add_pass("base", "compute", "fill.comp").out = {said("dst", name + ".layer(0)")};
        TextPass& pass = add_pass("round", "compute", "mix_1.comp");
        pass.more += ", \"repeat\": {\"i\": \"0.." + std::to_string(between(1, 4)) + "\"}";
        pass.in = {said("a", name + "@" + pass.name + ".layer(i % 2)", nearest(image))};
        pass.out = {said("dst", name + ".layer((i + 1) % 2)")};
        add_closed_value(image, ".layer(0)");
        add_closed_value(image, ".layer(1)");
    }

    // Adds a nested repeat whose inner range depends on the outer index. An `if` may remove every second
    // inner iteration.
    void staircase() {
        const size_t image = new_image("stairs", 1, 6);
        const bool odd = chance(50);
        TextPass& pass = add_pass("step", "compute", "fill.comp");
        pass.more_text = R"j(, "repeat": {"j": "1..2", "i": "0..j"})j";
        pass.more_plain = pass.more_text;
        if (odd) {
            pass.more_text += R"j(, "if": "i % 2")j";
            pass.more_plain = R"j(, "repeat": {"j": "1..2", "i": "1..j by 2"})j";
            omitted_ = true;
        }
        pass.out = {said("dst", model_.resources[image].name + ".layer(j * 3 + i - 3)")};
        for (const uint32_t layer : {0, 1, 3, 4, 5})
            if (!odd || layer == 1 || layer == 4)
                add_closed_value(image, ".layer(" + std::to_string(layer) + ")");
    }

    void remember() {
        const bool words = chance(25);
        const size_t from = words ? plain_of(ValueKind::words) : plain_color();
        if (from == kNone) return;
        const uint32_t frames = between(1, 2);
        const size_t ring = words ? new_words() : new_image("ring");
        TextResource& r = model_.resources[ring];
        r.more = ", \"history\": " + std::to_string(frames) +
                 ", \"firstFrame\": " + std::to_string(below(2)) + on_resize(r);
        const std::string past = r.name + "[-" + std::to_string(between(1, frames)) + "]";
        add_pass("remember", "compute", words ? "words_2.comp" : "remember.comp");
        choose_condition(30);
        model_.passes.back().stays = model_.passes.back().condition != kNone;
        if (words) model_.passes.back().more += ", \"groups\": 4";
        TextPort a = input("a", from, model_.passes.back().condition, false);
        model_.passes.back().in = {std::move(a), said("b", past, words ? "" : nearest(ring))};
        write("dst", add_value(ring));
        if (!words) memories_.push_back({past, ring});
    }
    // Returns the key "onResize", or nothing. Some devices cannot filter r32f.
    std::string on_resize(const TextResource& r) {
        const bool scales = r.kind == ValueKind::color && r.format != "r32f";
        constexpr const char* kHow[] = {"", ", \"onResize\": \"refill\"", ", \"onResize\": \"resample\""};
        return kHow[below(scales ? 3 : 2)];
    }
    // Adds one more pass that reads the content of a ring (a resource with `history`) from an earlier frame.
    // If there is no ring yet, calls remember(), which adds a ring.
    void recall() {
        if (memories_.empty()) return remember();
        const auto& [past, ring] = memories_[below(static_cast<uint32_t>(memories_.size()))];
        add_pass("recall", "compute", "mix_3.comp");
        TextPort a = input("a", plain_color(), kNone, false);
        model_.passes.back().in = {std::move(a), said("b", past, nearest(ring)), said("c", "noise")};
        write("dst", target());
    }

    void keep() {
        const bool words = chance(30);
        const size_t kept = words ? new_words() : new_image("kept");
        if (!words) model_.resources[kept].format = chance(50) ? "rgba16f" : "r32f";
        TextResource& r = model_.resources[kept];
        const bool shared = !chance(70);
        r.more = std::string(", \"keep\": ") + (shared ? "\"shared\"" : "true") + on_resize(r);
        if (!shared && chance(50)) {
            r.more += ", \"history\": 1";
            if (!words) memories_.push_back({r.name + "[-1]", kept});
        }
        if (chance(20)) {
            add_closed_value(kept);
            return;
        }
        const size_t v = add_value(kept);
        model_.values[v].fresh = false;
        const std::string shader = words ? "slice_words.comp" : "update_" + r.format + ".comp";
        TextPass& pass = add_pass("keep", "compute", shader.c_str());
        if (words) pass.more += ", \"groups\": 4";
        const std::string name = r.name;
        if (!words) {
            TextPort a = input("a", other_color(v), kNone, false);
            model_.passes.back().in = {std::move(a)};
        }
        model_.passes.back().in.push_back(said("x", name));
        write("x", v);
    }

    // Adds repeats that are spread over frames (`perFrame`), so that each frame runs only some iterations.
    // Each iteration writes its own layer, and sometimes a second repeat with its own `perFrame` reads the
    // layers. Sometimes all iterations modify parts of one buffer instead.
    void frame_slices() {
        const uint32_t rounds = between(2, 4);
        const std::string slice = slice_keys(rounds);
        if (chance(30)) {
            const size_t kept = new_words();
            model_.resources[kept].more = ", \"keep\": true";
            const std::string name = model_.resources[kept].name;
            TextPass& pass = add_pass("slice", "compute", "slice_words.comp");
            pass.more += slice + ", \"groups\": 4, \"partial\": true";
            pass.out = {said("x", name)};
            add_closed_value(kept);
            return;
        }
        const size_t kept = kept_layers("sliced", rounds);
        add_pass("slice", "compute", "mix_1.comp").more += slice;
        model_.passes.back().in = {input("a", plain_color(), kNone, false)};
        model_.passes.back().out = {said("dst", model_.resources[kept].name + ".layer(i)")};
        close_layers(kept, rounds);
        if (!chance(60)) return;
        const size_t next = kept_layers("chained", rounds);
        TextPass& chained = add_pass("chain", "compute", "mix_1.comp");
        chained.more += slice_keys(rounds);
        chained.in = {said("a", model_.resources[kept].name + ".layer(i)", nearest(kept))};
        chained.out = {said("dst", model_.resources[next].name + ".layer(i)")};
        close_layers(next, rounds);
    }

    // Adds a fault (W124): all iterations of the repeat "bake" write the same kept image, but not all of them
    // run in the same frame (`perFrame`). So in some frames an iteration of the repeat "store" would read the
    // result of a wrong iteration of "bake", which ran in an earlier frame.
    void chain_slices_wrongly() {
        const uint32_t rounds = between(2, 4);
        const size_t scratch = new_image("scratch"), kept = kept_layers("stored", rounds);
        model_.resources[scratch].more = ", \"keep\": true";
        const std::string name = model_.resources[scratch].name, slice = slice_keys(rounds, rounds - 1);
        add_pass("bake", "compute", "mix_1.comp").more += slice;
        model_.passes.back().in = {input("a", plain_color(), kNone, false)};
        model_.passes.back().out = {said("dst", name)};
        TextPass& store = add_pass("store", "compute", "mix_1.comp");
        store.more += slice;
        store.in = {said("a", name, nearest(scratch))};
        store.out = {said("dst", model_.resources[kept].name + ".layer(i)")};
        close_layers(kept, rounds);
    }

 private:
    std::string slice_keys(uint32_t rounds, uint32_t most = UINT32_MAX) {
        return ", \"repeat\": {\"i\": \"0.." + std::to_string(rounds - 1) +
               "\"}, \"perFrame\": " + std::to_string(between(1, std::min(most, rounds)));
    }
    size_t kept_layers(const char* what, uint32_t layers) {
        const size_t kept = new_image(what, 1, layers);
        model_.resources[kept].more = ", \"keep\": true";
        return kept;
    }
    void close_layers(size_t image, uint32_t layers) {
        for (uint32_t layer = 0; layer < layers; ++layer)
            add_closed_value(image, ".layer(" + std::to_string(layer) + ")");
    }
    bool one_format_of(size_t resource) const {
        return model_.resources[resource].format.find('|') == std::string::npos;
    }
    std::string nearest(size_t resource) const {
        return model_.resources[resource].format == "r32f"
                   ? ", \"sampler\": {\"filter\": \"nearest\", \"mipFilter\": \"nearest\"}"
                   : "";
    }

    void climb(size_t image, const std::string& outer, const std::string& layer) {
        const std::string name = model_.resources[image].name;
        const std::string shader = "update_" + model_.resources[image].format + ".comp";
        TextPass& up = add_pass("up", "compute", shader.c_str());
        up.more += ", \"repeat\": {" + outer + "\"i\": \"mips(" + name + ")-2..0 by -1\"}";
        up.in = {said("a", name + ".mip(i+1)" + layer, nearest(image)), said("x", name + ".mip(i)" + layer)};
        up.out = {said("x", name + ".mip(i)" + layer)};
        choose_condition(50);
    }

    void read_on_the_way(const std::string& pinned, uint32_t mips, uint32_t layers, size_t image) {
        const std::string part = part_of(mips, between(1, mips - 2), layers, layers - 1);
        add_pass("aside", "compute", "mix_1.comp").in = {said("a", pinned + part, nearest(image))};
        write("dst", target());
    }

    void count_rounds(TextPass& pass) {
        const auto steps = static_cast<uint32_t>(parameter("steps"));
        switch (below(3)) {
            case 0:
                pass.more_text = R"j(, "repeat": {"i": "1..steps"})j";
                pass.more_plain = ", \"repeat\": {\"i\": \"1.." + std::to_string(steps) + "\"}";
                pass.empty = steps == 0;
                break;
            case 1:
                pass.more_text = R"j(, "repeat": {"i": "0..3"}, "if": "i % 2")j";
                pass.more_plain = R"j(, "repeat": {"i": "1..3 by 2"})j";
                omitted_ = true;
                break;
            default:
                pass.more += ", \"repeat\": {\"i\": \"" + std::to_string(between(1, 3)) + "..0 by -1\"}";
        }
    }

    // References to the past of rings, such as "ring[-1]", with the index of the ring's resource.
    std::vector<std::pair<std::string, size_t>> memories_;
};

}  // namespace weft::test
