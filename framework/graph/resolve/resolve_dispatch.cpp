// How many workgroups a compute pass runs: ceil(extent of its output range / local size), or what it says.
// So are the commands that raster passes draw by. Copies are checked here too: both ends must have the same
// shape.
#include <algorithm>
#include <cmath>
#include <set>

#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

constexpr double kMaxGroups = 65535;  // the least that Vulkan promises

// The bits of a float are no number of anything.
bool holds_floats(const ResolveState& state, ResourceId resource) {
    const ResourceDesc* desc = state.resources[resource].desc;
    if (desc == nullptr || !desc->is_buffer) return false;
    return desc->element == "f32" || desc->element == "mat4" || desc->element.starts_with("vec");
}

class DispatchStep {
 public:
    DispatchStep(ResolveState& state, PassId pass)
        : state_(state), pass_(pass), work_(state.passes[pass]), decl_(state.graph.passes[pass]) {}

    void run() {
        check_local_size();
        const PassDesc& desc = *work_.desc;
        if (desc.indirect) return count_indirectly();
        std::optional<std::array<double, 3>> groups;
        if (!desc.groups.empty() && !desc.threads.empty()) {
            error(desc.groups.front().loc,
                  "pass " + quoted(decl_.name) + " gives both \"groups\" and \"threads\"",
                  "leave one of them out");
            return;
        }
        if (!desc.groups.empty()) {
            groups = evaluate_sides(desc.groups);
        } else if (!desc.threads.empty()) {
            groups = in_groups(evaluate_sides(desc.threads));
        } else {
            groups = in_groups(output_threads());
        }
        if (groups) store(*groups);
    }

 private:
    void error(SourceLoc loc, const std::string& message, const std::string& help) {
        add_help(state_.pass_error(pass_, loc, "W114", message), help);
    }

    void count_indirectly() {
        constexpr uint64_t kCountsBytes = 12;
        const auto port = std::ranges::find_if(work_.ports, &PortWork::is_indirect);
        if (port == work_.ports.end()) return;  // reported
        decl_.indirect_use = static_cast<uint32_t>(port - work_.ports.begin());
        const UseDecl& use = decl_.uses[decl_.indirect_use];
        const ResourceDecl& resource = state_.graph.resources[use.resource];
        const bool buffer = resource.kind == ResourceKind::buffer;
        const bool floats = holds_floats(state_, use.resource);
        if (state_.resources[use.resource].suspect_shape ||
            (buffer && !floats && resource.size_bytes >= kCountsBytes))
            return;
        error(use.loc,
              "pass " + quoted(decl_.name) + " reads its numbers of workgroups from " +
                  quoted(resource.name) +
                  (!buffer  ? ", which is an image"
                   : floats ? ", whose elements are floats"
                            : ", which is too small"),
              "it takes a buffer of three words: { \"buffer\": \"u32\", \"count\": 3 }");
    }

    void check_local_size() {
        const auto& local = work_.shader->local_size;
        const uint64_t invocations = uint64_t{local[0]} * local[1] * local[2];
        const uint32_t limit = state_.input.profile.max_workgroup_invocations;
        if (invocations <= limit) return;
        error(work_.desc->shader_loc,
              "shader " + quoted(work_.desc->shader) + " has workgroups of " + std::to_string(invocations) +
                  " invocations; the device offers " + std::to_string(limit),
              "make local_size smaller");
    }

    // A number is (n, 1, 1), a size (x, y, 1), an array its items.
    std::optional<std::array<double, 3>> evaluate_sides(const std::vector<Expr>& sides) {
        std::array<double, 3> result{1, 1, 1};
        for (size_t i = 0; i < std::min<size_t>(3, sides.size()); ++i) {
            const std::optional<ExprValue> value = state_.evaluate_here(sides[i]);
            if (!value) return std::nullopt;
            if (value->is_size && sides.size() > 1) {
                error(sides[i].loc,
                      "each item of the dispatch size of " + quoted(decl_.name) + " must be a number",
                      "use .x or .y of the size");
                return std::nullopt;
            }
            result[i] = value->x;
            if (value->is_size) result[1] = value->y;
        }
        return result;
    }

