#include "null/null_executor.h"

#include "null/cells.h"
#include "null/effective_use.h"
#include "null/execution_order.h"
#include "null/memory_model.h"
#include "null/observed_cells.h"
#include "null/pass_values.h"

namespace weft {
namespace null {
namespace {

// The values that one pass has read so far in one frame, indexed by use, then by cell in the order of the
// use's range.
struct Gathered {
    struct Value {
        CellValue value = kUndefinedValue;
        bool known = false;
    };
    std::vector<std::vector<Value>> uses;

    // Stores a value. If several stages of the pass read different values of one cell, the cell gets a new,
    // unique value.
    void note(uint32_t use, size_t index, CellValue value) {
        std::vector<Value>& all = uses[use];
        if (all.size() <= index) all.resize(index + 1);
        if (all[index].known && all[index].value != value)
            value = ValueHash().add("torn").add(all[index].value).add(value).value();
        all[index] = {value, true};
    }
};

class Execution {
 public:
    Execution(const FramePlan& plan, const Timeline& timeline, const NullOptions& options)
        : plan_(plan), timeline_(timeline), options_(options), memory_(plan, timeline, options.seed) {
        for (const PassInstance& instance : timeline.instances)
            gathered_.push_back({std::vector<std::vector<Gathered::Value>>(pass_of(instance).uses.size())});
    }

    NullRun run() {
        for (const uint32_t node : execution_order(timeline_, options_.order, options_.seed)) execute(node);
        for (uint32_t i = 0; i < timeline_.instances.size(); ++i) observe_pass(i);
        if (options_.frames > 0) observe_persistent();
        settle(run_.observed);
        run_.faults = memory_.take_faults();
        return std::move(run_);
    }

 private:
    const PassStep& step_of(const PassInstance& i) const { return plan_.barriers.steps[i.position]; }
    const PassDecl& pass_of(const PassInstance& i) const { return plan_.graph.passes[step_of(i).pass]; }

    void execute(uint32_t id) {
        const Node& node = timeline_.nodes[id];
        switch (node.kind) {
            case NodeKind::pass_read:
                return read(id, node);
            case NodeKind::pass_write:
                return write(id, node);
            case NodeKind::clear:
                return clear(id, node);
            case NodeKind::barrier:
                return memory_.barrier(id);
            case NodeKind::signal:
                return memory_.signal(id);
            case NodeKind::wait:
                return memory_.wait(id);
            case NodeKind::import_enter:
                return memory_.enter(node.resource, node.frame == 0);
            case NodeKind::import_access:
                return memory_.access_outside(id, node.resource);
            case NodeKind::import_leave:
                return leave(id, node);
        }
    }

    void read(uint32_t id, const Node& node) {
        const PassInstance& instance = timeline_.instances[node.instance];
        const PassDecl& pass = pass_of(instance);
        if (!runs_in_frame(pass, node.frame) || !has_combination(pass.runs_in, switches(node))) return;
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            if (!has_combination(use.used_in, switches(node))) continue;
            const EffectiveUse effective = effective_use(pass, step_of(instance), u);
            if (!effective.reads || !(effective.stages & node.stage)) continue;
            const Accessor accessor{id, node.stage, effective.access & ~access::kAllWrites, use.state.layout};
            const ResourceDecl& decl = plan_.graph.resources[use.resource];
            const ResourceId object = memory_.object_of(use.resource, node.frame);
            size_t index = 0;
            for_each_cell(decl, use, [&](uint32_t cell, const SubresourceRange& range) {
                CellValue value = memory_.read(object, cell, accessor);
                const bool nobody_wrote = source_of(use, range) == kNoId && !defined_before_frame(decl);
                if (nobody_wrote) value = kUndefinedValue;
                if (effective.loses_old) value = ValueHash().add("not loaded").add(uint64_t{id}).value();
                gathered_[node.instance].note(u, index++, value);
            });
        }
    }

    [[nodiscard]] Combination switches(const Node& node) const {
        return switches_in(options_.switches, node.frame);
    }

    ValueHash inputs(const Node& node) const {
        const PassId id = step_of(timeline_.instances[node.instance]).pass;
        ValueHash hash =
            pass_values(plan_.graph, plan_.live, id, {node.frame, switches(node)}, options_.inputs);
        const Gathered& gathered = gathered_[node.instance];
        for (uint32_t u = 0; u < gathered.uses.size(); ++u)
            if (sees_content(plan_.graph.passes[id].uses[u]) &&
                has_combination(plan_.graph.passes[id].uses[u].used_in, switches(node)))
                for (const Gathered::Value& v : gathered.uses[u]) hash.add(v.value);
        return hash;
    }

