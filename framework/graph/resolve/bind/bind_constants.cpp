// Gives specialisation constants their values by name. The boolean constant HAS_x tells the shader whether
// port x is bound. The value of any other constant is searched in the pass's "constants". If it is not there,
// it is searched among the graph's parameters and constants, the indices of the pass's repeat, and the
// numbers that the program offers, such as the number of lights. The remaining constants are set for each
// draw by the variants of a draw list.
#include <algorithm>
#include <bit>

#include "graph/diagnostics/whole_number.h"
#include "graph/parse/module_scope.h"
#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

constexpr std::string_view kSwitchPrefix = "HAS_";

class ConstantBinder {
 public:
    explicit ConstantBinder(PassBinding& pass) : at_(pass) {}

    void run() {
        report_values_without_constant();
        for (const SpecConstant& constant : at_.draft.shader->spec_constants) set(constant);
        std::ranges::sort(at_.bound.spec_values, {}, &SpecValue::id);
    }

 private:
    const PassDesc& desc() const { return *at_.draft.desc; }

    static bool is_switch(const SpecConstant& constant) {
        return constant.type == ScalarType::boolean && constant.name.starts_with(kSwitchPrefix);
    }

    SourceLoc shader_loc() const { return desc().shader_loc.line != 0 ? desc().shader_loc : desc().loc; }

    Diagnostic& error(SourceLoc loc, const std::string& message) { return at_.error(loc, "W113", message); }

    void report_values_without_constant() {
        std::vector<std::string> names;
        for (const SpecConstant& constant : at_.draft.shader->spec_constants) {
            if (!is_switch(constant)) names.push_back(constant.name);
        }
        for (const ParamValueDesc& given : desc().constants) {
            if (std::ranges::find(names, given.name) != names.end()) continue;
            const bool known =
                std::ranges::find(at_.draft.shader->spec_constants, given.name, &SpecConstant::name) !=
                at_.draft.shader->spec_constants.end();
            if (known) {
                add_help(error(given.loc, quote(given.name) +
                                              " cannot be set: Weft sets it to true if the port is bound"),
                         "remove this constant; to make its value false, remove the port");
                continue;
            }
            Diagnostic& d = error(given.loc, "shader " + quote(desc().shader) +
                                                 " has no specialisation constant " + quote(given.name));
            add_help(d, did_you_mean_text(given.name, names));
            add_help(d, names.empty() ? "the shader has no specialisation constants"
                                      : "its constants are " + quote_all(names));
        }
    }

    void set(const SpecConstant& constant) {
        if (is_switch(constant)) {
            at_.bound.spec_values.push_back(
                {constant.id, constant.type, is_bound(constant.name.substr(kSwitchPrefix.size())) ? 1u : 0u});
            return;
        }
        const auto given = std::ranges::find(desc().constants, constant.name, &ParamValueDesc::name);
        if (given != desc().constants.end()) {
            const std::optional<ExprValue> value = at_.evaluator.value(given->components.front());
            if (value) store(constant, *value, given->loc);
        } else if (const std::optional<ExprValue> value = from_graph(constant.name)) {
            store(constant, *value, shader_loc());
        } else if (!is_set_by_draws(constant.name)) {
            Diagnostic& d =
                error(shader_loc(), "pass " + quote(at_.draft.decl.name) + " gives no value to constant " +
                                        quote(constant.name) + " of shader " + quote(desc().shader));
            add_help(d, "set the value in the pass: \"constants\": { " + quote(constant.name) + ": 0 }");
        }
    }

    bool is_bound(const std::string& port) const {
        const auto named = [&](const PortDesc& p) { return p.port == port; };
        if (std::ranges::any_of(desc().out, named)) return true;
        return std::ranges::any_of(desc().in, named) &&
               std::ranges::find(at_.bound.absent, port) == at_.bound.absent.end();
    }

    std::optional<ExprValue> from_graph(const std::string& constant) const {
        const GraphDesc& graph = at_.declared.input.graph;
        const bool is_index = at_.draft.indices.contains(constant);
        const std::string name = is_index ? constant : name_in_module(graph, desc().module, constant);
        if (!graph.params.contains(name) && !graph.consts.contains(name) && !is_index &&
            !at_.declared.input.imports.numbers.contains(name))
            return std::nullopt;
        return at_.evaluator.find(name);
    }

    // Returns true if a draw list sets the constant. Examines all lists that the program provides, because
    // the shader may be used with any of them.
    bool is_set_by_draws(const std::string& name) const {
        if (at_.draft.decl.kind != PassKind::raster) return false;
        return std::ranges::any_of(at_.declared.input.imports.imports, [&](const auto& import) {
            return std::ranges::any_of(import.second.variants, [&](const DrawVariant& variant) {
                return std::ranges::find(variant.spec_constants, name, &NamedValue::name) !=
                       variant.spec_constants.end();
            });
        });
    }

    void store(const SpecConstant& constant, const ExprValue& value, SourceLoc loc) {
        const double x = value.x;
        const bool fits = constant.type == ScalarType::u32   ? whole_number<uint32_t>(x).has_value()
                          : constant.type == ScalarType::i32 ? whole_number<int32_t>(x).has_value()
                                                             : fits_into_float(x);
        if (value.is_size || !fits) {
            const std::string wanted = constant.type == ScalarType::u32   ? "a whole number from 0"
                                       : constant.type == ScalarType::i32 ? "a whole number"
                                                                          : "a number";
            add_help(error(loc, "constant " + quote(constant.name) + " of shader " + quote(desc().shader) +
                                    " cannot have this value"),
                     "write " + wanted + (value.is_size ? ": use .x or .y of the size" : ""));
            return;
        }
        at_.bound.spec_values.push_back({constant.id, constant.type, bits_of(constant.type, x)});
    }

    static uint32_t bits_of(ScalarType type, double x) {
        switch (type) {
            case ScalarType::f32:
                return std::bit_cast<uint32_t>(saturated_float(x));
            case ScalarType::i32:
                return std::bit_cast<uint32_t>(saturated<int32_t>(x));
            case ScalarType::u32:
                return saturated<uint32_t>(x);
            case ScalarType::boolean:
                break;
        }
        return x != 0 ? 1u : 0u;
    }

    PassBinding& at_;
};

}  // namespace

void bind_constants(PassBinding& pass) {
    ConstantBinder(pass).run();
}

}  // namespace weft
