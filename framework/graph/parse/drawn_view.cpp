#include "graph/parse/drawn_view.h"

#include <algorithm>
#include <optional>

#include "graph/parse/expression.h"

namespace weft {
namespace {

struct DrawnView {
    std::string list;
    Expr number;  // Number of the view in its list. Absent if the view has no number.
};

// Returns the reference with which a raster pass draws to the image, or null if the pass does not draw to it.
const RefDesc* drawn_reference(const PassDesc& pass, const std::string& image) {
    if (pass.type != "raster") return nullptr;
    if (pass.depth && pass.depth->ref.name == image) return &pass.depth->ref;
    const auto out = std::ranges::find(pass.out, image, [](const PortDesc& port) { return port.ref.name; });
    return out == pass.out.end() ? nullptr : &out->ref;
}

// The parts of a reference are compared by their texts: "0" and "1 - 1" are different layers here.
std::string layer_text(const RefDesc& ref) {
    return ref.layer_first ? ref.layer_first->text : std::string();
}

bool names_index(const PassDesc& pass, const Expr& expression) {
    return std::ranges::any_of(expression.postfix, [&](const ExprNode& node) {
        return node.op == ExprOp::name &&
               std::ranges::find(pass.repeat, node.name, &RepeatDesc::index) != pass.repeat.end();
    });
}

// Returns the view that `pass` draws to the layer `shown_layer`, or nullopt if it is unknown.
std::optional<DrawnView> view_of(const PassDesc& pass, const RefDesc& target, const Expr& shown_layer) {
    if (pass.view.empty()) return DrawnView{"camera", {}};
    if (pass.view_target == ViewTarget::rects)
        return DrawnView{pass.view, number_expression(0, pass.view_loc)};
    if (pass.view_number.empty() || !names_index(pass, pass.view_number))
        return DrawnView{pass.view, pass.view_number};
    const bool layer_is_number = target.layer_first && target.layer_first->text == pass.view_number.text;
    if (layer_is_number || (pass.view_target == ViewTarget::layers && !target.layer_first))
        return DrawnView{pass.view, shown_layer};
    return std::nullopt;
}

}  // namespace

void set_drawn_view(const GraphDesc& graph, const RefDesc& shown, PassDesc& pass) {
    const Expr layer = shown.layer_first ? *shown.layer_first : number_expression(0, pass.loc);
    const auto shows_layer = [&](const RefDesc& ref) { return layer_text(ref) == layer_text(shown); };
    bool layer_drawn = false;
    for (const auto& [name, other] : graph.passes)
        if (const RefDesc* ref = drawn_reference(other, shown.name))
            layer_drawn = layer_drawn || shows_layer(*ref);
    std::optional<DrawnView> found;
    for (const auto& [name, other] : graph.passes) {
        const RefDesc* ref = drawn_reference(other, shown.name);
        if (ref == nullptr || (layer_drawn && !shows_layer(*ref))) continue;
        const std::optional<DrawnView> view = view_of(other, *ref, layer);
        if (!view) return;
        if (found && (found->list != view->list || found->number.text != view->number.text)) return;
        found = view;
    }
    if (!found || found->list == "camera") return;
    pass.view = found->list;
    pass.view_number = found->number;
    pass.view_loc = pass.loc;
}

}  // namespace weft
