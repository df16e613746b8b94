// The hashes of a plan: plan_hash() of all fields, structure_hash() without values that can change while the
// plan is used, and values_hash() of only these values.
#include <string>

#include "graph/plan/field_hash.h"
#include "weft/compile.h"

namespace weft {

std::string plan_hash(const FramePlan& plan) {
    return hash_fields([&](HashVisitor& visitor) { visit_fields(visitor, plan); });
}

std::string structure_hash(FramePlan plan) {
    for (PassDecl& pass : plan.graph.passes) {
        for (ParamWrite& write : pass.params) write.value = {};
        for (SpecValue& value : pass.spec_values) value.bits = 0;
        for (PassVariant& variant : pass.variants) {
            for (ParamWrite& write : variant.params) write.value = {};
            for (SpecValue& value : variant.spec_values) value.bits = 0;
        }
        for (NamedValue& value : pass.custom_params) value.value = 0;
        for (AttachmentDecl& color : pass.colors) color.blend = {};
        if (pass.depth) pass.depth->blend = {};
        pass.state = {};
        pass.culls_draws = false;
        pass.flops = 0;
    }
    for (GraphParam& param : plan.graph.params) param = {param.name};
    return plan_hash(plan);
}

std::string values_hash(const ResolvedGraph& graph) {
    return hash_fields([&](HashVisitor& v) {
        for (const PassDecl& pass : graph.passes) {
            for (const ParamWrite& write : pass.params) v("value", write.value);
            for (const SpecValue& value : pass.spec_values) v("bits", value.bits);
            for (const PassVariant& variant : pass.variants) {
                for (const ParamWrite& write : variant.params) v("value", write.value);
                for (const SpecValue& value : variant.spec_values) v("bits", value.bits);
            }
            for (const NamedValue& value : pass.custom_params) v("value", value.value);
            for (const AttachmentDecl& color : pass.colors) v("blend", color.blend);
            if (pass.depth) v("blend", pass.depth->blend);
            v("state", pass.state), v("cullsDraws", pass.culls_draws), v("flops", pass.flops);
        }
        for (const GraphParam& param : graph.params) v("value", param.value);
    });
}

}  // namespace weft
