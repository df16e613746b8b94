#include <algorithm>
#include <cmath>

#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/views/view_lists.h"

namespace weft {
namespace {

constexpr uint32_t kFrameAndViewSet = 0;
constexpr std::string_view kViewStruct = "ViewConstants";

// Returns true if the resource is a buffer of views. The type of the elements is not known for an import, so
// only their size is compared.
bool holds_views(const Declared& declared, ResourceId id) {
    const ResourceDecl& resource = declared.shapes.resources[id];
    if (resource.kind != ResourceKind::buffer) return false;
    if (const ResourceDesc* desc = declared.shapes.origins[id].desc) return desc->element == kViewStruct;
    const auto stride = declared.input.imports.strides.find(kViewStruct);
    return stride != declared.input.imports.strides.end() && resource.stride_bytes == stride->second;
}

// Reports an error in the view of a pass: the pass names a list of views but gives no number, or it names a
// single view and gives a number.
void report_number(PassBinding& pass, const ViewList& list) {
    const PassDesc& desc = *pass.draft.desc;
    Diagnostic& d = pass.error(desc.view_loc, "W118",
                               "pass " + quote(desc.name) + " uses view " + quote(desc.view) +
                                   ", but there is no view of exactly this name");
    if (list.single)
        return add_help(
            d, "remove the number, because there is only one such view: \"view\": " + quote(desc.view));
    if (list.count == 0) return add_help(d, "the list has no views: add an \"if\" to the pass");
    add_help(d, "add the number of the view, from 0 to " + std::to_string(list.count - 1) + ": \"view\": \"" +
                    desc.view + "(0)\"");
}

// Returns the number of the view whose depth a debug view shows. An image can have more layers than its list
// has views, so the result is limited to the number of the last view.
double shown_number(const PassBinding& pass, const ViewList& list) {
    const Expr& asked = pass.draft.desc->view_number;
    if (asked.empty()) return 0;
    const std::optional<ExprValue> number = pass.evaluator.value(asked);
    return number ? std::clamp(std::floor(number->x), 0.0, list.count - 1.0) : 0;
}

}  // namespace

const ShaderBinding* find_view_block(const ShaderInterface& shader) {
    const auto found = std::ranges::find_if(shader.bindings, [](const ShaderBinding& binding) {
        return binding.set == kFrameAndViewSet && binding.binding == kViewBinding;
    });
    return found == shader.bindings.end() ? nullptr : &*found;
}

std::optional<BufferView> bind_view(PassBinding& pass) {
    const PassDesc& desc = *pass.draft.desc;
    if (desc.view.empty()) return std::nullopt;
    const ViewList* list = find_view_list(pass.declared.input, pass.declared.values, desc, pass.reporter);
    if (list == nullptr) {
        pass.suspects.passes[pass.id] = 1;
        return std::nullopt;
    }
    const bool all = desc.view_target != ViewTarget::one;
    double number = 0;
    if (desc.observes) {
        if (list->count == 0) return std::nullopt;
        number = shown_number(pass, *list);
    } else if (!list->single || !all) {
        const bool one_of_many = desc.view_number.empty() && !list->single && list->count != 1;
        const bool numbered_single = !desc.view_number.empty() && list->single;
        if (one_of_many || numbered_single || list->count == 0) {
            report_number(pass, *list);
            return std::nullopt;
        }
        if (!desc.view_number.empty()) {
            const size_t errors = pass.reporter.error_count();
            const std::optional<double> found =
                pass.evaluator.number(desc.view_number, "the index of view " + quote(desc.view), 0,
                                      std::max(list->count, 1u) - 1.0);
            if (!found) {
                help_with_count(*list, errors, pass.reporter);
                pass.suspects.passes[pass.id] = 1;
                return std::nullopt;
            }
            number = *found;
        }
    }
    pass.bound.view = view_name(*list, static_cast<uint32_t>(number));
    for (uint32_t view = 0; view < pass.draft.views; ++view)
        pass.bound.views.push_back(view_name(*list, view));
    const PortDesc* buffer = find_view_buffer(pass.declared.input, *list);
    if (buffer == nullptr || pass.draft.shader == nullptr || find_view_block(*pass.draft.shader) == nullptr)
        return std::nullopt;
    return BufferView{buffer, list->first + static_cast<uint32_t>(number)};
}

bool select_view_element(PassBinding& pass, const BufferView& view, UseDecl& use) {
    const ResourceDecl& buffer = pass.declared.shapes.resources[use.resource];
    const std::string what = "pass " + quote(pass.draft.decl.name) + " reads view " + quote(pass.bound.view) +
                             " from " + quote(buffer.name);
    if (!holds_views(pass.declared, use.resource)) {
        Diagnostic& d = pass.error(use.loc, "W230",
                                   what + (buffer.kind == ResourceKind::image
                                               ? ", which is an image"
                                               : ", whose elements are not of the type ViewConstants"));
        add_help(d, "name a buffer of views: { \"buffer\": \"ViewConstants\", \"count\": " +
                        std::to_string(view.element + 1) + " }");
        return false;
    }
    const uint64_t stride = buffer.stride_bytes, count = buffer.size_bytes / stride;
    if (view.element >= count) {
        Diagnostic& d = pass.error(
            use.loc, "W230",
            what + ", which has only " + std::to_string(count) + (count == 1 ? " element" : " elements"));
        add_help(d, "increase \"count\" of the buffer, or reduce \"count\" of the list of views");
        return false;
    }
    use.bytes = ByteRange{view.element * stride, stride};
    return true;
}

}  // namespace weft
