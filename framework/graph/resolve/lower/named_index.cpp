#include "graph/resolve/lower/named_index.h"

#include <algorithm>
#include <span>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

class IndexSearch {
 public:
    explicit IndexSearch(const std::string& index) : index_(index) {}

    std::string run(const PassDesc& desc) {
        add_ports(desc);
        add("the key \"if\"", desc.condition);
        add("the number of vertices", desc.vertices);
        add("the number of instances", desc.instances);
        add("the key \"cost\"", desc.flops);
        for (const StateNumberDesc& number : desc.state_numbers) add("the key \"state\"", number.value);
        if (desc.clear) add("the key \"clear\"", desc.clear->channels);
        for (const auto& [port, color] : desc.clear_ports) add("the key \"clear\"", color.channels);
        for (const ParamValueDesc& value : desc.params)
            add("the value of Params." + value.name, value.components);
        for (const ParamValueDesc& value : desc.constants)
            add("the value of the constant " + quote(value.name), value.components);
        return std::move(found_);
    }

 private:
    void add_ports(const PassDesc& desc) {
        for (const PortDesc& port : desc.in) add(port, false);
        for (const PortDesc* port : written_ports(desc)) add(*port, true);
        if (desc.indirect) add(*desc.indirect, false);
        if (desc.draw_count) add(*desc.draw_count, false);
    }

    void add(const PortDesc& port, bool is_written) {
        add(port.ref, is_written && !port.ref.layer_last);
        if (port.otherwise) add(*port.otherwise, false);
    }

    void add(const RefDesc& ref, bool leaves_out_layer) {
        for (const std::optional<Expr>* bound : {&ref.mip_first, &ref.mip_last, &ref.layer_first,
                                                 &ref.layer_last, &ref.element_first, &ref.element_last})
            if (*bound && !(leaves_out_layer && bound == &ref.layer_first)) add(quote(ref.text), **bound);
    }

    void add(const std::string& place, std::span<const Expr> expressions) {
        for (const Expr& expression : expressions) add(place, expression);
    }

    void add(const std::string& place, const Expr& expression) {
        const bool names = std::ranges::any_of(expression.postfix, [&](const ExprNode& node) {
            return node.op == ExprOp::name && node.name == index_;
        });
        if (names && found_.empty()) found_ = place;
    }

    const std::string& index_;
    std::string found_;
};

}  // namespace

std::string place_of_index(const PassDesc& desc, const std::string& index) {
    return IndexSearch(index).run(desc);
}

}  // namespace weft