    std::optional<std::array<double, 3>> in_groups(std::optional<std::array<double, 3>> threads) const {
        if (!threads) return std::nullopt;
        for (size_t i = 0; i < 3; ++i) (*threads)[i] = std::ceil((*threads)[i] / work_.shader->local_size[i]);
        return threads;
    }

    std::optional<std::array<double, 3>> output_threads() {
        std::set<std::array<uint32_t, 3>> extents;
        std::string listed;
        for (const UseDecl& use : decl_.uses) {
            if (!use.is_output) continue;
            if (state_.resources[use.resource].suspect_shape) return std::nullopt;
            if (state_.graph.resources[use.resource].kind == ResourceKind::buffer) continue;
            const Extent3D e = use_extent(state_, use);
            if (extents.insert({e.width, e.height, std::max(e.depth, use.range.layers)}).second) {
                listed += (listed.empty() ? "" : ", ") + quoted(use.port) + " is " + extent_text(e);
            }
        }
        if (extents.size() == 1) {
            const auto& e = *extents.begin();
            return std::array<double, 3>{double(e[0]), double(e[1]), double(e[2])};
        }
        // A faulty pass may lack the very output that would tell.
        if (work_.faulty) return std::nullopt;
        const std::string why = extents.empty() ? "it writes no image" : "its outputs differ: " + listed;
        error(decl_.loc, "the dispatch size of pass " + quoted(decl_.name) + " is unknown: " + why,
              "say it: \"threads\": \"output\" (invocations) or \"groups\": [x, y, z] (workgroups)");
        return std::nullopt;
    }

    void store(const std::array<double, 3>& groups) {
        for (size_t i = 0; i < 3; ++i) {
            const double count = std::ceil(groups[i]);
            if (count < 1 || count > kMaxGroups) {
                const PassDesc& desc = *work_.desc;
                const SourceLoc loc = !desc.groups.empty()    ? desc.groups.front().loc
                                      : !desc.threads.empty() ? desc.threads.front().loc
                                                              : desc.loc;
                error(loc,
                      "pass " + quoted(decl_.name) + " would run " + number_text(count) +
                          " workgroups along one side",
                      "1 to 65535 are possible");
                return;
            }
            decl_.groups[i] = static_cast<uint32_t>(count);
        }
    }

    ResolveState& state_;
    PassId pass_;
    PassWork& work_;
    PassDecl& decl_;
};

// The buffer of a raster pass's draw commands: as many as its list has draws.
void find_draw_commands(ResolveState& state, PassId pass) {
    constexpr uint64_t kCommandBytes = 20;
    const PassWork& work = state.passes[pass];
    PassDecl& decl = state.graph.passes[pass];
    const auto port = std::ranges::find_if(work.ports, &PortWork::is_indirect);
    if (port == work.ports.end()) return;
    decl.draw_commands_use = static_cast<uint32_t>(port - work.ports.begin());
    const UseDecl& use = decl.uses[decl.draw_commands_use];
    const ResourceDecl& resource = state.graph.resources[use.resource];
    if (state.resources[use.resource].suspect_shape || decl.draw_lists.empty()) return;
    const std::string& list = decl.draw_lists.front();
    const uint64_t draws = state.input.imports.imports.at(list).draws;
    const bool buffer = resource.kind == ResourceKind::buffer;
    const bool floats = holds_floats(state, use.resource);
    if (buffer && !floats && resource.size_bytes >= draws * kCommandBytes) return;
    Diagnostic& d = state.pass_error(
        pass, use.loc, "W114",
        "pass " + quoted(decl.name) + " reads its draw commands from " + quoted(resource.name) +
            (floats   ? std::string(", whose elements are floats")
             : buffer ? ", which has " + std::to_string(resource.size_bytes) + " bytes; the " +
                            std::to_string(draws) + " draws of " + quoted(list) + " take " +
                            std::to_string(draws * kCommandBytes)
                      : ", which is an image"));
    add_help(
        d, "it takes a buffer of as many: { \"buffer\": \"DrawCommand\", \"count\": \"" + list + "Draws\" }");
}

std::string shape_text(const ResolveState& state, const UseDecl& use) {
    const ResourceDecl& resource = state.graph.resources[use.resource];
    if (resource.kind == ResourceKind::buffer) return std::to_string(resource.size_bytes) + " bytes";
    return extent_text(use_extent(state, use)) + ", " + std::to_string(use.range.mips) + " mips, " +
           std::to_string(use.range.layers) + " layers, " + std::string(format_info(resource.format).name);
}

