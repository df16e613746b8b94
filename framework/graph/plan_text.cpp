#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "graph/plan_dump.h"
#include "graph/plan_names.h"

namespace weft {
namespace {

std::string bytes_text(uint64_t bytes) {
    std::array<char, 48> text{};
    if (bytes < 10240)
        std::snprintf(text.data(), text.size(), "%llu B", static_cast<unsigned long long>(bytes));
    else if (bytes < 10485760)
        std::snprintf(text.data(), text.size(), "%.1f KiB", static_cast<double>(bytes) / 1024.0);
    else
        std::snprintf(text.data(), text.size(), "%.1f MiB", static_cast<double>(bytes) / 1048576.0);
    return text.data();
}

std::string percent_text(uint64_t part, uint64_t whole) {
    std::array<char, 48> text{};
    const double percent = whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    std::snprintf(text.data(), text.size(), "%.1f %%", percent);
    return text.data();
}

class PlanText {
 public:
    explicit PlanText(const FramePlan& plan) : plan_(plan) {}

    std::string write() {
        header();
        for (uint32_t p = 0; p < plan_.barriers.steps.size(); ++p) step(p);
        if (!plan_.barriers.epilogue.empty()) {
            text_ += "\nafter the last pass\n";
            for (const BarrierDecl& b : plan_.barriers.epilogue) barrier(b);
        }
        memory();
        culled();
        return std::move(text_);
    }

 private:
    const std::string& pass(PassId id) const { return plan_.graph.passes[id].name; }
    const std::string& resource(ResourceId id) const { return plan_.graph.resources[id].name; }

    // "name", with the range where it is not the whole resource.
    std::string part(ResourceId id, const SubresourceRange& range) const {
        return resource(id) + (range == plan_.graph.resources[id].whole() ? "" : range_text(range));
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
        text_ += "hash   " + plan_.hash + "\n";
        text_ += "passes " + std::to_string(schedule.order.size()) + " of " +
                 std::to_string(plan_.graph.passes.size()) + ", barriers " +
                 std::to_string(plan_.barriers.emitted) + "\n";
        text_ += "order  " + schedule.chosen + "; candidates:";
        for (const ScheduleCandidate& c : schedule.candidates)
            text_ += " " + c.name + " (" + bytes_text(c.peak_live_bytes) + ", " +
                     std::to_string(c.barrier_batches) + " batches)";
        text_ += "\n";
    }

    void step(uint32_t position) {
        const PassStep& s = plan_.barriers.steps[position];
        const PassDecl& decl = plan_.graph.passes[s.pass];
        text_.append("\n").append(std::to_string(position)).append("  ").append(decl.name);
        text_.append("  (").append(decl.type);
        if (!decl.shader.empty()) text_.append(" ").append(decl.shader);
        text_.append(")\n");
        for (const BarrierDecl& b : s.barriers) barrier(b);
        for (const AttachmentOps& ops : s.attachments) {
            const UseDecl& use = decl.uses[ops.use];
            text_ += "    attach " + part(use.resource, use.range) + ": load " + enum_name(ops.load) +
                     ", store " + enum_name(ops.store) + "\n";
        }
        for (const UseDecl& use : decl.uses)
            text_ += std::string("    ") + (use.is_output ? "out " : "in  ") + use.port + " = " +
                     part(use.resource, use.range) + " (" + access_name(use.access) + ")\n";
    }

    void barrier(const BarrierDecl& b) {
        const bool image = plan_.graph.resources[b.resource].kind == ResourceKind::image;
        text_ += "    barrier " + part(b.resource, b.range) + ": " + state(b.src, image) + " -> " +
                 state(b.dst, image) + "  [" + enum_name(b.reason);
        if (!b.hand_over_from.empty()) {
            text_ += " from";
            for (const ResourceId id : b.hand_over_from) text_ += " " + resource(id);
        }
        if (b.from != kNoId) text_ += ", after " + pass(b.from);
        if (b.from_previous_frame) text_ += " of the frame before";
        text_ += "]\n";
    }

    void memory() {
        const MemoryPlan& m = plan_.memory;
        text_ +=
            "\nmemory\n    sum " + bytes_text(m.sum_bytes) + ", peak live " + bytes_text(m.peak_live_bytes);
        if (m.peak_position < plan_.schedule.order.size())
            text_ += " at " + pass(plan_.schedule.order[m.peak_position]);
        const uint64_t gap = m.heap_bytes > m.peak_live_bytes ? m.heap_bytes - m.peak_live_bytes : 0;
        text_ +=
            ", heaps " + bytes_text(m.heap_bytes) + ", gap " + percent_text(gap, m.peak_live_bytes) + "\n";
        for (uint32_t heap = 0; heap < m.heaps.size(); ++heap) {
            text_ += "    heap " + std::to_string(heap) + (m.heaps[heap].buffers ? " (buffers) " : " ") +
                     bytes_text(m.heaps[heap].size_bytes) + "\n";
            for (const Placement& p : m.placements)
                if (p.heap == heap) placement(p);
        }
    }

    void placement(const Placement& p) {
        const LifetimeSpan& span = plan_.lifetimes.spans[p.resource];
        text_ += "        " + std::to_string(p.offset_bytes) + " + " + std::to_string(p.size_bytes) + "  " +
                 resource(p.resource) + "  [" + std::to_string(span.first) + ".." +
                 std::to_string(span.last) + "]";
        std::string owners;
        for (const HandOver& h : plan_.memory.hand_overs)
            if (h.to == p.resource && h.from != h.to)
                owners += (owners.empty() ? "  after " : ", ") + resource(h.from) +
                          (h.wrap ? " of the frame before" : "");
        text_ += owners + "\n";
    }

    void culled() {
        bool first = true;
        for (PassId id = 0; id < plan_.graph.passes.size(); ++id) {
            if (plan_.live.live_passes[id]) continue;
            if (first) text_ += "\nculled\n";
            first = false;
            text_ += "    " + pass(id) + ": " + plan_.live.details[id] + "\n";
        }
    }

    const FramePlan& plan_;
    std::string text_;
};

}  // namespace

std::string plan_to_text(const FramePlan& plan) {
    return PlanText(plan).write();
}

}  // namespace weft
