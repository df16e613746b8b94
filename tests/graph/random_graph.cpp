#include "random_graph.h"

#include <algorithm>
#include <cassert>
#include <random>
#include <string>
#include <vector>

#include "graph_builder.h"

namespace weft::test {
namespace {

constexpr uint32_t kImportSidePx = 32;
constexpr uint32_t kImportWords = 256;
constexpr AccessState kSampledImport{stage::kComputeShader | stage::kFragmentShader, access::kSampledRead,
                                     Layout::shader_read_only};
constexpr AccessState kReadImport{stage::kComputeShader, access::kStorageRead, Layout::undefined};
constexpr AccessState kStateImport{stage::kComputeShader, access::kStorageRead | access::kStorageWrite,
                                   Layout::undefined};

// One mip of one layer of an image, or a buffer.
struct Cell {
    ResourceId resource = kNoId;
    SubresourceRange range;
    bool read = false;  // since it was written
};

class Generator {
 public:
    Generator(uint32_t seed, const RandomGraphOptions& options) : random_(seed), options_(options) {}

    ResolvedGraph run() {
        // Folding what nobody has read yet into the result takes passes too.
        const uint32_t wanted = between(options_.min_passes, options_.max_passes);
        const uint32_t body = std::max(2u, wanted * 6 / 10);
        add_imports();
        fill_image();
        while (passes_ < body) add_pass();
        fold(wanted);
        return builder_.build();
    }

 private:
    // --- chance; written out, because the standard's distributions differ between libraries
    // -----------------------
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    uint32_t between(uint32_t low, uint32_t high) { return low + below(high - low + 1); }
    bool chance(uint32_t percent) { return below(100) < percent; }

    // Mostly what was written lately, so that lifetimes are short and memory is handed over.
    size_t pick(size_t count) {
        const auto n = static_cast<uint32_t>(count);
        if (n > 4 && chance(75)) return n - 1 - below(4);
        return below(n);
    }

    // --- resources
    // ------------------------------------------------------------------------------------------------
    uint32_t side_px(const Cell& cell) const {
        return mip_extent(builder_.resource(cell.resource).extent, cell.range.mip).width;
    }
    uint32_t words(ResourceId buffer) const {
        return static_cast<uint32_t>(builder_.resource(buffer).size_bytes / 4);
    }

    void add_imports() {
        if (chance(50)) {
            const ResourceId id = builder_.image("import_image", Format::r32u, kImportSidePx);
            builder_.import_as(id, kSampledImport, kSampledImport);
            images_.push_back({id, one_cell(0), true});
        }
        if (chance(50)) {
            const ResourceId id = builder_.buffer("import_words", uint64_t{kImportWords} * 4);
            builder_.import_as(id, kReadImport, kReadImport);
            buffers_.push_back({id, {}, true});
        }
        if (chance(40)) {
            state_words_ = builder_.buffer("state_words", uint64_t{kImportWords} * 4);
            builder_.import_as(state_words_, kStateImport, kStateImport);
        }
    }

    std::string fresh_name(const char* what) {
        return std::string(1, static_cast<char>('a' + below(26))) + "_" + what + "_" +
               std::to_string(names_++);
    }

    // A cell to write, not among `inputs`: one never written of an image with several, an old one, or a new
    // image.
    Cell target(const std::vector<Cell>& inputs) {
        if (!unwritten_.empty() && chance(60)) {
            const size_t i = pick(unwritten_.size());
            const Cell cell = unwritten_[i];
            unwritten_.erase(unwritten_.begin() + static_cast<std::ptrdiff_t>(i));
            return cell;
        }
        if (chance(12)) {
            const Cell old = images_[pick(images_.size())];
            const bool taken = std::any_of(inputs.begin(), inputs.end(), [&](const Cell& in) {
                return in.resource == old.resource && overlaps(in.range, old.range);
            });
            if (!taken && old.read &&
                builder_.resource(old.resource).lifetime == ResourceLifetime::transient) {
                forget(old);
                return old;
            }
        }
        return new_image(16u * between(1, 3));
    }

    Cell new_image(uint32_t side) {
        const uint32_t mips = chance(30) ? between(2, 3) : 1;
        const uint32_t layers = chance(25) ? between(2, 3) : 1;
        const ResourceId id = builder_.image(fresh_name("image"), Format::r32u, side, mips, layers);
        for (uint32_t layer = 0; layer < layers; ++layer)
            for (uint32_t mip = 0; mip < mips; ++mip)
                if (mip + layer > 0) unwritten_.push_back({id, one_cell(mip, layer), false});
        return {id, one_cell(0), false};
    }

    Cell new_buffer() { return {builder_.buffer(fresh_name("words"), 1024u * between(1, 8)), {}, false}; }

