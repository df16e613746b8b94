#include "null/timeline.h"

#include <algorithm>
#include <array>
#include <optional>

#include "null/cells.h"
#include "null/effective_use.h"
#include "null/recorded_steps.h"

namespace weft::null {
namespace {

// The stages of each pipeline in logical order. All other stages have no order.
constexpr std::array kDrawing{stage::kDrawIndirect,       stage::kVertexInput,    stage::kVertexShader,
                              stage::kEarlyFragmentTests, stage::kFragmentShader, stage::kLateFragmentTests,
                              stage::kColorOutput};
constexpr std::array kDispatching{stage::kDrawIndirect, stage::kComputeShader};

// Adds the logically earlier stages of a pipeline to a source mask, or the logically later stages to a
// destination mask.
template <size_t N>
StageMask along(const std::array<StageMask, N>& pipeline, StageMask stages, bool earlier) {
    StageMask result = stages;
    for (size_t i = 0; i < N; ++i)
        for (size_t j = 0; j < N; ++j)
            if ((stages & pipeline[i]) && (earlier ? j < i : j > i)) result |= pipeline[j];
    return result;
}
StageMask source_scope(StageMask stages) {
    return along(kDrawing, stages, true) | along(kDispatching, stages, true);
}
StageMask destination_scope(StageMask stages) {
    return along(kDrawing, stages, false) | along(kDispatching, stages, false);
}

// The stages that access only attachments. Element 0 is for colour attachments, element 1 for depth
// attachments.
constexpr std::array kAttachmentStages{stage::kColorOutput,
                                       stage::kEarlyFragmentTests | stage::kLateFragmentTests};

// The draws of a rendering scope so far, for colour and for depth attachments. Later draws in the scope
// access the attachments after them, because the rasteriser keeps the order of draws.
struct Drawing {
    std::array<NodeSet, kAttachmentStages.size()> done;
};

template <class F>
void for_each_stage(StageMask stages, F visit) {
    for (size_t s = 0; s < stage::kCount; ++s)
        if (stages & (1u << s)) visit(s);
}

// The dependencies of the next commands on one queue, as sets of nodes, one set per stage.
struct QueueProgress {
    // Index: bit of the stage. Nodes that the next command must wait for in this stage.
    std::array<NodeSet, stage::kCount> required;
    // Index: bit of the stage. Nodes that a barrier with this source stage waits for.
    std::array<NodeSet, stage::kCount> reached;
    NodeSet everything;  // All nodes of the queue so far, and all nodes for which they have waited.
};

class Unroller {
 public:
    Unroller(const FramePlan& plan, uint64_t choice, const RestChoice& resting, const RoundOrder& rounds)
        : plan_(plan),
          choice_(choice),
          resting_(resting),
          rounds_(rounds),
          queues_(plan.schedule.queues.size()),
          entered_(plan.graph.resources.size(), kNoNode),
          uses_of_import_(plan.graph.resources.size()) {
        for (const PassId pass : plan.schedule.order)
            for (const UseDecl& use : plan.graph.passes[pass].uses)
                if (plan.graph.resources[use.resource].import) imports_.push_back(use.resource);
        for (ResourceId id(0); id < plan.graph.resources.size(); ++id)
            if (plan.graph.resources[id].between && plan.live.live_resources[id]) kept_.push_back(id);
        std::sort(imports_.begin(), imports_.end());
        imports_.erase(std::unique(imports_.begin(), imports_.end()), imports_.end());
    }

    Timeline run(uint32_t frames) {
        prologue();
        for (frame_ = 0; frame_ < frames; ++frame_) {
            enter_imports();
            previous_signals_ = std::move(signals_);
            signals_.assign(plan_.submissions.batches.size(), kNoNode);
            for (uint32_t b = 0; b < plan_.submissions.batches.size(); ++b) batch(b);
            for (const ResourceId import : imports_) leave(import);
            for (const ResourceId kept : kept_) read_kept(kept);
        }
        return std::move(timeline_);
    }

