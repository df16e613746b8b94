// Computes the reference result of a graph: passes run one after another, each resource has its own memory,
// and each read sees the version that its declaration names.
#include <algorithm>
#include <set>
#include <utility>

#include "null/cells.h"
#include "null/null_executor.h"
#include "null/observed_cells.h"
#include "null/pass_values.h"

namespace weft {
namespace null {
namespace {

std::vector<PassId> program_order(const ResolvedGraph& graph, const LiveGraph& live) {
    std::vector<uint32_t> waiting(graph.passes.size(), 0);
    std::vector<std::vector<PassId>> next(graph.passes.size());
    for (const EdgeDecl& edge : graph.edges) {
        ++waiting[edge.to];
        next[edge.from].push_back(edge.to);
    }
    std::set<std::pair<uint32_t, PassId>> ready;
    for (PassId id(0); id < waiting.size(); ++id)
        if (waiting[id] == 0) ready.emplace(graph.passes[id].order_key, id);
    std::vector<PassId> order;
    while (!ready.empty()) {
        const PassId pass = ready.begin()->second;
        ready.erase(ready.begin());
        if (live.live_passes[pass]) order.push_back(pass);
        for (const PassId to : next[pass])
            if (--waiting[to] == 0) ready.emplace(graph.passes[to].order_key, to);
    }
    return order;
}

// Passes that run one after another: one pass, or all passes of a group.
struct Block {
    const GroupDecl* group = nullptr;
    std::vector<PassId> passes;
};

const GroupDecl* group_of(const ResolvedGraph& graph, PassId pass) {
    for (const GroupDecl& group : graph.groups)
        if (graph.passes[pass].rest_unit != kNoId && group.has_unit(graph.passes[pass].rest_unit))
            return &group;
    return nullptr;
}

// Divides the program order into blocks. A block is moved behind all blocks that it depends on, directly or
// not.
std::vector<Block> blocks_of(const ResolvedGraph& graph, const std::vector<PassId>& order) {
    std::vector<Block> left;
    for (const PassId pass : order) {
        const GroupDecl* group = group_of(graph, pass);
        const auto same = std::ranges::find_if(
            left, [&](const Block& block) { return group != nullptr && block.group == group; });
        if (same == left.end())
            left.push_back({group, {pass}});
        else
            same->passes.push_back(pass);
    }
    const auto block_with = [&](PassId pass) {
        return std::ranges::find_if(left, [&](const Block& block) {
            return std::ranges::find(block.passes, pass) != block.passes.end();
        });
    };
    std::vector<Block> sorted;
    while (!left.empty()) {
        std::set<const Block*> waiting;
        for (const EdgeDecl& edge : graph.edges) {
            const auto from = block_with(edge.from), to = block_with(edge.to);
            if (from != left.end() && to != left.end() && from != to) waiting.insert(&*to);
        }
        const auto ready = std::ranges::find_if(left, [&](const Block& b) { return !waiting.contains(&b); });
        if (ready == left.end()) break;
        sorted.push_back(std::move(*ready));
        left.erase(ready);
    }
    return sorted;
}

// The values of one cell in one frame: its value before the frame, and every value written since, with the
// writing pass.
struct Versions {
    CellValue before = kUndefinedValue;
    std::vector<std::pair<PassId, CellValue>> written;

    [[nodiscard]] CellValue by(PassId pass) const {
        for (const auto& [writer, value] : written)
            if (writer == pass) return value;
        return pass == kNoId ? before : kUndefinedValue;
    }
    [[nodiscard]] CellValue last() const { return written.empty() ? before : written.back().second; }
};

class Reference {
 public:
    Reference(const ResolvedGraph& graph, const LiveGraph& live, const RestChoice& resting,
              const InputChoice& inputs, const RoundOrder& rounds, const SwitchChoice& switches)
        : graph_(graph),
          live_(live),
          resting_(resting),
          inputs_(inputs),
          rounds_(rounds),
          switches_(switches),
          used_(used_resources(graph, live)),
          written_(graph.resources.size(), 0),
          rested_(graph.resources.size(), 0) {
        for (PassId id(0); id < graph.passes.size(); ++id)
            for (const UseDecl& use : graph.passes[id].uses) {
                if (!live.live_passes[id] || !writes(use.access)) continue;
                written_[use.resource] = 1;
                if (graph.passes[id].rest_unit != kNoId) rested_[use.resource] = 1;
            }
        for (const ResourceDecl& decl : graph.resources) {
            cells_.emplace_back(cell_count(decl));
            for_each_cell(decl, [&](uint32_t cell, const SubresourceRange& range) {
                Versions& v = cells_.back()[cell];
                if (decl.import) v.before = import_value(decl, range);
                if (decl.lifetime == ResourceLifetime::persistent) v.before = first_frame_value(decl);
            });
        }
    }

