#include "check/structure/check_views.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "check/structure/check_scopes.h"

namespace weft::check {
namespace {

// A mask of views has 32 bits.
constexpr size_t kMostMultiviews = 32;

class LoweringRule {
 public:
    LoweringRule(const FramePlan& plan, PassId id, FaultList& faults)
        : plan_(plan), id_(id), pass_(plan.graph.passes[id]), faults_(faults) {}

    void check() {
        if (pass_.lowering == ViewLowering::none) {
            if (!pass_.views.empty()) fault("it has a list of views, but no method (lowering) to draw them");
            return;
        }
        if (pass_.kind != PassKind::raster && pass_.kind != PassKind::fullscreen)
            return fault("it is not a drawing pass");
        if (pass_.views.empty()) return fault("its list of views is empty");
        if (pass_.lowering == ViewLowering::multiview && pass_.views.size() > kMostMultiviews)
            fault("multiview has at most 32 views, but the pass has " + std::to_string(pass_.views.size()));
        if (pass_.frame_slices != 0) fault("its views run in different frames (perFrame)");
        check_names();
        for (uint32_t u = 0; u < pass_.uses.size(); ++u) check_use(u);
        for (const AttachmentDecl& color : pass_.colors)
            if (color.resolve_use != kNoId) fault("it resolves an attachment");
    }

 private:
    void fault(const std::string& why) {
        faults_.add("C346", pass_.loc,
                    "pass " + faults_.pass_name(id_) + " draws several views at once, but " + why,
                    "draw each view by a pass of its own");
    }

    // The pass draws its view i to layer i. So its views must follow one another in one list: the views
    // `first`, `first` + 1 and so on.
    void check_names() {
        if (pass_.views.front() != pass_.view) fault("its first view is not " + pass_.view);
        if (pass_.views.size() == 1) return;
        const size_t open = pass_.view.find('(');
        const std::string list = pass_.view.substr(0, open);
        const auto known = std::find_if(plan_.graph.views.begin(), plan_.graph.views.end(),
                                        [&](const ViewListDecl& decl) { return decl.name == list; });
        if (open == std::string::npos || known == plan_.graph.views.end())
            return fault("its views are not part of a list of views in the plan");
        uint32_t first = 0;
        std::from_chars(pass_.view.data() + open + 1, pass_.view.data() + pass_.view.size(), first);
        for (size_t i = 0; i < pass_.views.size(); ++i)
            if (pass_.views[i] != list + "(" + std::to_string(first + i) + ")")
                fault("its view " + std::to_string(i) + " is " + pass_.views[i]);
        if (uint64_t{first} + pass_.views.size() > known->count)
            fault("the list " + list + " has only " + std::to_string(known->count) + " views");
    }

    void check_use(uint32_t index) {
        const UseDecl& use = pass_.uses[index];
        const ResourceDecl& resource = plan_.graph.resources[use.resource];
        if (!is_attachment(pass_, index)) {
            if (writes(use.access))
                fault("its views also write " + faults_.resource_name(use.resource) +
                      ", which is no attachment, so the order of the views matters");
            return;
        }
        if (use.range.layers != pass_.views.size() || use.range.mips != 1)
            fault("its " + std::to_string(pass_.views.size()) + " views need " +
                  std::to_string(pass_.views.size()) + " layers of one mip, but it draws to " +
                  faults_.part_name(use.resource, use.range));
        if (resource.samples != 1) fault(faults_.resource_name(use.resource) + " is multisampled");
    }

    const FramePlan& plan_;
    PassId id_;
    const PassDecl& pass_;
    FaultList& faults_;
};

}  // namespace

void check_views(const FramePlan& plan, FaultList& faults) {
    for (const PassId id : plan.schedule.order) LoweringRule(plan, id, faults).check();
}

}  // namespace weft::check
