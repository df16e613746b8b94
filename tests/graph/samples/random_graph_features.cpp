#include "tests/graph/samples/random_graph_features.h"

namespace weft::test {

bool RandomFeatures::add_feature() {
    using Feature = void (RandomFeatures::*)();
    std::vector<Feature> features;
    if (options_.history)
        features.insert(features.end(), {&RandomFeatures::remember_image, &RandomFeatures::remember_image,
                                         &RandomFeatures::remember_buffer});
    if (options_.keep)
        features.insert(features.end(), {&RandomFeatures::keep_image, &RandomFeatures::keep_buffer});
    if (options_.chains)
        features.insert(features.end(), {&RandomFeatures::mip_chain, &RandomFeatures::mip_chain});
    if (options_.ranges)
        features.insert(features.end(), {&RandomFeatures::clear_range, &RandomFeatures::copy_range,
                                         &RandomFeatures::divide_buffer, &RandomFeatures::divide_buffer,
                                         &RandomFeatures::divide_buffer});
    if (options_.depth_input) features.push_back(&RandomFeatures::test_against_input);
    if (options_.layers)
        features.insert(features.end(), {&RandomFeatures::draw_layers, &RandomFeatures::draw_depth_layers});
    if (options_.indirect) features.push_back(&RandomFeatures::dispatch_indirectly);
    if (options_.layer_arrays) features.push_back(&RandomFeatures::gather_layers);
    if (options_.views) features.push_back(&RandomFeatures::draw_views);
    if (features.empty() || !chance(24)) return false;
    (this->*features[below(static_cast<uint32_t>(features.size()))])();
    return true;
}

void RandomFeatures::draw_builtin_seed(PassDecl& pass, ResourceId role) {
    const uint32_t roll = below(100);
    if (roll < 35) {
        pass.params.front().builtin = Builtin::valid;
        pass.params.front().resource = role;
    } else if (roll < 60) {
        pass.params.front().builtin = Builtin::frame_index;
    }
}

void RandomFeatures::remember_image() {
    const uint32_t history = between(1, 2), mips = chance(30) ? 2 : 1;
    const std::vector<ResourceId> roles =
        builder_.ring(builder_.image(fresh_name("past"), Format::r32u, 16u * between(1, 2), mips), history);
    std::vector<RandomCell> inputs{take(images_, 1).front()};
    for (uint32_t age = 1; age <= history; ++age) {
        const RandomCell past{roles[age], chance(30) ? builder_.resource(roles[age]).whole() : one_cell(0),
                              true};
        inputs.push_back(past);
        images_.push_back({roles[age], one_cell(0), true});
    }
    constexpr const char* kShaders[] = {"mix_image_1.comp", "mix_image_2.comp", "mix_image_3.comp"};
    const RandomCell cell{roles[0], one_cell(0), false};
    std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
    uses.push_back(destination(cell, Access::storage_write));
    PassDecl& pass = add("recall", PassKind::compute, kShaders[inputs.size() - 1], uses);
    set_image_groups(pass, cell);
    draw_builtin_seed(pass, roles[history]);
    if (mips == 2) {
        const RandomCell small{roles[0], one_cell(1), true};
        set_image_groups(
            add("recallmip", PassKind::compute, "mix_image_1.comp",
                {inputs_of({cell}, Access::sampled_read).front(), destination(small, Access::storage_write)}),
            small);
    }
    images_.push_back(cell);
}

void RandomFeatures::remember_buffer() {
    const uint32_t history = between(1, 2);
    const std::vector<ResourceId> roles =
        builder_.ring(builder_.buffer(fresh_name("pastwords"), 1024u * between(1, 4)), history);
    const RandomCell cell{roles[0], {}, false};
    std::vector<RandomCell> inputs{{roles[history], {}, true}};
    if (!buffers_.empty()) inputs.push_back(take(buffers_, 1).front());
    std::vector<BuilderUse> uses = inputs_of(inputs, Access::storage_read);
    uses.push_back(destination(cell, Access::storage_write));
    PassDecl& pass = add("recallwords", PassKind::compute,
                         inputs.size() == 1 ? "mix_buffer_1.comp" : "mix_buffer_2.comp", uses);
    pass.groups = {(words(cell) + 63) / 64, 1, 1};
    draw_builtin_seed(pass, roles[history]);
    buffers_.push_back(cell);
}

void RandomFeatures::keep_image() {
    const ResourceId kept =
        builder_.ring(builder_.image(fresh_name("kept"), Format::r32u, 16u * between(1, 2)), 0).front();
    const RandomCell cell{kept, one_cell(0), false};
    const RandomCell other = take(images_, 1).front();
    if (chance(50)) mix_images({cell});
    set_image_groups(add("change", PassKind::compute, "update_image.comp",
                         {inputs_of({other}, Access::sampled_read).front(),
                          destination(cell, Access::storage_read_write)}),
                     cell);
    images_.push_back(cell);
}

void RandomFeatures::keep_buffer() {
    if (buffers_.empty()) return clear_buffer();
    const ResourceId kept =
        builder_.ring(builder_.buffer(fresh_name("keptwords"), 1024u * between(1, 4)), 0).front();
    const RandomCell cell{kept, {}, false};
    const RandomCell other = take(buffers_, 1).front();
    if (chance(50)) buffer_to_image(cell);
    add("changewords", PassKind::compute, "update_buffer.comp",
        {inputs_of({other}, Access::storage_read).front(), destination(cell, Access::storage_read_write)})
        .groups = {(words(cell) + 63) / 64, 1, 1};
    buffers_.push_back(cell);
}

void RandomFeatures::mip_chain() {
    const uint32_t mips = between(3, 5), layers = chance(40) ? 2 : 1;
    const ResourceId id = builder_.image(fresh_name("chain"), Format::r32u, 32, mips, layers);
    for (uint32_t layer = 0; layer < layers; ++layer) {
        const auto at = [&](uint32_t mip) { return RandomCell{id, one_cell(mip, layer), true}; };
        const auto step = [&](const char* what, const RandomCell& from, const RandomCell& to, bool in_place) {
            const Access access = in_place ? Access::storage_read_write : Access::storage_write;
            set_image_groups(add(what, PassKind::compute, in_place ? "update_image.comp" : "mix_image_1.comp",
                                 {inputs_of({from}, Access::sampled_read).front(), destination(to, access)}),
                             to);
        };
        step("top", take(images_, 1).front(), at(0), false);
        for (uint32_t mip = 1; mip < mips; ++mip) step("down", at(mip - 1), at(mip), false);
        if (chance(50))
            for (uint32_t mip = mips - 1; mip-- > 0;) step("up", at(mip + 1), at(mip), true);
    }
    for (uint32_t layer = 0; layer < layers; ++layer)
        for (uint32_t mip = 0; mip < mips; ++mip)
            images_.push_back({id, one_cell(mip, layer), layer + 1 < layers || mip > 0});
}

// Clears one or two mips of all layers of a new image. Later passes may write the remaining mips.
void RandomFeatures::clear_range() {
    const ResourceId id = builder_.image(fresh_name("parts"), Format::r32u, 32, 3, 2);
    const SubresourceRange range{below(2), between(1, 2), 0, 2, aspect::kColor};
    add("clearparts", PassKind::clear, nullptr, {{"dst", id, Access::clear_write, range, kNoId}}).clear = {
        static_cast<float>(below(1000)), 0, 0, 0};
    for (uint32_t layer = 0; layer < 2; ++layer)
        for (uint32_t mip = 0; mip < 3; ++mip) {
            const RandomCell cell{id, one_cell(mip, layer), true};
            (contains(range, cell.range) ? images_ : unwritten_).push_back(cell);
        }
    images_.back().read = false;
}

// Copies mips 0 and 1 of both layers of one image to mips 1 and 2 of another image.
void RandomFeatures::copy_range() {
    const SubresourceRange range{0, 2, 0, 2, aspect::kColor};
    const ResourceId from = builder_.image(fresh_name("source"), Format::r32u, 16, 2, 2);
    add("clearparts", PassKind::clear, nullptr, {{"dst", from, Access::clear_write, range, kNoId}}).clear = {
        static_cast<float>(below(1000)), 0, 0, 0};
    const RandomCell changed{from, one_cell(below(2), below(2)), true};
    set_image_groups(add("change", PassKind::compute, "update_image.comp",
                         {inputs_of(take(images_, 1), Access::sampled_read).front(),
                          destination(changed, Access::storage_read_write)}),
                     changed);
    const ResourceId to = builder_.image(fresh_name("parts"), Format::r32u, 32, 3, 2);
    const SubresourceRange half{1, 2, 0, 2, aspect::kColor};
    add("copyparts", PassKind::copy, nullptr,
        {{"src", from, Access::copy_read, range, kNoId}, {"dst", to, Access::copy_write, half, kNoId}});
    for (uint32_t layer = 0; layer < 2; ++layer) {
        unwritten_.push_back({to, one_cell(0, layer), false});
        for (uint32_t mip = 1; mip < 3; ++mip) images_.push_back({to, one_cell(mip, layer), mip + layer > 1});
    }
}

// Adds passes that write disjoint ranges of one buffer, in any order. Then a pass modifies a range that
// overlaps several of them, and a pass reads another range.
void RandomFeatures::divide_buffer() {
    constexpr uint32_t kPieceBytes = 256;  // Every device accepts this alignment.
    const uint32_t pieces = between(2, 5);
    ResourceId id = builder_.buffer(fresh_name("divided"), uint64_t{kPieceBytes} * pieces * between(1, 2));
    std::vector<uint64_t> cuts;
    for (uint32_t piece = 1; piece < pieces; ++piece) cuts.push_back(uint64_t{kPieceBytes} * piece);
    builder_.cut(id, cuts);
    if (options_.keep && chance(40)) id = builder_.ring(id, options_.history ? below(2) : 0).front();
    const auto cell = [&](uint32_t first, uint32_t count) {
        return RandomCell{id, {0, 1, first, count, aspect::kColor}, true};
    };
    const auto write = [&](const char* what, const char* shader, const RandomCell& to, Access access) {
        const BuilderUse input =
            buffers_.empty() ? BuilderUse{} : inputs_of(take(buffers_, 1), Access::storage_read).front();
        if (input.resource == kNoId || input.resource == id) {
            add("clearpart", PassKind::clear, nullptr, {{"dst", id, Access::clear_write, to.range, kNoId}})
                .clear = {static_cast<float>(below(1000)), 0, 0, 0};
            return;
        }
        add(what, PassKind::compute, shader, {input, destination(to, access)}).groups = {
            (words(to) + 63) / 64, 1, 1};
    };
    for (uint32_t piece = 0; piece < pieces;) {
        const uint32_t count = std::min(between(1, 2), pieces - piece);
        write("part", "mix_buffer_1.comp", cell(piece, count), Access::storage_write);
        piece += count;
    }
    const uint32_t first = below(pieces), count = between(1, pieces - first);
    write("overpart", "update_buffer.comp", cell(first, count), Access::storage_read_write);
    const uint32_t begin = below(pieces);
    RandomCell seen = cell(begin, between(1, pieces - begin));
    buffer_to_image(seen);
    seen.read = false;
    buffers_.push_back(seen);
}

void RandomFeatures::test_against_input() {
    const uint32_t side = 16u * between(1, 3);
    const ResourceId z = builder_.image(fresh_name("depth"), Format::d32f, side);
    PassDecl& write = add("depth", PassKind::fullscreen, "write_depth.frag",
                          {inputs_of(take(images_, 1), Access::sampled_read).front(),
                           {"depth", z, Access::depth_write, {}, kNoId}});
    write.state.depth_test = write.state.depth_write = true;
    write.state.depth_compare = CompareOp::always;
    const RandomCell cell = new_image(side);
    PassDecl& test = add("sampled", PassKind::fullscreen, "mix_color_depth.frag",
                         {{"a", z, Access::sampled_read, {}, 0},
                          destination(cell, Access::color_write),
                          {"depth", z, Access::depth_read, {}, kNoId}});
    test.state.depth_test = true;
    test.state.depth_compare = CompareOp::always;
    test.colors.front().covers = true;
    images_.push_back(cell);
}

// Adds a pass that draws on a whole image, and one to three passes that draw on the left part of the image.
// Usually all these passes have the same inputs, so that no barrier is needed between them. Sometimes a pass
// has a different input.
void RandomFeatures::draw_layers() {
    const std::vector<RandomCell> inputs = take(images_, between(1, 2));
    const RandomCell cell = new_image(16u * between(1, 3));
    const char* shader = inputs.size() == 1 ? "mix_color_1.frag" : "mix_color_2.frag";
    for (uint32_t layer = 0, layers = between(2, 4); layer < layers; ++layer) {
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
        if (chance(15)) uses.front() = inputs_of(take(images_, 1), Access::sampled_read).front();
        uses.push_back(destination(cell, layer == 0 ? Access::color_write : Access::color_read_write));
        PassDecl& pass = add("layer", PassKind::fullscreen, shader, uses);
        pass.colors.front().covers = layer == 0 && chance(50);
        const uint32_t side = side_px(cell);
        if (layer > 0) pass.state.scissor = RectPx{0, 0, std::max(1u, side / (layer + 1)), side};
    }
    images_.push_back(cell);
}

// Adds passes that write the same depth image. Then adds the same number of passes that draw on one colour
// image and only test this depth.
void RandomFeatures::draw_depth_layers() {
    const std::vector<RandomCell> inputs = take(images_, 1);
    const uint32_t side = 16u * between(1, 3);
    const ResourceId z = builder_.image(fresh_name("depth"), Format::d32f, side);
    const uint32_t layers = between(2, 3);
    const auto draw = [&](const char* shader, uint32_t layer, const BuilderUse& output, Access depth) {
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
        if (output.resource != kNoId) uses.push_back(output);
        uses.push_back({"depth", z, depth, {}, kNoId});
        PassDecl& pass = add("depthlayer", PassKind::fullscreen, shader, uses);
        pass.state.depth_test = true;
        pass.state.depth_write = writes(depth);
        pass.state.depth_compare = CompareOp::always;
        if (layer > 0) pass.state.scissor = RectPx{0, 0, side, std::max(1u, side / (layer + 1))};
    };
    for (uint32_t layer = 0; layer < layers; ++layer)
        draw("write_depth.frag", layer, {}, layer == 0 ? Access::depth_write : Access::depth_read_write);
    const RandomCell cell{builder_.image(fresh_name("image"), Format::r32u, side), one_cell(0), false};
    for (uint32_t layer = 0; layer < layers; ++layer)
        draw("mix_color_1.frag", layer,
             destination(cell, layer == 0 ? Access::color_write : Access::color_read_write),
             Access::depth_read);
    images_.push_back(cell);
}

// Adds one or two passes that draw several views, each to its own layer of a new image.
void RandomFeatures::draw_views() {
    constexpr uint32_t kMostViews = 4;
    const std::string list = "sights";
    if (!has_views_) builder_.add_view_list(list, kMostViews);
    has_views_ = true;
    const uint32_t views = between(2, kMostViews), side = 16u * between(1, 3);
    const ResourceId id = builder_.image(fresh_name("views"), Format::r32u, side, 1, views);
    const RandomCell all{id, builder_.resource(id).whole(), false};
    for (uint32_t i = 0, count = between(1, 2); i < count; ++i) {
        std::vector<BuilderUse> uses = inputs_of(take(images_, 1), Access::sampled_read);
        uses.push_back(destination(all, i == 0 ? Access::color_write : Access::color_read_write));
        PassDecl& pass = add("views", PassKind::fullscreen, "mix_color_1.frag", uses);
        pass.lowering = ViewLowering::multiview;
        for (uint32_t view = 0; view < views; ++view)
            pass.views.push_back(list + "(" + std::to_string(view) + ")");
        pass.view = pass.views.front();
        pass.colors.front().covers = i == 0 && chance(50);
        if (i > 0) pass.state.scissor = RectPx{0, 0, std::max(1u, side / 2), side};
    }
    for (uint32_t layer = 0; layer < views; ++layer) images_.push_back({id, one_cell(0, layer), layer > 0});
}

// Adds passes that write numbers of workgroups to the pieces of a buffer, and a dispatch for each piece.
void RandomFeatures::dispatch_indirectly() {
    constexpr uint32_t kPieceBytes = 256;
    const uint32_t pieces = between(1, 3);
    const ResourceId sizes = builder_.buffer(fresh_name("sizes"), uint64_t{kPieceBytes} * pieces);
    std::vector<uint64_t> cuts;
    for (uint32_t piece = 1; piece < pieces; ++piece) cuts.push_back(uint64_t{kPieceBytes} * piece);
    builder_.cut(sizes, cuts);
    for (uint32_t piece = 0; piece < pieces; ++piece) {
        const RandomCell cell = target_for_first();
        const SubresourceRange range = one_cell(0, piece);
        // All words of the piece get the same number, so there are also several workgroups along z. They
        // write the same values.
        const float groups = static_cast<float>((side_px(cell) + 7) / 8);
        add("size", PassKind::clear, nullptr, {{"dst", sizes, Access::clear_write, range, kNoId}}).clear = {
            groups, 0, 0, 0};
        PassDecl& pass = add("sized", PassKind::compute, "fill_image.comp",
                             {{"indirect", sizes, Access::indirect_read, range, kNoId},
                              destination(cell, Access::storage_write)});
        pass.uses.back().binding = 0;
        pass.indirect_use = 0;
        images_.push_back(cell);
    }
}

// Adds an image with two or three layers, and a pass that reads them as an array.
void RandomFeatures::gather_layers() {
    const uint32_t layers = between(2, 3);
    const ResourceId stack = builder_.image(fresh_name("stack"), Format::r32u, 32, 1, layers);
    for (uint32_t layer = 0; layer < layers; ++layer) {
        const RandomCell cell{stack, one_cell(0, layer), true};
        set_image_groups(add("layer", PassKind::compute, "mix_image_1.comp",
                             {inputs_of(take(images_, 1), Access::sampled_read).front(),
                              destination(cell, Access::storage_write)}),
                         cell);
    }
    const RandomCell all{stack, {0, 1, 0, layers, aspect::kColor}, true}, cell = target({all});
    PassDecl& pass =
        add("gather", PassKind::compute, "mix_mips.comp",
            {inputs_of({all}, Access::sampled_read).front(), destination(cell, Access::storage_write)});
    pass.uses.front().each = EachPart::layer;
    set_image_groups(pass, cell);
    images_.push_back(cell);
}

void RandomFeatures::add_after_edges() {
    for (uint32_t i = between(0, 4); i > 0 && pass_names_.size() > 2; --i) {
        const uint32_t from = below(static_cast<uint32_t>(pass_names_.size()) - 1);
        const uint32_t to = between(from + 1, static_cast<uint32_t>(pass_names_.size()) - 1);
        builder_.after(pass_names_[from], pass_names_[to]);
    }
}

}  // namespace weft::test
