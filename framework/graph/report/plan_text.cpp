#include <string>

#include "graph/diagnostics/diagnostic_text.h"
#include "graph/diagnostics/quantity_text.h"
#include "graph/plan/plan_names.h"
#include "graph/report/group_phrases.h"
#include "graph/report/live_phrases.h"
#include "graph/report/switch_phrases.h"
#include "graph/report/view_phrases.h"
#include "graph/sync/scopes.h"
#include "weft/compile.h"
#include "weft/report/memory_report.h"
#include "weft/report/plan_dump.h"

namespace weft {
namespace {

class PlanText {
 public:
    PlanText(const FramePlan& plan, const DeviceProfile* profile) : plan_(plan), profile_(profile) {}

    std::string write() {
        header();
        prologue();
        for (Position p(0); p < plan_.barriers.steps.size(); ++p) step(p);
        if (!plan_.barriers.epilogue.empty()) {
            text_ += "\nafter the last pass\n";
            for (const BarrierDecl& b : plan_.barriers.epilogue) barrier(b);
        }
        text_ += "\nmemory\n" + memory_report(plan_, profile_);
        culled();
        return std::move(text_);
    }

 private:
    const std::string& pass(PassId id) const { return plan_.graph.passes[id].name; }
    const std::string& resource(ResourceId id) const { return plan_.graph.resources[id].name; }

    // Returns the name of the resource. A range that is not the whole resource is appended, such as
    // "bloom.mip(2)".
    std::string part(ResourceId id, const SubresourceRange& range) const {
        return resource(id) + (range == plan_.graph.resources[id].whole()
                                   ? ""
                                   : range_text(plan_.graph.resources[id], range));
    }

    // Returns the number of textures of a table of textures, such as ", 12 textures". Returns an empty text
    // for all other resources.
    std::string table(ResourceId id) const {
        const uint32_t textures = plan_.graph.resources[id].textures;
        return textures > 0 ? ", " + count_text(textures, "texture") : "";
    }

    std::string state(const AccessState& s, bool image) const {
        std::string text = stages_text(s.stages);
        text.append(" ").append(access_text(s.access));
        if (image) text.append(" ").append(layout_text(s.layout));
        return text;
    }

    void header() {
        const Schedule& schedule = plan_.schedule;
        text_ += "plan of " + plan_.graph.name + ", " + std::to_string(plan_.graph.output_extent.width) +
                 "x" + std::to_string(plan_.graph.output_extent.height) + "\n";
        text_ += "hash   " + plan_hash(plan_) + "\n";
        text_ += "passes " + std::to_string(schedule.order.size()) + " of " +
                 std::to_string(plan_.graph.passes.size()) + ", barriers " +
                 std::to_string(plan_.barriers.emitted) + "\n";
        if (schedule.queues.size() > 1) queues();
        for (const GraphParam& param : plan_.graph.params)
            text_ += "param  " + param.name + " = " + number_text(param.value) +
                     ", cost of a change: " + enum_name(param.cost) + "\n";
        for (const std::string& area : list_areas(plan_.graph)) text_ += "area   " + area + "\n";
        for (const GroupDecl& group : plan_.graph.groups)
            text_ += "group  " + group.name + ": " + describe_group(group) + "\n";
        for (uint32_t s = 0; s < plan_.graph.switches.size(); ++s)
            text_ +=
                "switch " + plan_.graph.switches[s].param + ": passes " + switched_passes(plan_, s) + "\n";
        text_ += "order  " + schedule.chosen + "; candidates:";
        for (const ScheduleCandidate& c : schedule.candidates)
            text_ += " " + c.name + " (" + bytes_text(c.peak_live_bytes) + ", " +
                     std::to_string(c.barrier_batches) + " barrier batches)";
        text_ += "\n";
    }

    void queues() {
        text_ += "queues";
        for (uint32_t q = 0; q < plan_.schedule.queues.size(); ++q)
            text_ += (q == 0 ? " " : ", ") + std::to_string(q) + " " +
                     enum_name(plan_.schedule.queues[q].kind) + " of family " +
                     std::to_string(plan_.schedule.queues[q].family);
        text_ += "; " + count_text(plan_.submissions.batches.size(), "submission") + ", " +
                 count_text(plan_.submissions.dependencies.size(), "wait") + "\n";
    }

    void prologue() {
        const ProloguePlan& p = plan_.barriers.prologue;
        if (p.cleared.empty()) return;
        text_ += "\nonce, before the first frame\n";
        for (const BarrierDecl& b : p.before) barrier(b);
        for (const ResourceId id : p.cleared) text_ += "    clear " + resource(id) + "\n";
        for (const BarrierDecl& b : p.after) barrier(b);
    }