    void forget(const Cell& cell) {
        std::erase_if(images_, [&](const Cell& c) {
            return c.resource == cell.resource && overlaps(c.range, cell.range);
        });
    }

    std::vector<Cell> take(std::vector<Cell>& pool, size_t count) {
        std::vector<Cell> taken;
        for (size_t i = 0; i < count; ++i) {
            Cell& cell = pool[pick(pool.size())];
            cell.read = true;
            taken.push_back(cell);
        }
        return taken;
    }

    // --- passes
    // ---------------------------------------------------------------------------------------------------
    PassDecl& add(const char* what, PassKind kind, const char* shader, const std::vector<BuilderUse>& uses) {
        ++passes_;
        PassDecl& pass = builder_.pass(fresh_name(what), kind, uses);
        if (shader == nullptr) return pass;
        // Bindings go by name, and "dst" follows all inputs.
        if (kind == PassKind::compute) pass.uses.back().binding = static_cast<uint32_t>(uses.size()) - 1;
        pass.shader = shader;
        ParamWrite seed;
        seed.member = "seed";
        seed.scalar = ScalarType::u32;
        seed.value[0] = static_cast<double>(below(1u << 24));
        pass.params = {seed};
        pass.params_bytes = 4;
        pass.params_push = true;
        return pass;
    }

    static std::vector<BuilderUse> inputs_of(const std::vector<Cell>& cells, Access access) {
        constexpr const char* kPorts[] = {"a", "b", "c"};
        std::vector<BuilderUse> uses;
        for (uint32_t i = 0; i < cells.size(); ++i)
            uses.push_back({kPorts[i], cells[i].resource, access, cells[i].range, i});
        return uses;
    }

    static BuilderUse destination(const Cell& cell, Access access) {
        return {"dst", cell.resource, access, cell.range, kNoId};
    }

    void set_image_groups(PassDecl& pass, const Cell& cell) const {
        const uint32_t groups = (side_px(cell) + 7) / 8;
        pass.groups = {groups, groups, 1};
    }

    void fill_image() {
        const Cell cell = target_for_first();
        set_image_groups(
            add("fill", PassKind::compute, "fill_image.comp", {destination(cell, Access::storage_write)}),
            cell);
        images_.push_back(cell);
    }
    Cell target_for_first() { return images_.empty() ? new_image(32) : target({}); }

    // All mips of a layer at once, where all are written.
    void widen(Cell& cell) {
        const ResourceDecl& decl = builder_.resource(cell.resource);
        const SubresourceRange all{0, decl.mips, cell.range.layer, 1, decl.aspects};
        std::vector<Cell*> parts;
        for (Cell& c : images_)
            if (c.resource == cell.resource && contains(all, c.range)) parts.push_back(&c);
        if (decl.mips == 1 || parts.size() != decl.mips || !chance(60)) return;
        for (Cell* part : parts) part->read = true;
        cell.range = all;
    }

    Cell mix_images(std::vector<Cell> inputs) {
        for (Cell& input : inputs) widen(input);
        const Cell cell = target(inputs);
        constexpr const char* kShaders[] = {"mix_image_1.comp", "mix_image_2.comp", "mix_image_3.comp"};
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
        uses.push_back(destination(cell, Access::storage_write));
        set_image_groups(add("mix", PassKind::compute, kShaders[inputs.size() - 1], uses), cell);
        images_.push_back(cell);
        return cell;
    }

    void mix_buffers() {
        if (buffers_.empty()) return clear_buffer();
        const std::vector<Cell> inputs = take(buffers_, between(1, 2));
        const Cell cell = new_buffer();
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::storage_read);
        uses.push_back(destination(cell, Access::storage_write));
        const char* shader = inputs.size() == 1 ? "mix_buffer_1.comp" : "mix_buffer_2.comp";
        add("mixwords", PassKind::compute, shader, uses).groups = {(words(cell.resource) + 63) / 64, 1, 1};
        buffers_.push_back(cell);
    }

    void update_image() {
        const size_t i = pick(images_.size());
        if (builder_.resource(images_[i].resource).lifetime != ResourceLifetime::transient) return;
        const Cell cell = images_[i];
        const Cell other = take(images_, 1).front();
        if (other.resource == cell.resource) return;
        set_image_groups(add("update", PassKind::compute, "update_image.comp",
                             {inputs_of({other}, Access::sampled_read).front(),
                              destination(cell, Access::storage_read_write)}),
                         cell);
        images_[i].read = false;
    }

    void update_state() {
        if (state_words_ == kNoId || buffers_.empty()) return;
        const Cell input = take(buffers_, 1).front();
        PassDecl& pass = add("state", PassKind::compute, "update_buffer.comp",
                             {inputs_of({input}, Access::storage_read).front(),
                              destination({state_words_, {}, false}, Access::storage_read_write)});
        pass.groups = {kImportWords / 64, 1, 1};
        pass.side_effect = true;
    }

