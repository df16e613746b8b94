#include "graph/report/view_phrases.h"

#include "graph/plan/plan_names.h"

namespace weft {

std::string view_range(const PassDecl& pass) {
    return pass.views.size() < 2 ? pass.view : pass.view + " to " + pass.views.back();
}

std::string describe_lowering(const PassDecl& pass) {
    if (pass.lowering_reason.empty()) return "";
    if (pass.lowering == ViewLowering::none)
        return view_range(pass) + ", one pass for each view: " + pass.lowering_reason;
    return view_range(pass) + " in one pass, lowering " + enum_name(pass.lowering) + ": " +
           pass.lowering_reason;
}

}  // namespace weft