    // If a batch begins at this position, writes the semaphore waits of the batch.
    void waits(Position position) {
        for (const Batch& batch : plan_.submissions.batches) {
            if (batch.positions.empty() || batch.positions.front() != position) continue;
            for (const QueueWait& wait : batch.waits) {
                const Batch& other = plan_.submissions.batches[wait.batch];
                text_ += "    wait for queue " + std::to_string(other.queue) +
                         (wait.previous_frame ? " of the previous frame" : "");
                if (wait.dependency != kNoId) {
                    const QueueDependency& d = plan_.submissions.dependencies[wait.dependency];
                    if (d.from < plan_.schedule.order.size())
                        text_ += ", pass " + pass(plan_.schedule.order[d.from]);
                    if (d.resource != kNoId) text_ += ", because of " + resource(d.resource);
                }
                text_ += "\n";
            }
        }
    }

    void step(Position position) {
        const PassStep& s = plan_.barriers.steps[position];
        const PassDecl& decl = plan_.graph.passes[s.pass];
        text_.append("\n").append(std::to_string(position)).append("  ").append(decl.name);
        text_.append("  (").append(decl.type);
        if (!decl.shader.empty()) text_.append(" ").append(decl.shader);
        text_.append(")");
        if (plan_.schedule.queues.size() > 1)
            text_ += "  on queue " + std::to_string(plan_.schedule.queue[position]);
        text_ += "\n";
        waits(position);
        if (const PassId first = continued_pass(plan_, position); first != kNoId)
            text_ += "    continues the rendering scope of pass " + pass(first) + "\n";
        if (const std::string views = describe_lowering(decl); !views.empty())
            text_ += "    views " + views + "\n";
        if (decl.rest_unit != kNoId) text_ += "    " + unit(s.pass) + "\n";
        if (decl.switch_id != kNoId)
            text_ += "    runs while " + describe_combinations(plan_.graph, decl.runs_in) + "\n";
        if (decl.carries)
            text_ += "    Weft adds this pass, because a pass needs the content of the last frame in " +
                     resource(decl.uses.back().resource) + "\n";
        for (const BarrierDecl& b : s.barriers) barrier(b);
        for (const AttachmentOps& ops : s.attachments) {
            const UseDecl& use = decl.uses[ops.use];
            text_ += "    attach " + part(use.resource, use.range) + ": load " + enum_name(ops.load) +
                     ", store " + enum_name(ops.store) + "\n";
        }
        for (const UseDecl& use : decl.uses)
            text_ += std::string("    ") + (use.is_output ? "out " : "in  ") + use.port + " = " +
                     part(use.resource, use.range) + " (" + access_name(use.access) + table(use.resource) +
                     ")" +
                     (use.used_in == kEveryCombination
                          ? ""
                          : " while " + describe_combinations(plan_.graph, use.used_in)) +
                     "\n";
        for (const BarrierDecl& b : s.after) {
            text_ += "    after the pass";
            barrier(b);
        }
    }

    // Returns the number of the rest unit of the pass, and the names of the live passes of this unit. In each
    // frame, either all passes of a rest unit run, or none of them.
    std::string unit(PassId of) const {
        const uint32_t unit = plan_.graph.passes[of].rest_unit;
        std::string names;
        for (const PassId id : plan_.schedule.order)
            if (plan_.graph.passes[id].rest_unit == unit) names += (names.empty() ? "" : ", ") + pass(id);
        const std::string round = describe_round(plan_, of);
        return (round.empty() ? "rest " : round + ", ") + "unit " + std::to_string(unit) + ": " + names;
    }

    void barrier(const BarrierDecl& b) {
        const bool image = plan_.graph.resources[b.resource].kind == ResourceKind::image;
        text_ += "    barrier " + part(b.resource, b.range) + ": " + state(b.src, image) + " -> " +
                 state(b.dst, image) + "  [" + enum_name(b.reason);
        if (!b.aliased_from.empty()) {
            text_ += " from";
            for (const ResourceId id : b.aliased_from) text_ += " " + resource(id);
        }
        if (b.from != kNoId) text_ += ", after " + pass(b.from);
        if (b.from_previous_frame) text_ += " of the previous frame";
        if (b.if_pass_runs) text_ += "; only if the pass runs";
        if (b.src_family != b.dst_family)
            text_ += ", family " + std::to_string(b.src_family) + " to " + std::to_string(b.dst_family);
        text_ += "]\n";
    }

    void culled() {
        bool first = true;
        for (PassId id(0); id < plan_.graph.passes.size(); ++id) {
            if (plan_.live.live_passes[id]) continue;
            if (first) text_ += "\nculled\n";
            first = false;
            text_ += "    " + pass(id) + ": " + plan_.live.details[id] + "\n";
        }
    }

    const FramePlan& plan_;
    const DeviceProfile* profile_;
    std::string text_;
};

}  // namespace

std::string plan_to_text(const FramePlan& plan, const DeviceProfile* profile) {
    return printable(PlanText(plan, profile).write());
}

}  // namespace weft