bool same_shape(const ResolveState& state, const UseDecl& a, const UseDecl& b) {
    const ResourceDecl& from = state.graph.resources[a.resource];
    const ResourceDecl& to = state.graph.resources[b.resource];
    if (from.kind != to.kind) return false;
    if (from.kind == ResourceKind::buffer) return from.size_bytes == to.size_bytes;
    const FormatInfo& f = format_info(from.format);
    const FormatInfo& t = format_info(to.format);
    const bool formats =
        from.format == to.format || (f.bytes_per_texel == t.bytes_per_texel && !f.depth && !t.depth);
    return formats && use_extent(state, a) == use_extent(state, b) && a.range.mips == b.range.mips &&
           a.range.layers == b.range.layers && a.range.aspects == b.range.aspects &&
           from.samples == to.samples;
}

// What keeps an image from being stretched over another; empty: nothing.
std::string blit_fault(const ResolveState& state, const UseDecl& from, const UseDecl& to) {
    const ResourceDecl& source = state.graph.resources[from.resource];
    const ResourceDecl& target = state.graph.resources[to.resource];
    if (source.kind == ResourceKind::buffer || target.kind == ResourceKind::buffer)
        return "buffers have no texels";
    if (source.samples > 1 || target.samples > 1) return "multisampled images are resolved, not blitted";
    const NumericClass numeric = format_info(source.format).numeric;
    if (numeric != format_info(target.format).numeric) return "their numbers are of different kinds";
    if (numeric == NumericClass::depth && source.format != target.format) return "depth needs equal formats";
    const bool linear = from.sampler.filter == SamplerFilter::linear;
    if (linear && numeric != NumericClass::float_like) return "only floats can be filtered linearly";
    if (from.range.mips != 1 || to.range.mips != 1) return "a blit is of one mip to one mip";
    if (from.range.layers != to.range.layers) return "they have different numbers of layers";
    return "";
}

void check_blit(ResolveState& state, PassId pass) {
    const PassDecl& decl = state.graph.passes[pass];
    const UseDecl& from = decl.uses[0];
    const UseDecl& to = decl.uses[1];
    if (state.resources[from.resource].suspect_shape || state.resources[to.resource].suspect_shape) return;
    const std::string fault = blit_fault(state, from, to);
    if (fault.empty()) return;
    Diagnostic& d =
        state.pass_error(pass, to.loc, "W183",
                         "blit pass " + quoted(decl.name) + " can't go from " +
                             quoted(range_of(state.graph.resources[from.resource], from.range)) + " to " +
                             quoted(range_of(state.graph.resources[to.resource], to.range)) + ": " + fault);
    add_help(d,
             "pick mips and layers, set \"sampler\": { \"filter\": \"nearest\" }, or use a fullscreen pass");
}

void check_copy(ResolveState& state, PassId pass) {
    const PassDecl& decl = state.graph.passes[pass];
    if (decl.kind != PassKind::copy || state.passes[pass].faulty || decl.uses.size() != 2) return;
    if (decl.type == "blit") return check_blit(state, pass);
    const UseDecl& from = decl.uses[0];
    const UseDecl& to = decl.uses[1];
    if (state.resources[from.resource].suspect_shape || state.resources[to.resource].suspect_shape) return;
    if (same_shape(state, from, to)) return;
    Diagnostic& d = state.pass_error(pass, to.loc, "W183",
                                     "copy pass " + quoted(decl.name) + " has ends of different shape: " +
                                         shape_text(state, from) + " and " + shape_text(state, to));
    add_help(d, "give both the same size, mips, layers and bytes per texel, or use a fullscreen pass");
}

}  // namespace

void resolve_dispatches(ResolveState& state) {
    for (PassId pass = 0; pass < state.passes.size(); ++pass) {
        const IndexScope scope(state, pass);
        const bool compute = state.graph.passes[pass].kind == PassKind::compute;
        if (compute && state.passes[pass].shader) DispatchStep(state, pass).run();
        if (state.graph.passes[pass].kind == PassKind::raster) find_draw_commands(state, pass);
        check_copy(state, pass);
    }
}

}  // namespace weft