 private:
    uint32_t add(Node node, NodeSet before) {
        node.frame = frame_;
        const auto id = static_cast<uint32_t>(timeline_.nodes.size());
        timeline_.nodes.push_back(node);
        timeline_.before.push_back(std::move(before));
        timeline_.outside_before.emplace_back();
        return id;
    }

    // Orders an access to an import between the owner's accesses before and after the frame.
    void touch_import(uint32_t node, ResourceId id) {
        if (entered_[id] == kNoNode) return;
        timeline_.outside_before[node].push_back(entered_[id]);
        uses_of_import_[id].push_back(node);
    }

    void include(NodeSet& set, uint32_t node) const {
        set.merge(timeline_.before[node]);
        set.insert(node);
    }

    // Adds a node for the part of a command that runs in one stage.
    uint32_t add_work(Node node, NodeSet before) {
        QueueProgress& queue = queues_[node.queue];
        const uint32_t id = add(node, std::move(before));
        for_each_stage(node.stage, [&](size_t s) { include(queue.reached[s], id); });
        include(queue.everything, id);
        return id;
    }

    NodeSet required(QueueIndex queue, StageMask stages) const {
        NodeSet before;
        for_each_stage(stages, [&](size_t s) { before.merge(queues_[queue].required[s]); });
        return before;
    }

    // Adds the nodes of one vkCmdPipelineBarrier2 call. No barrier waits for another barrier of the same
    // call.
    void barriers(QueueIndex queue_index, const std::vector<BarrierDecl>& all, const RecordedStep& step = {},
                  bool is_before = true) {
        QueueProgress& queue = queues_[queue_index];
        std::vector<const BarrierDecl*> batch;
        for (const BarrierDecl& barrier : all)
            if (step.has(barrier, is_before)) batch.push_back(&barrier);
        std::vector<uint32_t> added;
        for (const BarrierDecl* recorded : batch) {
            const BarrierDecl& barrier = *recorded;
            NodeSet before;
            for_each_stage(source_scope(barrier.src.stages),
                           [&](size_t s) { before.merge(queue.reached[s]); });
            Node node;
            node.kind = NodeKind::barrier;
            node.queue = queue_index;
            node.barrier = &barrier;
            added.push_back(add(node, std::move(before)));
            touch_import(added.back(), barrier.resource);
        }
        for (size_t i = 0; i < batch.size(); ++i) {
            for_each_stage(destination_scope(batch[i]->dst.stages), [&](size_t s) {
                include(queue.required[s], added[i]);
                include(queue.reached[s], added[i]);
            });
            include(queue.everything, added[i]);
        }
    }

    void prologue() {
        const ProloguePlan& prologue = plan_.barriers.prologue;
        barriers(kGraphicsQueue, prologue.before);
        for (const ResourceId id : prologue.cleared) {
            const ResourceDecl& decl = plan_.graph.resources[id];
            const AccessState state = clear_state(decl);
            Node node;
            node.kind = NodeKind::clear;
            node.stage = drawn_stage(state.stages, choice_ + id);
            node.resource = id;
            add_work(node, required(kGraphicsQueue, node.stage));
        }
        barriers(kGraphicsQueue, prologue.after);
        // All other queues wait for the prologue before their first frame. On queue 0, barriers order the
        // prologue.
        Node node;
        node.kind = NodeKind::signal;
        const uint32_t signal = add(node, queues_[0].everything);
        for (QueueIndex q(1); q < queues_.size(); ++q) add_wait(q, signal);
    }