    void write(uint32_t id, const Node& node) {
        const PassInstance& instance = timeline_.instances[node.instance];
        const PassDecl& pass = pass_of(instance);
        if (!runs_in_frame(pass, node.frame) || !has_combination(pass.runs_in, switches(node))) return;
        const ValueHash hash = inputs(node);
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            const EffectiveUse effective = effective_use(pass, step_of(instance), u);
            if (!effective.writes ||
                write_stage(effective, instance.position, u, options_.seed) != node.stage)
                continue;
            const Accessor accessor{id, node.stage, effective.access, use.state.layout};
            const ResourceId object = memory_.object_of(use.resource, node.frame);
            const bool lost = (effective.loses_written && !(instance.scope_continues && draws_to(pass, u))) ||
                              (effective.loses_old && !sees_content(use));
            for_each_cell(
                plan_.graph.resources[use.resource], use, [&](uint32_t cell, const SubresourceRange& range) {
                    CellValue value =
                        writes(use.access) ? written_value(hash, use, range) : memory_.peek(object, cell);
                    if (lost) value = ValueHash().add("not kept").add(uint64_t{id}).value();
                    memory_.write(object, cell, accessor, value);
                });
        }
    }

    void clear(uint32_t id, const Node& node) {
        const ResourceDecl& decl = plan_.graph.resources[node.resource];
        const ResourceId object = memory_.object_of(node.resource, 0);
        const AccessState state = clear_state(decl);
        for_each_cell(decl, [&](uint32_t cell, const SubresourceRange&) {
            memory_.write(object, cell, {id, node.stage, state.access, state.layout},
                          first_frame_value(decl));
        });
    }

    void leave(uint32_t id, const Node& node) {
        const ResourceDecl& decl = plan_.graph.resources[node.resource];
        const AccessState& exit = decl.import ? decl.import->exit : *decl.between;
        const bool overwrites = (exit.access & access::kAllWrites) != 0;
        const Accessor accessor{id, node.stage, exit.access & ~access::kAllWrites, exit.layout};
        const ResourceId object = memory_.object_of(node.resource, node.frame);
        for_each_cell(decl, [&](uint32_t cell, const SubresourceRange& range) {
            const CellValue value = memory_.leave(object, cell, accessor, overwrites);
            run_.observed.push_back({node.frame, kNoId, 0, node.resource, range, value});
        });
    }

    void observe_pass(uint32_t instance) {
        const PassInstance& i = timeline_.instances[instance];
        const PassDecl& pass = pass_of(i);
        const Combination switches = switches_in(options_.switches, i.frame);
        if (!pass.side_effect || !has_combination(pass.runs_in, switches)) return;
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            if (!sees_content(pass.uses[u]) || !has_combination(pass.uses[u].used_in, switches)) continue;
            const std::vector<Gathered::Value>& values = gathered_[instance].uses[u];
            size_t index = 0;
            for_each_cell(plan_.graph.resources[pass.uses[u].resource], pass.uses[u],
                          [&](uint32_t, const SubresourceRange& range) {
                              run_.observed.push_back({i.frame, step_of(i).pass, u, pass.uses[u].resource,
                                                       range, values.at(index++).value});
                          });
        }
    }

    void observe_persistent() {
        const std::vector<uint8_t> used = used_resources(plan_.graph, plan_.live);
        const uint32_t last = options_.frames - 1;
        for (ResourceId id(0); id < plan_.graph.resources.size(); ++id) {
            const ResourceDecl& decl = plan_.graph.resources[id];
            if (decl.lifetime != ResourceLifetime::persistent || !used[id]) continue;
            const ResourceId object = memory_.object_of(id, last);
            for_each_cell(decl, [&](uint32_t cell, const SubresourceRange& range) {
                run_.observed.push_back({last, kNoId, 0, id, range, memory_.peek(object, cell)});
            });
        }
    }

    const FramePlan& plan_;
    const Timeline& timeline_;
    const NullOptions& options_;
    Memory memory_;
    std::vector<Gathered> gathered_;  // Index: as in Timeline::instances. Values that the passes have read.
    NullRun run_;
};

}  // namespace
}  // namespace null

NullRun run_null(const FramePlan& plan, const NullOptions& options) {
    const null::Timeline timeline =
        null::unroll(plan, options.frames, options.seed, options.resting, options.rounds);
    return null::Execution(plan, timeline, options).run();
}

}  // namespace weft
