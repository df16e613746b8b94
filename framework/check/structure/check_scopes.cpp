#include "check/structure/check_scopes.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace weft::check {
namespace {

// One attachment of a pass, with its declaration and its use.
struct Bound {
    const AttachmentDecl* decl = nullptr;
    const UseDecl* use = nullptr;
    bool depth = false;
};

std::vector<Bound> bound_by(const PassDecl& pass) {
    std::vector<Bound> all;
    for (const AttachmentDecl& color : pass.colors) all.push_back({&color, &pass.uses[color.use], false});
    if (pass.depth) all.push_back({&*pass.depth, &pass.uses[pass.depth->use], true});
    return all;
}

bool same_place(const Bound& a, const Bound& b) {
    return a.depth == b.depth && (a.depth || a.decl->location == b.decl->location) &&
           a.use->resource == b.use->resource && a.use->range == b.use->range &&
           a.use->state.layout == b.use->state.layout;
}

// Returns true if `all` and `others` have the same size, and every attachment in `all` has an attachment in
// `others` with the same location, resource, range and layout.
bool same_places(const std::vector<Bound>& all, const std::vector<Bound>& others) {
    return all.size() == others.size() && std::all_of(all.begin(), all.end(), [&](const Bound& a) {
               return std::any_of(others.begin(), others.end(),
                                  [&](const Bound& b) { return same_place(a, b); });
           });
}

bool is_drawing(const PassDecl& pass) {
    return pass.kind == PassKind::raster || pass.kind == PassKind::fullscreen;
}

class ScopeRule {
 public:
    ScopeRule(const FramePlan& plan, FaultList& faults, const PassStep& first, const PassStep& second)
        : faults_(faults),
          first_(first),
          second_(second),
          first_pass_(plan.graph.passes[first.pass]),
          second_pass_(plan.graph.passes[second.pass]) {}

    void check() {
        if (!is_drawing(first_pass_) || !is_drawing(second_pass_))
            return fault("one of the two passes does not draw");
        if (!first_.after.empty() || !second_.barriers.empty())
            return fault("barriers are recorded between the two passes");
        if (first_pass_.frame_slices != 0 || second_pass_.frame_slices != 0 ||
            first_pass_.switch_id != kNoId || second_pass_.switch_id != kNoId)
            return fault("one of the two passes does not draw in every frame");
        if (first_pass_.render_extent != second_pass_.render_extent)
            return fault("the two passes have different render extents");
        if (first_pass_.lowering != second_pass_.lowering)
            return fault("the two passes draw their views in different ways");
        const std::vector<Bound> before = bound_by(first_pass_), after = bound_by(second_pass_);
        if (after.empty() || !same_places(before, after) || !same_places(after, before))
            return fault("the two passes differ in attachments or in layouts of attachments");
        for (const Bound& bound : before) check_first(bound, after);
        for (const Bound& bound : after) check_second(bound);
        for (const PassDecl* pass : {&first_pass_, &second_pass_}) check_other_uses(*pass, before, after);
    }

 private:
    void fault(const std::string& why) {
        faults_.add("C306", second_pass_.loc,
                    "pass " + faults_.pass_name(second_.pass) + " continues the rendering scope of pass " +
                        faults_.pass_name(first_.pass) + ", but " + why,
                    "begin a new rendering scope for this pass, with barriers before it");
    }

    std::string name(const Bound& bound) const { return faults_.resource_name(bound.use->resource); }

    void check_first(const Bound& bound, const std::vector<Bound>& after) {
        if (bound.decl->resolve_use != kNoId)
            fault(name(bound) + " is resolved at the end of the first pass");
        const auto same =
            std::find_if(after.begin(), after.end(), [&](const Bound& b) { return same_place(bound, b); });
        if (writes(bound.use->access) && !writes(same->use->access))
            fault("the second pass does not store the result of the first pass in " + name(bound));
    }

    void check_second(const Bound& bound) {
        if (bound.decl->resolve_use != kNoId) fault(name(bound) + " is resolved only by the second pass");
        const auto ops =
            std::find_if(second_.attachments.begin(), second_.attachments.end(),
                         [&](const AttachmentOps& o) { return &second_pass_.uses[o.use] == bound.use; });
        const bool loads = ops == second_.attachments.end() || ops->load == LoadOp::load;
        if (!loads || !reads(bound.use->access))
            fault("the second pass does not load the content of " + name(bound));
    }

    // Reports each use of an attachment that is not an attachment access, such as sampling, if this use or
    // the attachment access writes. The reason: inside a rendering scope, Vulkan orders only attachment
    // accesses.
    void check_other_uses(const PassDecl& pass, const std::vector<Bound>& before,
                          const std::vector<Bound>& after) {
        for (uint32_t u = 0; u < pass.uses.size(); ++u) {
            const UseDecl& use = pass.uses[u];
            if (is_attachment(pass, u)) continue;
            for (const std::vector<Bound>* scope : {&before, &after})
                for (const Bound& bound : *scope)
                    if (bound.use->resource == use.resource && overlaps(bound.use->range, use.range) &&
                        (writes(use.access) || writes(bound.use->access)))
                        fault(name(bound) + " is also used in other ways than as an attachment");
        }
    }

    FaultList& faults_;
    const PassStep &first_, &second_;
    const PassDecl &first_pass_, &second_pass_;
};

}  // namespace

bool is_attachment(const PassDecl& pass, uint32_t use) {
    if (pass.depth && pass.depth->use == use) return true;
    return std::any_of(pass.colors.begin(), pass.colors.end(),
                       [use](const AttachmentDecl& color) { return color.use == use; });
}

void check_scopes(const FramePlan& plan, FaultList& faults) {
    for (const Batch& batch : plan.submissions.batches) {
        for (size_t i = 0; i < batch.positions.size(); ++i) {
            const PassStep& step = plan.barriers.steps[batch.positions[i]];
            if (!step.merges_render_pass) continue;
            if (i > 0) {
                ScopeRule(plan, faults, plan.barriers.steps[batch.positions[i - 1]], step).check();
                continue;
            }
            faults.add("C306", plan.graph.passes[step.pass].loc,
                       "pass " + faults.pass_name(step.pass) +
                           " continues a rendering scope, but is the first pass of its submission",
                       "begin a new rendering scope for this pass, with barriers before it");
        }
    }
}

}  // namespace weft::check