    void batch(uint32_t index) {
        const Batch& batch = plan_.submissions.batches[index];
        for (const QueueWait& wait : batch.waits) {
            const std::vector<uint32_t>& signals = wait.previous_frame ? previous_signals_ : signals_;
            if (wait.batch < signals.size() && signals[wait.batch] != kNoNode)
                add_wait(batch.queue, signals[wait.batch]);
            if (wait.previous_frame && plan_.submissions.batches[wait.batch].epilogue)
                add_wait(batch.queue, owners_signal_);
        }
        const std::vector<RecordedStep> steps = recorded_steps(plan_, batch, frame_, resting_, rounds_);
        for (size_t i = 0; i < steps.size(); ++i) {
            const PassStep& step = plan_.barriers.steps[steps[i].position];
            const bool last = i + 1 == steps.size();
            barriers(batch.queue, step.barriers, steps[i], true);
            if (steps[i].runs)
                pass(batch.queue, steps[i].position,
                     !last && plan_.barriers.steps[steps[i + 1].position].merges_render_pass);
            barriers(batch.queue, step.after, steps[i], false);
        }
        if (batch.epilogue) barriers(batch.queue, plan_.barriers.epilogue);
        Node node;
        node.kind = NodeKind::signal;
        node.queue = batch.queue;
        signals_[index] = add(node, queues_[batch.queue].everything);
    }

    void add_wait(QueueIndex queue_index, uint32_t signal) {
        QueueProgress& queue = queues_[queue_index];
        Node node;
        node.kind = NodeKind::wait;
        node.queue = queue_index;
        NodeSet before;
        include(before, signal);
        const uint32_t id = add(node, std::move(before));
        for (NodeSet& set : queue.required) include(set, id);
        for (NodeSet& set : queue.reached) include(set, id);
        include(queue.everything, id);
    }

    void pass(QueueIndex queue, Position position, bool scope_continues) {
        const PassStep& step = plan_.barriers.steps[position];
        const PassDecl& pass = plan_.graph.passes[step.pass];
        Node node;
        node.queue = queue;
        node.instance = static_cast<uint32_t>(timeline_.instances.size());
        timeline_.instances.push_back({frame_, position, scope_continues});
        StageMask reading = 0, writing = 0;
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const EffectiveUse use = effective_use(pass, step, u);
            if (use.reads) reading |= use.stages;
            if (use.writes) writing |= write_stage(use, position, u, choice_);
        }
        if (!step.merges_render_pass) {
            drawing_ = {};
            ++scope_;
        }
        // All reads of a pass happen before its first write.
        NodeSet all_read;
        std::vector<uint32_t> added;
        node.kind = NodeKind::pass_read;
        for_each_stage(reading, [&](size_t s) {
            bind(node, 1u << s);
            added.push_back(add_work(node, required_by(node)));
            include(all_read, added.back());
        });
        node.kind = NodeKind::pass_write;
        for_each_stage(writing, [&](size_t s) {
            bind(node, 1u << s);
            NodeSet before = required_by(node);
            before.merge(all_read);
            added.push_back(add_work(node, std::move(before)));
        });
        for (const uint32_t id : added) {
            for (const UseDecl& use : pass.uses) touch_import(id, use.resource);
            for (size_t kind = 0; kind < kAttachmentStages.size(); ++kind)
                if (timeline_.nodes[id].stage & kAttachmentStages[kind]) include(drawing_.done[kind], id);
        }
    }

    // Assigns the node of a part of a pass to one stage. If the stage accesses attachments, the node gets the
    // current rendering scope.
    void bind(Node& node, StageMask stage) const {
        node.stage = stage;
        const bool draws = std::any_of(kAttachmentStages.begin(), kAttachmentStages.end(),
                                       [stage](StageMask stages) { return (stages & stage) != 0; });
        node.scope = draws ? scope_ : kNoNode;
    }

    NodeSet required_by(const Node& node) const {
        NodeSet before = required(node.queue, node.stage);
        for (size_t kind = 0; kind < kAttachmentStages.size(); ++kind)
            if (node.stage & kAttachmentStages[kind]) before.merge(drawing_.done[kind]);
        return before;
    }