    void update_buffer() {
        if (buffers_.size() < 2) return mix_buffers();
        const Cell input = take(buffers_, 1).front();
        Cell& cell = buffers_[pick(buffers_.size())];
        const ResourceDecl& decl = builder_.resource(cell.resource);
        if (cell.resource == input.resource || decl.lifetime != ResourceLifetime::transient) return;
        add("updatewords", PassKind::compute, "update_buffer.comp",
            {inputs_of({input}, Access::storage_read).front(), destination(cell, Access::storage_read_write)})
            .groups = {(words(cell.resource) + 63) / 64, 1, 1};
        cell.read = false;
    }

    void image_to_buffer() {
        const Cell input = take(images_, 1).front();
        const Cell cell = new_buffer();
        add("towords", PassKind::compute, "image_to_buffer.comp",
            {inputs_of({input}, Access::sampled_read).front(), destination(cell, Access::storage_write)})
            .groups = {(words(cell.resource) + 63) / 64, 1, 1};
        buffers_.push_back(cell);
    }

    Cell buffer_to_image(const Cell& input) {
        const Cell cell = target({});
        set_image_groups(
            add("toimage", PassKind::compute, "buffer_to_image.comp",
                {inputs_of({input}, Access::storage_read).front(), destination(cell, Access::storage_write)}),
            cell);
        images_.push_back(cell);
        return cell;
    }

    void clear_buffer() {
        const Cell cell = new_buffer();
        add("clearwords", PassKind::clear, nullptr, {{"dst", cell.resource, Access::clear_write, {}, kNoId}})
            .clear = {static_cast<float>(below(1000)), 0, 0, 0};
        buffers_.push_back(cell);
    }

    // A whole image at once: every mip of every layer.
    void clear_image() {
        const Cell cell = new_image(16u * between(1, 3));
        const ResourceDecl& decl = builder_.resource(cell.resource);
        add("clear", PassKind::clear, nullptr, {{"dst", cell.resource, Access::clear_write, {}, kNoId}})
            .clear = {static_cast<float>(below(1000)), 0, 0, 0};
        std::erase_if(unwritten_, [&](const Cell& c) { return c.resource == cell.resource; });
        for (uint32_t layer = 0; layer < decl.layers; ++layer)
            for (uint32_t mip = 0; mip < decl.mips; ++mip)
                images_.push_back({cell.resource, one_cell(mip, layer), mip + layer > 0});
    }

    void copy() {
        const size_t i = pick(images_.size());
        if (builder_.resource(images_[i].resource).lifetime != ResourceLifetime::transient) return;
        images_[i].read = true;
        const Cell source = images_[i];
        const Cell cell = new_image(side_px(source));
        add("copy", PassKind::copy, nullptr,
            {{"src", source.resource, Access::copy_read, source.range, kNoId},
             {"dst", cell.resource, Access::copy_write, cell.range, kNoId}});
        images_.push_back(cell);
    }

    void copy_buffer() {
        if (buffers_.empty()) return clear_buffer();
        Cell& source = buffers_[pick(buffers_.size())];
        if (builder_.resource(source.resource).lifetime != ResourceLifetime::transient) return;
        source.read = true;
        const Cell cell{
            builder_.buffer(fresh_name("words"), builder_.resource(source.resource).size_bytes), {}, false};
        add("copywords", PassKind::copy, nullptr,
            {{"src", source.resource, Access::copy_read, {}, kNoId},
             {"dst", cell.resource, Access::copy_write, {}, kNoId}});
        buffers_.push_back(cell);
    }

    void draw() {
        std::vector<Cell> inputs = take(images_, between(1, 2));
        const Cell cell = target(inputs);
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
        uses.push_back(destination(cell, Access::color_write));
        const char* shader = inputs.size() == 1 ? "mix_color_1.frag" : "mix_color_2.frag";
        PassDecl& pass = add("draw", PassKind::fullscreen, shader, uses);
        pass.colors.front().covers = true;
        images_.push_back(cell);
    }

    // Half of an image drawn over: the other half has to be loaded.
    void draw_over() {
        const size_t i = pick(images_.size());
        const Cell cell = images_[i];
        const Cell input = take(images_, 1).front();
        const bool transient = builder_.resource(cell.resource).lifetime == ResourceLifetime::transient;
        if (!transient || input.resource == cell.resource) return;
        PassDecl& pass = add(
            "over", PassKind::fullscreen, "mix_color_1.frag",
            {inputs_of({input}, Access::sampled_read).front(), destination(cell, Access::color_read_write)});
        pass.state.scissor = RectPx{0, 0, side_px(cell), std::max(1u, side_px(cell) / 2)};
        images_[i].read = false;
    }

