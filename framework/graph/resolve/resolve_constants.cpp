// Specialisation constants by name: HAS_x says whether port x is bound, the rest comes from the pass's
// "constants", the graph, or the numbers that the scene offers. Those that a draw list's variants set are
// left to it.
#include <algorithm>
#include <bit>

#include "graph/diagnostics/whole_number.h"
#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

constexpr std::string_view kSwitchPrefix = "HAS_";

class ConstantStep {
 public:
    ConstantStep(ResolveState& state, PassId pass)
        : state_(state), pass_(pass), work_(state.passes[pass]), decl_(state.graph.passes[pass]) {}

    void run() {
        report_values_without_constant();
        for (const SpecConstant& constant : work_.shader->spec_constants) set(constant);
        std::ranges::sort(decl_.spec_values, {}, &SpecValue::id);
    }

 private:
    const PassDesc& desc() const { return *work_.desc; }

    static bool is_switch(const SpecConstant& constant) {
        return constant.type == ScalarType::boolean && constant.name.starts_with(kSwitchPrefix);
    }

    SourceLoc shader_loc() const { return desc().shader_loc.line != 0 ? desc().shader_loc : desc().loc; }

    Diagnostic& error(SourceLoc loc, const std::string& message) {
        return state_.pass_error(pass_, loc, "W113", message);
    }

    void report_values_without_constant() {
        std::vector<std::string> names;
        for (const SpecConstant& constant : work_.shader->spec_constants) {
            if (!is_switch(constant)) names.push_back(constant.name);
        }
        for (const ParamValueDesc& given : desc().constants) {
            if (std::ranges::find(names, given.name) != names.end()) continue;
            const bool known = std::ranges::find(work_.shader->spec_constants, given.name,
                                                 &SpecConstant::name) != work_.shader->spec_constants.end();
            if (known) {
                add_help(error(given.loc, quoted(given.name) + " follows from whether the port is bound"),
                         "remove it, and leave the port out to make it false");
                continue;
            }
            Diagnostic& d = error(given.loc, "shader " + quoted(desc().shader) +
                                                 " has no specialisation constant " + quoted(given.name));
            add_help(d, did_you_mean_text(given.name, names));
            add_help(d, names.empty() ? "it has none" : "it has " + joined(names));
        }
    }

    void set(const SpecConstant& constant) {
        if (is_switch(constant)) {
            decl_.spec_values.push_back(
                {constant.id, constant.type, is_bound(constant.name.substr(kSwitchPrefix.size())) ? 1u : 0u});
            return;
        }
        const auto given = std::ranges::find(desc().constants, constant.name, &ParamValueDesc::name);
        if (given != desc().constants.end()) {
            const std::optional<ExprValue> value = state_.evaluate_here(given->components.front());
            if (value) store(constant, *value, given->loc);
        } else if (const std::optional<ExprValue> value = from_graph(constant.name)) {
            store(constant, *value, shader_loc());
        } else if (!is_set_by_draws(constant.name)) {
            Diagnostic& d =
                error(shader_loc(), "nothing gives constant " + quoted(constant.name) + " of shader " +
                                        quoted(desc().shader) + " a value in pass " + quoted(decl_.name));
            add_help(d, "give it in the pass: \"constants\": { " + quoted(constant.name) + ": 0 }");
        }
    }

    bool is_bound(const std::string& port) const {
        const auto named = [&](const PortDesc& p) { return p.port == port; };
        if (std::ranges::any_of(desc().out, named)) return true;
        return std::ranges::any_of(desc().in, named) &&
               std::ranges::find(work_.absent, port) == work_.absent.end();
    }

    std::optional<ExprValue> from_graph(const std::string& name) const {
        const GraphDesc& graph = state_.input.graph;
        if (!graph.params.contains(name) && !graph.consts.contains(name) && !work_.indices.contains(name) &&
            !state_.input.imports.numbers.contains(name))
            return std::nullopt;
        return state_.names.value(name);
    }

    // By any list that the program offers: a shader that could draw them all may be given one of them.
    bool is_set_by_draws(const std::string& name) const {
        if (decl_.kind != PassKind::raster) return false;
        return std::ranges::any_of(state_.input.imports.imports, [&](const auto& import) {
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
            add_help(error(loc, "constant " + quoted(constant.name) + " of shader " + quoted(desc().shader) +
                                    " can't have that value"),
                     "it is " + wanted + (value.is_size ? ": use .x or .y of the size" : ""));
            return;
        }
        decl_.spec_values.push_back({constant.id, constant.type, bits_of(constant.type, x)});
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

    ResolveState& state_;
    PassId pass_;
    PassWork& work_;
    PassDecl& decl_;
};

}  // namespace

void set_constants(ResolveState& state, PassId pass) {
    ConstantStep(state, pass).run();
}

}  // namespace weft
