#include "graph/resolve/live/follow_areas.h"

#include <algorithm>
#include <string_view>

#include "graph/parse/module_scope.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/live/check_areas.h"
#include "graph/resolve/live/live_table.h"

namespace weft {
namespace {

struct AreaBuiltin {
    std::string_view suffix;
    Builtin builtin;
};
constexpr std::array kAreaBuiltins{AreaBuiltin{"Size", Builtin::area_size},
                                   AreaBuiltin{"Uv", Builtin::area_uv},
                                   AreaBuiltin{"UvMost", Builtin::area_uv_most}};

// Finds the numbers of one pass that change with live scales. A live scale is a parameter that multiplies a
// size and may change in every frame.
class PassFollower {
 public:
    PassFollower(const Declared& declared, const VersionedGraph& versioned, PassId pass, ResolvedGraph& graph,
                 LiveTable& table, Reporter& reporter)
        : declared_(declared),
          draft_(declared.expansion.passes[pass]),
          bound_(versioned.passes[pass]),
          graph_(graph),
          pass_(graph.passes[pass]),
          table_(table),
          evaluator_(declared.evaluator(pass, versioned.suspects, reporter)) {}

    void run() {
        find_area();
        if (pass_.kind == PassKind::compute && draft_.shader && !draft_.desc->indirect) follow_groups();
        follow_rects();
        follow_members(pass_.params, pass_.variants.empty() ? pass_.runs_in : combinations_of(0));
        for (size_t i = 0; i < pass_.variants.size(); ++i)
            follow_members(pass_.variants[i].params, combinations_of(i));
    }

 private:
    // A pass that draws has the area of its attachments, which all have the same area. A compute pass has the
    // area of its first output with a live size.
    void find_area() {
        for (const AttachmentDecl& color : pass_.colors) take_area(pass_.uses[color.use]);
        if (pass_.depth) take_area(pass_.uses[pass_.depth->use]);
        if (pass_.kind != PassKind::compute) return;
        for (const UseDecl& use : pass_.uses)
            if (use.is_output) take_area(use);
    }

    void take_area(const UseDecl& use) {
        if (pass_.area.image == kNoId) pass_.area = area_of(graph_, use);
    }

    void follow_groups() {
        const PassDesc& desc = *draft_.desc;
        if (!desc.groups.empty()) return follow_counts(desc.groups, false);
        if (!desc.threads.empty()) return follow_counts(desc.threads, true);
        // The outputs of the pass have the same extent, see size_dispatches(). The numbers of workgroups
        // follow from the area of the first output with a live size.
        if (pass_.area.image == kNoId) return;
        const uint32_t value = graph_.resources[pass_.area.image].area;
        for (uint32_t side = 0; side < 2; ++side)
            pass_.live_groups.push_back({value, side, pass_.area.mip, draft_.shader->local_size[side]});
        pass_.live_groups.push_back({});
    }

    // `counts` contains the expressions of the key "groups" or "threads". If `counts` is a single size, it
    // gives the counts for x and y.
    void follow_counts(const std::vector<Expr>& counts, bool threads) {
        std::vector<LiveCount> found(3);
        bool is_live = false;
        for (uint32_t i = 0; i < counts.size() && i < 3; ++i) {
            const std::optional<uint32_t> value = table_.find(counts[i], draft_.indices);
            if (!value) continue;
            is_live = true;
            found[i] = {*value, 0, kNoId, threads ? draft_.shader->local_size[i] : 1};
            if (counts.size() == 1 && is_size(counts[i]))
                found[1] = {*value, 1, kNoId, threads ? draft_.shader->local_size[1] : 1};
        }
        if (is_live) pass_.live_groups = std::move(found);
    }

    bool is_size(const Expr& expression) {
        const std::optional<ExprValue> value = evaluator_.value(expression);
        return value && value->is_size;
    }

    void follow_rects() {
        for (const StateNumberDesc& number : draft_.desc->state_numbers) {
            if (!number.rect) continue;
            if (const std::optional<uint32_t> value = table_.find(number.value, draft_.indices))
                pass_.live_sides.push_back({number.rect->scissor, number.rect->side, *value});
        }
        if (draft_.desc->view_target != ViewTarget::rects) return;
        const ViewListDesc* list = declared_.values.views.at(draft_.desc->view).desc;
        if (list == nullptr || !list->rect) return;
        for (uint32_t side = 0; side < 4; ++side)
            if (const std::optional<uint32_t> value = table_.find((*list->rect)[side], draft_.indices))
                for (const bool scissor : {false, true}) pass_.live_sides.push_back({scissor, side, *value});
    }

    // Returns the combinations of the switches in which a variant runs.
    [[nodiscard]] CombinationSet combinations_of(size_t variant) const {
        return static_cast<CombinationSet>(pass_.variants[variant].combinations & pass_.runs_in);
    }

    // `combinations`: the combinations of the switches in which the pass has these values.
    void follow_members(std::vector<ParamWrite>& writes, CombinationSet combinations) {
        for (ParamWrite& write : writes)
            if (write.builtin == Builtin::none) follow_member(write, combinations);
    }