    // Depth from an image, a drawing that tests against it, and depth as an input.
    void depth_chain() {
        const uint32_t side = 16u * between(1, 3);
        const ResourceId z = builder_.image(fresh_name("depth"), Format::d32f, side);
        PassDecl& write = add("depth", PassKind::fullscreen, "write_depth.frag",
                              {inputs_of(take(images_, 1), Access::sampled_read).front(),
                               {"depth", z, Access::depth_write, {}, kNoId}});
        write.state.depth_test = write.state.depth_write = true;
        write.state.depth_compare = CompareOp::always;
        if (chance(50)) {
            const Cell cell = new_image(side);
            PassDecl& test = add("tested", PassKind::fullscreen, "mix_color_1.frag",
                                 {inputs_of(take(images_, 1), Access::sampled_read).front(),
                                  destination(cell, Access::color_write),
                                  {"depth", z, Access::depth_read, {}, kNoId}});
            test.state.depth_test = true;
            test.state.depth_compare = CompareOp::always;
            images_.push_back(cell);
        }
        const Cell cell = target({});
        set_image_groups(
            add("fromdepth", PassKind::compute, "mix_depth.comp",
                {{"a", z, Access::sampled_read, {}, 0}, destination(cell, Access::storage_write)}),
            cell);
        images_.push_back(cell);
    }

    void add_pass() {
        const uint32_t roll = below(100);
        if (roll < 32) {
            mix_images(take(images_, between(1, 3)));
        } else if (roll < 40) {
            mix_buffers();
        } else if (roll < 47) {
            update_image();
        } else if (roll < 51) {
            update_buffer();
        } else if (roll < 56) {
            image_to_buffer();
        } else if (roll < 60 && !buffers_.empty()) {
            buffer_to_image(take(buffers_, 1).front());
        } else if (roll < 72) {
            draw();
        } else if (roll < 78) {
            draw_over();
        } else if (roll < 83) {
            depth_chain();
        } else {
            add_rare_pass(roll);
        }
    }

    void add_rare_pass(uint32_t roll) {
        if (roll < 86) {
            clear_image();
        } else if (roll < 92) {
            copy();
        } else if (roll < 95) {
            copy_buffer();
        } else if (roll < 97) {
            update_state();
        } else {
            fill_image();
        }
    }

    // What nobody has read flows into the result, but for some, which nobody needs.
    void fold(uint32_t wanted) {
        std::vector<Cell> loose;
        for (const Cell& cell : images_)
            if (!cell.read && chance(80)) loose.push_back(cell);
        for (const Cell& cell : std::vector<Cell>(buffers_))
            if (!cell.read && chance(80) && passes_ + 2 < wanted) loose.push_back(buffer_to_image(cell));
        Cell result = mix_images({images_.back()});
        for (size_t i = 0; i < loose.size() && passes_ + 2 < wanted; i += 2) {
            std::vector<Cell> inputs{result, loose[i]};
            if (i + 1 < loose.size()) inputs.push_back(loose[i + 1]);
            result = mix_into_new(inputs);
        }
        const Cell last{builder_.image("result", Format::r32u, kImportSidePx), one_cell(0), false};
        set_image_groups(add("finish", PassKind::compute, "mix_image_1.comp",
                             {inputs_of({result}, Access::sampled_read).front(),
                              destination(last, Access::storage_write)}),
                         last);
        builder_.pass("read_back", PassKind::readback,
                      {{"src", last.resource, Access::copy_read, {}, kNoId}});
    }

    // A loose cell may have been overwritten since; then its new content is read, which is as good.
    Cell mix_into_new(const std::vector<Cell>& inputs) {
        constexpr const char* kShaders[] = {"mix_image_1.comp", "mix_image_2.comp", "mix_image_3.comp"};
        const Cell cell = new_image(16u * between(1, 3));
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
        uses.push_back(destination(cell, Access::storage_write));
        set_image_groups(add("fold", PassKind::compute, kShaders[inputs.size() - 1], uses), cell);
        images_.push_back(cell);
        return cell;
    }

    std::mt19937 random_;
    RandomGraphOptions options_;
    GraphBuilder builder_;
    std::vector<Cell> images_;     // written cells, oldest first
    std::vector<Cell> buffers_;    // written buffers
    std::vector<Cell> unwritten_;  // cells of images of which others are written
    ResourceId state_words_ = kNoId;
    uint32_t passes_ = 0;
    uint32_t names_ = 0;
};

}  // namespace

ResolvedGraph random_graph(uint32_t seed, const RandomGraphOptions& options) {
    ResolvedGraph graph = Generator(seed, options).run();
    graph.name = "random_" + std::to_string(seed);
    return graph;
}

ResourceId random_graph_result(const ResolvedGraph& graph) {
    const PassDecl* pass = find_pass(graph, "read_back");
    assert(pass != nullptr);
    return pass->uses.front().resource;
}

}  // namespace weft::test
