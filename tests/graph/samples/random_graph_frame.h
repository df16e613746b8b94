// Purpose: holds the state of a random frame while it is generated: the random numbers, the written content,
// and the passes.
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tests/graph/samples/graph_builder.h"
#include "tests/graph/samples/random_graph.h"

namespace weft::test {

inline constexpr uint32_t kImportSidePx = 32;
inline constexpr uint32_t kImportWords = 256;
inline constexpr AccessState kSampledImport{stage::kComputeShader | stage::kFragmentShader,
                                            access::kSampledRead, Layout::shader_read_only};
inline constexpr AccessState kReadImport{stage::kComputeShader, access::kStorageRead, Layout::undefined};
inline constexpr AccessState kStateImport{stage::kComputeShader, access::kStorageRead | access::kStorageWrite,
                                          Layout::undefined};

// Content that a pass reads or writes: a range of an image (usually one mip of one layer), or pieces of a
// buffer (usually all).
struct RandomCell {
    ResourceId resource = kNoId;
    SubresourceRange range;
    // True if a pass has read the content since it was written, or if the content may stay unread. If false,
    // the generator usually combines the content into the final result.
    bool read = false;
};

class RandomFrame {
 public:
    RandomFrame(uint32_t seed, const RandomGraphOptions& options) : random_(seed), options_(options) {}

 protected:
    // These functions replace the distributions of <random>, whose results differ between standard libraries.
    // So a seed gives the same result everywhere.
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    uint32_t between(uint32_t low, uint32_t high) { return low + below(high - low + 1); }
    bool chance(uint32_t percent) { return below(100) < percent; }

    // Returns a random index below `count`. Usually returns one of the last four indices, which mean recently
    // written content. So lifetimes are short and memory is reused.
    size_t pick(size_t count) {
        const auto n = static_cast<uint32_t>(count);
        if (n > 4 && chance(75)) return n - 1 - below(4);
        return below(n);
    }

    uint32_t side_px(const RandomCell& cell) const {
        return mip_extent(builder_.resource(cell.resource).extent, cell.range.mip).width;
    }
    uint32_t words(const RandomCell& cell) const {
        return static_cast<uint32_t>(piece_bytes(builder_.resource(cell.resource), cell.range).size_bytes /
                                     4);
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
        if (!options_.queues || chance(25)) return;
        for (const RandomCell& cell : images_) builder_.make_concurrent(cell.resource);
        for (const RandomCell& cell : buffers_) builder_.make_concurrent(cell.resource);
        if (state_words_ != kNoId) builder_.make_concurrent(state_words_);
    }

    // Returns a random queue hint: graphics for a fullscreen pass, graphics or compute for a compute pass,
    // and any queue for other kinds. The compiler may choose a more capable queue.
    QueueKind queue_hint(PassKind kind) {
        const uint32_t roll = below(100);
        if (kind == PassKind::fullscreen || roll < 35) return QueueKind::graphics;
        return kind != PassKind::compute && roll < 75 ? QueueKind::transfer : QueueKind::compute;
    }

    std::string fresh_name(const char* what) {
        return std::string(1, static_cast<char>('a' + below(26))) + "_" + what + "_" +
               std::to_string(names_++);
    }

    // Returns a cell that the next pass shall write and that is not among `inputs`: a cell that no pass has
    // written, a cell whose content other passes have already read, or the first cell of a new image.
    RandomCell target(const std::vector<RandomCell>& inputs) {
        if (!unwritten_.empty() && chance(60)) {
            const size_t i = pick(unwritten_.size());
            const RandomCell cell = unwritten_[i];
            unwritten_.erase(unwritten_.begin() + static_cast<std::ptrdiff_t>(i));
            return cell;
        }
        if (chance(12)) {
            const RandomCell old = images_[pick(images_.size())];
            const bool taken = std::any_of(inputs.begin(), inputs.end(), [&](const RandomCell& in) {
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

    RandomCell new_image(uint32_t side) {
        const uint32_t mips = chance(30) ? between(2, 3) : 1;
        const uint32_t layers = chance(25) ? between(2, 3) : 1;
        const ResourceId id = builder_.image(fresh_name("image"), Format::r32u, side, mips, layers);
        for (uint32_t layer = 0; layer < layers; ++layer)
            for (uint32_t mip = 0; mip < mips; ++mip)
                if (mip + layer > 0) unwritten_.push_back({id, one_cell(mip, layer), false});
        return {id, one_cell(0), false};
    }

    RandomCell new_buffer() {
        return {builder_.buffer(fresh_name("words"), 1024u * between(1, 8)), {}, false};
    }

    void forget(const RandomCell& cell) {
        std::erase_if(images_, [&](const RandomCell& c) {
            return c.resource == cell.resource && overlaps(c.range, cell.range);
        });
    }

    std::vector<RandomCell> take(std::vector<RandomCell>& pool, size_t count) {
        std::vector<RandomCell> taken;
        for (size_t i = 0; i < count; ++i) {
            RandomCell& cell = pool[pick(pool.size())];
            cell.read = true;
            taken.push_back(cell);
        }
        return taken;
    }

    PassDecl& add(const char* what, PassKind kind, const char* shader, const std::vector<BuilderUse>& uses) {
        ++passes_;
        PassDecl& pass = builder_.pass(fresh_name(what), kind, uses);
        pass_names_.push_back(pass.name);
        if (options_.queues) pass.queue = queue_hint(kind);
        if (shader == nullptr) return pass;
        // Bindings are numbered in the order of the port names, and the name "dst" comes after the names of
        // all inputs.
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

    static std::vector<BuilderUse> inputs_of(const std::vector<RandomCell>& cells, Access access) {
        constexpr const char* kPorts[] = {"a", "b", "c"};
        std::vector<BuilderUse> uses;
        for (uint32_t i = 0; i < cells.size(); ++i)
            uses.push_back({kPorts[i], cells[i].resource, access, cells[i].range, i});
        return uses;
    }

    static BuilderUse destination(const RandomCell& cell, Access access) {
        return {"dst", cell.resource, access, cell.range, kNoId};
    }

    void set_image_groups(PassDecl& pass, const RandomCell& cell) const {
        const uint32_t groups = (side_px(cell) + 7) / 8;
        pass.groups = {groups, groups, 1};
    }

    std::mt19937 random_;
    RandomGraphOptions options_;
    GraphBuilder builder_;
    // Image content that passes may read: from earlier passes, from earlier frames and from the import. The
    // latest addition is at the end.
    std::vector<RandomCell> images_;
    // Buffers whose content passes may read.
    std::vector<RandomCell> buffers_;
    // Cells that no pass has written yet. Passes have written other cells of the same images.
    std::vector<RandomCell> unwritten_;
    std::vector<std::string> pass_names_;
    ResourceId state_words_ = kNoId;
    uint32_t passes_ = 0;
    uint32_t names_ = 0;
};

}  // namespace weft::test
