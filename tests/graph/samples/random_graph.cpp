#include "tests/graph/samples/random_graph.h"

#include <algorithm>
#include <cassert>
#include <random>

#include "tests/graph/samples/random_graph_features.h"
#include "weft/imports.h"

namespace weft::test {
namespace {

class Generator : public RandomFeatures {
 public:
    using RandomFeatures::RandomFeatures;

    ResolvedGraph run() {
        // About 60 % of the passes are made at random. The others are left for fold(), which combines unread
        // results into the final result.
        const uint32_t wanted = between(options_.min_passes, options_.max_passes);
        const uint32_t body = std::max(2u, wanted * 6 / 10);
        add_imports();
        fill_image();
        while (passes_ < body) add_pass();
        fold(wanted);
        if (options_.after) add_after_edges();
        return builder_.build();
    }

 private:
    void add_pass() {
        if (add_feature()) return;
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

    // Takes most of the results that no pass has read so far, and combines them into the final result. The
    // other unread results stay unused, so that their passes are culled.
    void fold(uint32_t wanted) {
        std::vector<RandomCell> loose;
        for (const RandomCell& cell : images_)
            if (!cell.read && chance(80)) loose.push_back(cell);
        for (const RandomCell& cell : std::vector<RandomCell>(buffers_))
            if (!cell.read && chance(80) && passes_ + 2 < wanted) loose.push_back(buffer_to_image(cell));
        RandomCell result = mix_images({images_.back()});
        for (size_t i = 0; i < loose.size() && passes_ + 2 < wanted; i += 2) {
            std::vector<RandomCell> inputs{result, loose[i]};
            if (i + 1 < loose.size()) inputs.push_back(loose[i + 1]);
            result = mix_into_new(inputs);
        }
        const RandomCell last{builder_.image("result", Format::r32u, kImportSidePx), one_cell(0), false};
        set_image_groups(add("finish", PassKind::compute, "mix_image_1.comp",
                             {inputs_of({result}, Access::sampled_read).front(),
                              destination(last, Access::storage_write)}),
                         last);
        builder_.pass("read_back", PassKind::readback,
                      {{"src", last.resource, Access::copy_read, {}, kNoId}});
    }

    // Mixes the inputs into a new image. Another pass may have overwritten an input after fold() chose it.
    // Then the new pass reads the newer content, and the graph is still valid.
    RandomCell mix_into_new(const std::vector<RandomCell>& inputs) {
        constexpr const char* kShaders[] = {"mix_image_1.comp", "mix_image_2.comp", "mix_image_3.comp"};
        const RandomCell cell = new_image(16u * between(1, 3));
        std::vector<BuilderUse> uses = inputs_of(inputs, Access::sampled_read);
        uses.push_back(destination(cell, Access::storage_write));
        set_image_groups(add("fold", PassKind::compute, kShaders[inputs.size() - 1], uses), cell);
        images_.push_back(cell);
        return cell;
    }
};

// Adds a table of textures to a built graph. Some compute passes sample it through the port "t". The table
// has the last name, so that all resources keep their ids.
void add_table(ResolvedGraph& graph, uint32_t seed) {
    std::mt19937 random(seed);
    ResourceDecl table = texture_table("zz_table", 1 + random() % 20).resource;
    table.import->concurrent = random() % 8 > 0;
    const ResourceId id(graph.resources.size());
    bool used = false;
    for (PassDecl& pass : graph.passes) {
        const bool has_use =
            std::ranges::any_of(pass.params, [](const ParamWrite& p) { return p.use != kNoId; });
        if (pass.kind != PassKind::compute || pass.indirect_use != kNoId || has_use || random() % 4 > 0)
            continue;
        UseDecl use;
        use.port = "t";
        use.resource = id;
        use.range = table.whole();
        use.access = Access::sampled_read;
        use.state = access_state(use.access, stage_bit(ShaderStage::compute), table.aspects);
        use.sources = {{use.range, kNoId}};
        use.binding = static_cast<uint32_t>(pass.uses.size());
        pass.uses.insert(std::ranges::find(pass.uses, true, &UseDecl::is_output), std::move(use));
        used = true;
    }
    if (used) graph.resources.push_back(std::move(table));
}

}  // namespace

RandomGraphOptions all_features() {
    RandomGraphOptions options;
    options.history = options.keep = options.queues = options.after = true;
    options.chains = options.ranges = options.depth_input = options.layers = options.views = true;
    options.indirect = options.layer_arrays = true;
    return options;
}

ResolvedGraph random_graph(uint32_t seed, const RandomGraphOptions& options) {
    ResolvedGraph graph = Generator(seed, options).run();
    if (options.tables) add_table(graph, seed);
    graph.name = "random_" + std::to_string(seed);
    return graph;
}

ResourceId random_graph_result(const ResolvedGraph& graph) {
    const PassId pass = find_pass(graph, "read_back");
    assert(pass != kNoId);
    return graph.passes[pass].uses.front().resource;
}

}  // namespace weft::test