    void follow_member(ParamWrite& write, CombinationSet combinations) {
        const std::vector<ParamValueDesc>& given = draft_.desc->params;
        const auto param = std::ranges::find(given, write.member, &ParamValueDesc::name);
        if (param != given.end()) return follow_components(param->components, write);
        const GraphDesc& graph = declared_.input.graph;
        if (draft_.indices.contains(write.member)) return;
        const std::string full = name_in_module(graph, draft_.desc->module, write.member);
        if (graph.params.contains(full) || graph.consts.contains(full)) {
            Expr name;
            name.postfix.push_back({ExprOp::name, 0, full, {}});
            return follow_components({name}, write);
        }
        for (const AreaBuiltin& builtin : kAreaBuiltins)
            if (follow_port(builtin, write, combinations)) return;
    }

    void follow_components(const std::vector<Expr>& components, ParamWrite& write) {
        const auto is_live = [&](const Expr& e) { return table_.find(e, draft_.indices).has_value(); };
        const auto is_known = [&](const Expr& e) { return table_.is_known(e, draft_.indices); };
        if (!std::ranges::all_of(components, is_known) || std::ranges::none_of(components, is_live)) return;
        for (const Expr& component : components) {
            const uint32_t value = table_.entry(component, draft_.indices);
            if (!is_size(component)) {
                write.live.push_back(value);
                continue;
            }
            write.live.push_back(table_.side_of(value, ExprOp::select_x));
            write.live.push_back(table_.side_of(value, ExprOp::select_y));
        }
        write.builtin = Builtin::live;
        write.value = {};
    }

    // Returns true if the name of the member consists of the name of a port and the suffix of `builtin`. If
    // the image of this port has a live size, also records that the value of the member follows the area of
    // this image.
    bool follow_port(const AreaBuiltin& builtin, ParamWrite& write, CombinationSet combinations) {
        std::string_view name = write.member;
        if (!name.ends_with(builtin.suffix)) return false;
        name.remove_suffix(builtin.suffix.size());
        const auto use = std::ranges::find_if(
            bound_.uses, [&](const UseDecl& u) { return u.port == name && (u.used_in & combinations) != 0; });
        if (use == bound_.uses.end()) return false;
        if (graph_.resources[use->resource].area == kNoId) return true;
        write.builtin = builtin.builtin;
        write.use = static_cast<uint32_t>(use - bound_.uses.begin());
        write.value = {};
        return true;
    }

    const Declared& declared_;
    const PassDraft& draft_;
    const BoundPass& bound_;
    ResolvedGraph& graph_;
    PassDecl& pass_;
    LiveTable& table_;
    Evaluator evaluator_;
};

void follow_images(const Declared& declared, const Suspects& suspects, ResolvedGraph& graph, LiveTable& table,
                   Reporter& reporter) {
    const GraphDesc& described = declared.input.graph;
    for (ResourceId id(0); id < graph.resources.size(); ++id) {
        const ResourceDesc* desc = declared.shapes.origins[id].desc;
        if (desc == nullptr || desc->is_buffer || suspects.shapes[id]) continue;
        const bool usual = desc->size.empty();
        Expr render;
        render.postfix.push_back({ExprOp::name, 0, render_size_name(described, desc->name), {}});
        const bool has_render = described.sizes.contains(render.postfix.front().name);
        if (usual && (!has_render || !desc->file.name.empty())) continue;
        const std::optional<uint32_t> area = table.find(usual ? render : desc->size, {});
        if (!area) continue;
        graph.resources[id].area = *area;
        if (graph.resources[id].age == 0) check_live_image(graph.resources[id], *desc, reporter);
    }
}

// Reports a pass that draws views without rectangles of their own to attachments with a live size. The grid
// for such views divides the whole attachments and not only their area.
void check_grid(const Declared& declared, PassId id, const ResolvedGraph& graph, PassReporter& report) {
    const PassDesc& desc = *declared.expansion.passes[id].desc;
    if (desc.view_target != ViewTarget::rects || graph.passes[id].area.image == kNoId) return;
    const ViewListDesc* list = declared.values.views.at(desc.view).desc;
    if (list != nullptr && list->rect) return;
    add_help(report.error(id, desc.view_loc, "W236",
                          "pass " + quote(desc.name) + " draws views to a grid in " +
                              quote(graph.resources[graph.passes[id].area.image].name) +
                              ", which has a live size"),
             "give this image a size without a scale, or give the list of views a \"rect\"");
}

}  // namespace

ResolvedGraph follow_areas(const Declared& declared, const VersionedGraph& versioned, Suspects suspects,
                           ResolvedGraph graph, Reporter& reporter) {
    if (declared.values.scales.empty()) return graph;
    LiveTable table(declared, reporter);
    follow_images(declared, suspects, graph, table, reporter);
    PassReporter report(declared.shapes, declared.expansion, suspects, reporter);
    for (PassId id(0); id < graph.passes.size(); ++id) {
        if (suspects.passes[id]) continue;
        PassFollower(declared, versioned, id, graph, table, reporter).run();
        check_pass_areas(declared, versioned, id, graph, report);
        check_grid(declared, id, graph, report);
    }
    graph.live_values = table.take();
    return graph;
}

}  // namespace weft
