#include "graph/report/plan_summary.h"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>

#include "graph/diagnostics/quantity_text.h"
#include "graph/plan/plan_fields.h"
#include "graph/plan/plan_names.h"
#include "graph/report/group_phrases.h"
#include "graph/report/live_phrases.h"
#include "graph/report/plan_phrases.h"
#include "graph/report/switch_phrases.h"
#include "graph/report/view_phrases.h"
#include "graph/sync/scopes.h"
#include "weft/report/memory_report.h"

namespace weft {
namespace {

using Facts = std::vector<std::string>;

// Makes a text of each field of a struct, such as "depthTest 1" or "stencilFront.readMask 255". The struct
// must contain no ids, because ids differ between plans.
class FieldFacts {
 public:
    explicit FieldFacts(std::string prefix) : prefix_(std::move(prefix)) {}

    template <class T>
    void operator()(const char* name, const T& value) {
        add(prefix_ + name, value);
    }
    Facts facts;

 private:
    template <class T>
    void add(const std::string& name, const T& value) {
        if constexpr (std::is_enum_v<T>)
            facts.push_back(name + " " + enum_name(value));
        else if constexpr (std::is_arithmetic_v<T>)
            facts.push_back(name + " " + number(static_cast<double>(value)));
        else if constexpr (std::is_same_v<T, std::optional<RectPx>>)
            value ? add(name, *value) : facts.push_back(name + " whole");
        else if constexpr (std::is_same_v<T, std::optional<CompareOp>>)
            facts.push_back(name + " " + (value ? enum_name(*value) : "none"));
        else {
            FieldFacts inner(name + ".");
            visit_fields(inner, value);
            facts.insert(facts.end(), inner.facts.begin(), inner.facts.end());
        }
    }
    static std::string number(double value) {
        std::string text = std::to_string(value);
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
        return text;
    }
    std::string prefix_;
};

// Appends the texts of the fields that differ from their default values.
template <class T>
void add_fields(const std::string& prefix, const T& value, Facts& facts) {
    FieldFacts given(prefix), standard(prefix);
    visit_fields(given, value);
    visit_fields(standard, T{});
    for (const std::string& fact : given.facts)
        if (std::find(standard.facts.begin(), standard.facts.end(), fact) == standard.facts.end())
            facts.push_back(fact);
}

std::string extent_fact(const Extent3D& e) {
    return std::to_string(e.width) + "x" + std::to_string(e.height) + "x" + std::to_string(e.depth);
}

void add_params(const ResolvedGraph& graph, const PassDecl& pass, Facts& facts) {
    for (const ParamWrite& p : pass.params) {
        std::string text = "param " + p.member + " =";
        if (p.builtin != Builtin::none) text.append(" ").append(enum_name(p.builtin));
        for (size_t i = 0; p.builtin == Builtin::none && i < p.components; ++i)
            text += " " + std::to_string(p.value.at(i));
        for (const uint32_t value : p.live) text += " " + live_name(graph, value);
        facts.push_back(std::move(text));
    }
    for (const NamedValue& p : pass.custom_params)
        facts.push_back("param " + p.name + " = " + std::to_string(p.value));
    for (const SpecValue& s : pass.spec_values)
        facts.push_back("constant " + std::to_string(s.id) + " = " + std::to_string(s.bits));
}

std::string barrier_fact(const FramePlan& plan, const BarrierDecl& b, const char* where) {
    const bool image = plan.graph.resources[b.resource].kind == ResourceKind::image;
    std::string text = std::string(where) + describe_part(plan, b.resource, b.range) + ": " +
                       describe_state(b.src, image) + " -> " + describe_state(b.dst, image) + " [" +
                       enum_name(b.reason) + "]";
    for (const ResourceId id : b.aliased_from) text += " from " + plan.graph.resources[id].name;
    if (b.src_family != b.dst_family)
        text += " family " + std::to_string(b.src_family) + " to " + std::to_string(b.dst_family);
    return text;
}

void add_step(const FramePlan& plan, PassId pass, Facts& facts) {
    const Position position = plan.schedule.position[pass];
    facts.push_back("runs on queue " + std::to_string(plan.schedule.queue[position]));
    const PassStep& step = plan.barriers.steps[position];
    if (const PassId first = continued_pass(plan, position); first != kNoId)
        facts.push_back("continues the rendering scope of " + plan.graph.passes[first].name);
    for (const BarrierDecl& b : step.barriers) facts.push_back(barrier_fact(plan, b, "barrier "));
    for (const BarrierDecl& b : step.after) facts.push_back(barrier_fact(plan, b, "barrier after the pass "));
    for (const AttachmentOps& ops : step.attachments)
        facts.push_back("attach " + plan.graph.passes[pass].uses[ops.use].port + ": load " +
                        enum_name(ops.load) + ", store " + enum_name(ops.store));
}

void sort_out(Facts& facts) {
    Facts unique;
    for (std::string& fact : facts)
        if (std::find(unique.begin(), unique.end(), fact) == unique.end()) unique.push_back(std::move(fact));
    facts = std::move(unique);
}

}  // namespace

std::vector<std::string> summarize_pass(const FramePlan& plan, PassId id) {
    const PassDecl& pass = plan.graph.passes[id];
    Facts facts{"type " + pass.type};
    if (!pass.shader.empty()) facts.push_back("shader " + pass.shader);
    if (group_of(plan, id) != nullptr)
        facts.push_back(describe_round(plan, id));
    else if (pass.rest_unit != kNoId)
        facts.emplace_back("rests");
    if (pass.switch_id != kNoId)
        facts.push_back("runs while " + describe_combinations(plan.graph, pass.runs_in));
    if (!plan.live.live_passes[id]) facts.push_back("culled: " + plan.live.details[id]);
    if (pass.kind == PassKind::compute)
        facts.push_back("groups " + extent_fact({pass.groups[0], pass.groups[1], pass.groups[2]}));
    for (const LiveCount& count : pass.live_groups)
        if (count.value != kNoId) facts.push_back("groups follow " + live_name(plan.graph, count.value));
    if (pass.kind == PassKind::raster || pass.kind == PassKind::fullscreen)
        facts.push_back("render extent " + extent_fact(pass.render_extent));
    if (const std::string views = describe_lowering(pass); !views.empty()) facts.push_back("views " + views);
    for (const std::string& list : pass.draw_lists)
        facts.push_back("draws " + list + " as seen by " + view_range(pass));
    if (pass.vertices > 0)
        facts.push_back("draws " + std::to_string(pass.vertices) + " vertices x " +
                        std::to_string(pass.instances) + " as seen by " + view_range(pass));
    if (pass.most_draws > 0)
        facts.push_back("executes " + std::string(pass.draw_count_use == kNoId ? "" : "up to ") +
                        count_text(pass.most_draws, "draw command"));
    add_fields("state ", pass.state, facts);
    add_params(plan.graph, pass, facts);
    for (const UseDecl& use : pass.uses) {
        facts.push_back(std::string(use.is_output ? "out " : "in ") + use.port + " = " +
                        describe_part(plan, use.resource, use.range) +
                        (use.each == EachPart::none ? "" : std::string(", each ") + enum_name(use.each)) +
                        " (" + access_name(use.access) + (use.wakes ? ")" : ", does not wake the pass)"));
        add_fields("sampler of " + use.port + " ", use.sampler, facts);
    }
    if (plan.live.live_passes[id]) add_step(plan, id, facts);
    sort_out(facts);
    return facts;
}

std::vector<std::string> summarize_group(const FramePlan& plan, uint32_t group) {
    return {describe_group(plan.graph.groups[group])};
}

std::vector<std::string> summarize_resource(const FramePlan& plan, ResourceId id) {
    const ResourceDecl& r = plan.graph.resources[id];
    Facts facts{std::string(enum_name(r.lifetime)) + " " + enum_name(r.kind)};
    if (r.textures > 0) {
        facts.push_back("table of " + count_text(r.textures, "texture"));
        for (uint32_t i = 0; i < r.texture_files.size(); ++i)
            facts.push_back("texture " + std::to_string(i) + " from the file " + r.texture_files[i].name);
    } else if (r.kind == ResourceKind::image) {
        facts.push_back("format " + std::string(format_info(r.format).name));
        facts.push_back("extent " + extent_fact(r.extent));
        if (r.area != kNoId) facts.push_back("area " + describe_area(plan.graph, r));
        facts.push_back(count_text(r.mips, "mip") + ", " + count_text(r.layers, "layer") + ", " +
                        count_text(r.samples, "sample") + ", " + enum_name(r.image_kind));
    }
    if (r.history > 0) facts.push_back("keeps " + count_text(r.history, "earlier frame"));
    if (!plan.live.live_resources[id]) facts.push_back("unused");
    if (plan.live.retained[id]) facts.push_back("retained for another tier");
    if (const uint64_t bytes = placed_bytes(plan, id); bytes > 0)
        facts.push_back("needs " + bytes_text(bytes) + " of memory");
    const LifetimeSpan& span = plan.lifetimes.spans[id];
    if (span.first <= span.last)
        facts.push_back("alive from " + plan.graph.passes[plan.schedule.order[span.first]].name + " to " +
                        plan.graph.passes[plan.schedule.order[span.last]].name);
    return facts;
}

}  // namespace weft