    NullRun run(uint32_t frames) {
        std::vector<Block> blocks;
        const std::vector<PassId> order = program_order(graph_, live_);
        if (!graph_.groups.empty()) blocks = blocks_of(graph_, order);
        for (frame_ = 0; frame_ < frames; ++frame_) {
            begin_frame();
            if (blocks.empty())
                for (const PassId pass : order) run_pass(pass);
            for (const Block& block : blocks) run_block(block);
            for (ResourceId id(0); id < cells_.size(); ++id) {
                const ResourceLifetime lifetime = graph_.resources[id].lifetime;
                const bool last = frame_ + 1 == frames;
                const bool seen = lifetime == ResourceLifetime::imported || graph_.resources[id].between ||
                                  (lifetime == ResourceLifetime::persistent && last);
                if (seen && used_[id]) observe_after_frame(id);
            }
        }
        settle(run_.observed);
        return std::move(run_);
    }

 private:
    void run_pass(PassId pass) {
        const PassDecl& decl = graph_.passes[pass];
        const bool runs = runs_in_frame(decl, frame_) && !rests(resting_, decl.rest_unit, frame_) &&
                          has_combination(decl.runs_in, switches());
        runs ? execute(pass) : pass_on(pass);
    }

    // Runs the passes of a block. The rounds of a group, each of which is one copy of the group's passes, run
    // in the order that `rounds_` has for this frame.
    void run_block(const Block& block) {
        if (block.group == nullptr || frame_ >= rounds_.size()) {
            // Without an order, the rounds run in the order of their numbers.
            std::vector<PassId> passes = block.passes;
            std::ranges::stable_sort(passes, {}, [&](PassId p) { return graph_.passes[p].rest_unit; });
            for (const PassId pass : passes) run_pass(pass);
            return;
        }
        const std::vector<uint32_t>& units = rounds_[frame_];
        for (const uint32_t unit : units)
            for (const PassId pass : block.passes)
                if (graph_.passes[pass].rest_unit == unit) execute(pass);
        for (const PassId pass : block.passes)
            if (std::ranges::find(units, graph_.passes[pass].rest_unit) == units.end()) pass_on(pass);
    }

    // Starts a frame. Transient resources start undefined, except those that a rest unit writes. Image
    // imports whose entry layout is `undefined` start undefined, too. A resource with history has several
    // copies: the copy with the age n has the content from n frames ago. From the second frame on, the copy
    // with the age n gets the last content of the copy with the age n - 1; see role() for the age 0. All
    // other resources keep their last content.
    void begin_frame() {
        std::vector<std::vector<CellValue>> left(cells_.size());
        for (ResourceId id(0); id < cells_.size(); ++id)
            for (const Versions& v : cells_[id]) left[id].push_back(v.last());
        for (ResourceId id(0); id < cells_.size(); ++id) {
            const ResourceDecl& decl = graph_.resources[id];
            const bool dropped = decl.import && decl.kind == ResourceKind::image &&
                                 decl.import->entry.layout == Layout::undefined;
            ResourceId from = id;
            if (frame_ > 0 && decl.history > 0) from = role(decl.ring, decl.age - 1);
            for (uint32_t c = 0; c < cells_[id].size(); ++c) {
                Versions& v = cells_[id][c];
                v.before = from == kNoId || dropped ? kUndefinedValue : left[from][c];
                v.written.clear();
                if (decl.lifetime == ResourceLifetime::transient && !rested_[id]) v.before = kUndefinedValue;
            }
        }
    }

