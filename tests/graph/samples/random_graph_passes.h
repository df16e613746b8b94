// Purpose: adds the ordinary passes of random frames, which mix, draw, clear and copy content.
#pragma once

#include "tests/graph/samples/random_graph_frame.h"

namespace weft::test {

class RandomPasses : public RandomFrame {
 public:
    using RandomFrame::RandomFrame;

 protected:
    void fill_image() {
        const RandomCell cell = target_for_first();
        set_image_groups(
            add("fill", PassKind::compute, "fill_image.comp", {destination(cell, Access::storage_write)}),
            cell);
        images_.push_back(cell);
    }
    RandomCell target_for_first() { return images_.empty() ? new_image(32) : target({}); }

    // Sometimes extends the cell to all mips of its layer, if passes have written all of these mips.
    void widen(RandomCell& cell) {
        const ResourceDecl& decl = builder_.resource(cell.resource);
        const SubresourceRange all{0, decl.mips, cell.range.layer, 1, decl.aspects};
        std::vector<RandomCell*> parts;
        for (RandomCell& c : images_)
            if (c.resource == cell.resource && contains(all, c.range)) parts.push_back(&c);
        if (decl.mips == 1 || parts.size() != decl.mips || !chance(60)) return;
        for (RandomCell* part : parts) part->read = true;
        cell.range = all;
    }

    RandomCell mix_images(std::vector<RandomCell> inputs) {
        for (RandomCell& input : inputs) widen(input);
        const RandomCell cell = target(inputs);
        constexpr const char* kShaders[] = {"mix_image_1.comp", "mix_image_2.comp", "mix_image_3.comp"};
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
        uses.push_back(destination(cell, Access::storage_write));
        // Half of the passes with one input of several mips read them as an array.
        const bool as_array = inputs.size() == 1 && inputs[0].range.mips > 1 && passes_ % 2 == 0;
        PassDecl& pass =
            add("mix", PassKind::compute, as_array ? "mix_mips.comp" : kShaders[inputs.size() - 1], uses);
        if (as_array) pass.uses[0].each = EachPart::mip;
        set_image_groups(pass, cell);
        images_.push_back(cell);
        return cell;
    }

    void mix_buffers() {
        if (buffers_.empty()) return clear_buffer();
        const std::vector<RandomCell> inputs = take(buffers_, between(1, 2));
        const RandomCell cell = new_buffer();
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::storage_read);
        uses.push_back(destination(cell, Access::storage_write));
        const char* shader = inputs.size() == 1 ? "mix_buffer_1.comp" : "mix_buffer_2.comp";
        add("mixwords", PassKind::compute, shader, uses).groups = {(words(cell) + 63) / 64, 1, 1};
        buffers_.push_back(cell);
    }

    void update_image() {
        const size_t i = pick(images_.size());
        if (builder_.resource(images_[i].resource).lifetime != ResourceLifetime::transient) return;
        const RandomCell cell = images_[i];
        const RandomCell other = take(images_, 1).front();
        if (other.resource == cell.resource) return;
        set_image_groups(add("update", PassKind::compute, "update_image.comp",
                             {inputs_of({other}, Access::sampled_read).front(),
                              destination(cell, Access::storage_read_write)}),
                         cell);
        images_[i].read = false;
    }

    void update_state() {
        if (state_words_ == kNoId || buffers_.empty()) return;
        const RandomCell input = take(buffers_, 1).front();
        PassDecl& pass = add("state", PassKind::compute, "update_buffer.comp",
                             {inputs_of({input}, Access::storage_read).front(),
                              destination({state_words_, {}, false}, Access::storage_read_write)});
        pass.groups = {kImportWords / 64, 1, 1};
        pass.side_effect = true;
    }

    void update_buffer() {
        if (buffers_.size() < 2) return mix_buffers();
        const RandomCell input = take(buffers_, 1).front();
        RandomCell& cell = buffers_[pick(buffers_.size())];
        const ResourceDecl& decl = builder_.resource(cell.resource);
        if (cell.resource == input.resource || decl.lifetime != ResourceLifetime::transient) return;
        add("updatewords", PassKind::compute, "update_buffer.comp",
            {inputs_of({input}, Access::storage_read).front(), destination(cell, Access::storage_read_write)})
            .groups = {(words(cell) + 63) / 64, 1, 1};
        cell.read = false;
    }

    void image_to_buffer() {
        const RandomCell input = take(images_, 1).front();
        const RandomCell cell = new_buffer();
        add("towords", PassKind::compute, "image_to_buffer.comp",
            {inputs_of({input}, Access::sampled_read).front(), destination(cell, Access::storage_write)})
            .groups = {(words(cell) + 63) / 64, 1, 1};
        buffers_.push_back(cell);
    }

    RandomCell buffer_to_image(const RandomCell& input) {
        const RandomCell cell = target({});
        set_image_groups(
            add("toimage", PassKind::compute, "buffer_to_image.comp",
                {inputs_of({input}, Access::storage_read).front(), destination(cell, Access::storage_write)}),
            cell);
        images_.push_back(cell);
        return cell;
    }