    // Adds the accesses of the program that owns the imported resources. These accesses happen between two
    // frames on queue 0. After them, and after the program's reads of persistent resources, a semaphore is
    // signalled. A queue that waits for the last batch of the previous frame also waits for this signal. In
    // the first frame, all other queues wait for the signal.
    void enter_imports() {
        Node node;
        node.kind = NodeKind::signal;
        NodeSet before = std::move(kept_reads_);
        kept_reads_ = {};
        for (const ResourceId import : imports_) {
            const uint32_t access = enter(import);
            if (access != kNoNode) include(before, access);
        }
        owners_signal_ = add(node, std::move(before));
        for (QueueIndex q(1); frame_ == 0 && q < queues_.size(); ++q) add_wait(q, owners_signal_);
    }

    // Adds the owner's access to one import. The owner waits for all accesses of the previous frame.
    uint32_t enter(ResourceId id) {
        const ImportState& import = *plan_.graph.resources[id].import;
        Node node;
        node.kind = NodeKind::import_enter;
        node.resource = id;
        entered_[id] = add(node, {});
        timeline_.outside_before[entered_[id]] = std::move(uses_of_import_[id]);
        uses_of_import_[id] = {entered_[id]};
        if (import.entry.stages == stage::kNone) return kNoNode;
        node.kind = NodeKind::import_access;
        node.stage = drawn_stage(import.entry.stages, choice_ + id);
        const uint32_t access = add_work(node, {});
        touch_import(access, id);
        return access;
    }

    void leave(ResourceId id) {
        const ImportState& import = *plan_.graph.resources[id].import;
        Node node;
        node.kind = NodeKind::import_leave;
        node.resource = id;
        const std::vector<uint32_t> uses = uses_of_import_[id];
        const auto look = [&](uint32_t look_node) {
            timeline_.outside_before[look_node] = uses;
            uses_of_import_[id].push_back(look_node);
        };
        // An exit state without stages means that a semaphore passes the import to a user such as the
        // display.
        if (import.exit.stages == stage::kNone) look(add(node, queues_[node.queue].everything));
        for_each_stage(import.exit.stages, [&](size_t s) {
            node.stage = 1u << s;
            look(add_work(node, required(node.queue, node.stage)));
        });
    }

    // Adds the program's reads of a persistent resource after the frame, on queue 0. Only the barriers and
    // semaphores of the plan order these reads.
    void read_kept(ResourceId id) {
        Node node;
        node.kind = NodeKind::import_leave;
        node.resource = id;
        for_each_stage(plan_.graph.resources[id].between->stages, [&](size_t s) {
            node.stage = 1u << s;
            include(kept_reads_, add_work(node, required(node.queue, node.stage)));
        });
    }

    const FramePlan& plan_;
    uint64_t choice_;
    const RestChoice& resting_;
    const RoundOrder& rounds_;
    uint32_t frame_ = 0;
    uint32_t scope_ = 0;
    Drawing drawing_;
    Timeline timeline_;
    std::vector<QueueProgress> queues_;
    std::vector<ResourceId> imports_;  // Imports that at least one live pass uses.
    std::vector<ResourceId> kept_;     // Persistent resources that the program reads between frames.
    NodeSet kept_reads_;               // The program's reads of these resources after the previous frame.
    uint32_t owners_signal_ = kNoNode;
    // Index: ResourceId. The node after which passes of this frame may use the import: from then on, the
    // import belongs to the frame and not to the program.
    std::vector<uint32_t> entered_;
    // Index: ResourceId. The nodes that used the import since it entered the frame.
    std::vector<std::vector<uint32_t>> uses_of_import_;
    std::vector<uint32_t> signals_, previous_signals_;  // Index: batch. Node of the batch's signal.
};

}  // namespace

Timeline unroll(const FramePlan& plan, uint32_t frames, uint64_t choice, const RestChoice& resting,
                const RoundOrder& rounds) {
    return Unroller(plan, choice, resting, rounds).run(frames);
}

}  // namespace weft::null