    // Returns the copy of this age of a resource with history (`ring` is the copy of age 0), or kNoId if
    // there is none. begin_frame() passes the age of a copy minus 1. For the copy of age 0, this is
    // UINT32_MAX: the copy that the frame is about to write. If a pass writes the resource, this copy has no
    // content yet, and the result is kNoId. If no pass writes the resource, all copies have the same content,
    // and the result is the copy of age 0.
    ResourceId role(ResourceId ring, uint32_t age) const {
        if (age == UINT32_MAX) return written_[ring] ? kNoId : ring;
        for (ResourceId id(0); id < graph_.resources.size(); ++id)
            if (graph_.resources[id].ring == ring && graph_.resources[id].age == age) return id;
        return kNoId;
    }

    void execute(PassId id) {
        const PassDecl& pass = graph_.passes[id];
        ValueHash hash = pass_values(graph_, live_, id, {frame_, switches()}, inputs_);
        bool defined = true;
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            if (!sees_content(use) || !has_combination(use.used_in, switches())) continue;
            const ResourceDecl& decl = graph_.resources[use.resource];
            for_each_cell(decl, use, [&](uint32_t cell, const SubresourceRange& range) {
                const PassId source = source_of(use, range);
                const Versions& versions = cells_[use.resource][cell];
                const bool own = source != kNoId && graph_.passes[source].rest_unit == pass.rest_unit;
                const CellValue value = use.latest && !own ? versions.last() : versions.by(source);
                const bool nobody_wrote = source == kNoId && !defined_before_frame(decl);
                defined = defined && (value != kUndefinedValue || nobody_wrote);
                hash.add(value);
                if (pass.side_effect) run_.observed.push_back({frame_, id, u, use.resource, range, value});
            });
        }
        for (const UseDecl& use : pass.uses) {
            if (!writes(use.access)) continue;
            for_each_cell(
                graph_.resources[use.resource], use, [&](uint32_t cell, const SubresourceRange& range) {
                    const CellValue value = defined ? written_value(hash, use, range) : kUndefinedValue;
                    cells_[use.resource][cell].written.emplace_back(id, value);
                });
        }
    }

    // Simulates a pass that does not run in this frame: it rests, its switch is off, or its slice of a repeat
    // with `perFrame` does not run. The outputs of the pass keep their content.
    void pass_on(PassId id) {
        for (const UseDecl& use : graph_.passes[id].uses) {
            if (!writes(use.access)) continue;
            for_each_cell(graph_.resources[use.resource], use, [&](uint32_t cell, const SubresourceRange&) {
                Versions& v = cells_[use.resource][cell];
                v.written.emplace_back(id, v.last());
            });
        }
    }

    [[nodiscard]] Combination switches() const { return switches_in(switches_, frame_); }

    void observe_after_frame(ResourceId id) {
        for_each_cell(graph_.resources[id], [&](uint32_t cell, const SubresourceRange& range) {
            run_.observed.push_back({frame_, kNoId, 0, id, range, cells_[id][cell].last()});
        });
    }

    const ResolvedGraph& graph_;
    const LiveGraph& live_;
    const RestChoice& resting_;
    const InputChoice& inputs_;
    const RoundOrder& rounds_;
    const SwitchChoice& switches_;
    // Index: ResourceId. `used_`: 1 if a live pass uses any copy of the resource (its ring). `written_`: 1 if
    // a live pass writes this resource. `rested_`: 1 if a live pass with a rest unit writes this resource.
    std::vector<uint8_t> used_, written_, rested_;
    std::vector<std::vector<Versions>> cells_;  // Indexed by ResourceId, then by cell.
    uint32_t frame_ = 0;
    NullRun run_;
};

}  // namespace
}  // namespace null

NullRun run_reference(const ResolvedGraph& graph, const LiveGraph& live, uint32_t frames,
                      const RestChoice& resting, const InputChoice& inputs, const RoundOrder& rounds,
                      const SwitchChoice& switches) {
    return null::Reference(graph, live, resting, inputs, rounds, switches).run(frames);
}

}  // namespace weft
