#include "graph/resolve/live/live_size.h"

#include <algorithm>

#include "graph/parse/module_scope.h"

namespace weft {
namespace {

class ScaleSearch {
 public:
    ScaleSearch(const ResolveInput& input, const Values& values) : graph_(input.graph), values_(values) {}

    // Returns true if the expression depends on a scale or a live size, directly or through constants and
    // sizes.
    [[nodiscard]] bool depends(const Expr& expression) {
        return std::ranges::any_of(expression.postfix, [&](const ExprNode& node) {
            return node.op == ExprOp::name && name_depends(node.name);
        });
    }
    [[nodiscard]] bool name_depends(const std::string& name) {
        if (values_.scales.contains(name) || graph_.size_scales.contains(name)) return true;
        if (!visited_.insert(name).second) return false;
        if (const auto constant = graph_.consts.find(name); constant != graph_.consts.end())
            return depends(constant->second);
        const auto size = graph_.sizes.find(name);
        return size != graph_.sizes.end() && depends(size->second);
    }

 private:
    const GraphDesc& graph_;
    const Values& values_;
    std::set<std::string> visited_;
};

}  // namespace

bool has_live_size(const ResolveInput& input, const Values& values, const ResourceDesc& image) {
    if (values.scales.empty()) return false;
    ScaleSearch search(input, values);
    if (!image.size.empty()) return search.depends(image.size);
    return image.file.name.empty() && search.name_depends(render_size_name(input.graph, image.name));
}

}  // namespace weft