    void clear_buffer() {
        const RandomCell cell = new_buffer();
        add("clearwords", PassKind::clear, nullptr, {{"dst", cell.resource, Access::clear_write, {}, kNoId}})
            .clear = {static_cast<float>(below(1000)), 0, 0, 0};
        buffers_.push_back(cell);
    }

    // Adds a pass that clears a new image: every mip of every layer.
    void clear_image() {
        const RandomCell cell = new_image(16u * between(1, 3));
        const ResourceDecl& decl = builder_.resource(cell.resource);
        add("clear", PassKind::clear, nullptr, {{"dst", cell.resource, Access::clear_write, {}, kNoId}})
            .clear = {static_cast<float>(below(1000)), 0, 0, 0};
        std::erase_if(unwritten_, [&](const RandomCell& c) { return c.resource == cell.resource; });
        for (uint32_t layer = 0; layer < decl.layers; ++layer)
            for (uint32_t mip = 0; mip < decl.mips; ++mip)
                images_.push_back({cell.resource, one_cell(mip, layer), mip + layer > 0});
    }

    void copy() {
        const size_t i = pick(images_.size());
        if (builder_.resource(images_[i].resource).lifetime != ResourceLifetime::transient) return;
        images_[i].read = true;
        const RandomCell source = images_[i];
        const RandomCell cell = new_image(side_px(source));
        add("copy", PassKind::copy, nullptr,
            {{"src", source.resource, Access::copy_read, source.range, kNoId},
             {"dst", cell.resource, Access::copy_write, cell.range, kNoId}});
        images_.push_back(cell);
    }

    void copy_buffer() {
        if (buffers_.empty()) return clear_buffer();
        RandomCell& source = buffers_[pick(buffers_.size())];
        if (builder_.resource(source.resource).lifetime != ResourceLifetime::transient) return;
        source.read = true;
        const RandomCell cell{builder_.buffer(fresh_name("words"), uint64_t{words(source)} * 4), {}, false};
        add("copywords", PassKind::copy, nullptr,
            {{"src", source.resource, Access::copy_read, source.range, kNoId},
             {"dst", cell.resource, Access::copy_write, {}, kNoId}});
        buffers_.push_back(cell);
    }

    void draw() {
        std::vector<RandomCell> inputs = take(images_, between(1, 2));
        const RandomCell cell = target(inputs);
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
        uses.push_back(destination(cell, Access::color_write));
        const char* shader = inputs.size() == 1 ? "mix_color_1.frag" : "mix_color_2.frag";
        PassDecl& pass = add("draw", PassKind::fullscreen, shader, uses);
        pass.colors.front().covers = true;
        images_.push_back(cell);
    }

    // Adds a pass that draws on a part of an image, so that the attachment must load the old content of the
    // other part.
    void draw_over() {
        const size_t i = pick(images_.size());
        const RandomCell cell = images_[i];
        const RandomCell input = take(images_, 1).front();
        const bool transient = builder_.resource(cell.resource).lifetime == ResourceLifetime::transient;
        if (!transient || input.resource == cell.resource) return;
        PassDecl& pass = add(
            "over", PassKind::fullscreen, "mix_color_1.frag",
            {inputs_of({input}, Access::sampled_read).front(), destination(cell, Access::color_read_write)});
        pass.state.scissor = RectPx{0, 0, side_px(cell), std::max(1u, side_px(cell) / 2)};
        images_[i].read = false;
    }

    // Adds a pass that computes a depth image from a colour image, and a pass that reads the depth image as
    // an input. Sometimes adds a pass between them that draws with a depth test against the depth image.
    void depth_chain() {
        const uint32_t side = 16u * between(1, 3);
        const ResourceId z = builder_.image(fresh_name("depth"), Format::d32f, side);
        PassDecl& write = add("depth", PassKind::fullscreen, "write_depth.frag",
                              {inputs_of(take(images_, 1), Access::sampled_read).front(),
                               {"depth", z, Access::depth_write, {}, kNoId}});
        write.state.depth_test = write.state.depth_write = true;
        write.state.depth_compare = CompareOp::always;
        if (chance(50)) {
            const RandomCell cell = new_image(side);
            PassDecl& test = add("tested", PassKind::fullscreen, "mix_color_1.frag",
                                 {inputs_of(take(images_, 1), Access::sampled_read).front(),
                                  destination(cell, Access::color_write),
                                  {"depth", z, Access::depth_read, {}, kNoId}});
            test.state.depth_test = true;
            test.state.depth_compare = CompareOp::always;
            images_.push_back(cell);
        }
        const RandomCell cell = target({});
        set_image_groups(
            add("fromdepth", PassKind::compute, "mix_depth.comp",
                {{"a", z, Access::sampled_read, {}, 0}, destination(cell, Access::storage_write)}),
            cell);
        images_.push_back(cell);
    }
};

}  // namespace weft::test
