#include "graph/resolve/resolve_context.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft {
namespace {

// More names than this say no more.
constexpr size_t kMostListed = 64;

template <class T>
uint32_t index_by_name(const std::vector<T>& sorted, std::string_view name) {
    const auto it = std::lower_bound(sorted.begin(), sorted.end(), name,
                                     [](const T& item, std::string_view n) { return item.name < n; });
    if (it == sorted.end() || it->name != name) return kNoId;
    return static_cast<uint32_t>(it - sorted.begin());
}

template <class T>
std::vector<std::string> keys_of(const std::map<std::string, T>& map) {
    std::vector<std::string> keys;
    for (const auto& [key, unused] : map) keys.push_back(key);
    return keys;
}

}  // namespace

std::optional<ExprValue> ResolveNames::value(const std::string& name) const {
    if (indices) {
        const auto index = indices->find(name);
        if (index != indices->end()) return number_value(index->second);
    }
    const auto it = values.find(name);
    if (it == values.end()) return std::nullopt;
    return it->second;
}

std::optional<uint32_t> ResolveNames::mips(const std::string& resource) const {
    const auto it = mip_counts.find(resource);
    if (it == mip_counts.end()) return std::nullopt;
    return it->second;
}

std::vector<std::string> ResolveNames::known_names() const {
    std::vector<std::string> known = keys_of(values);
    if (indices) {
        for (const auto& [name, unused] : *indices) known.push_back(name);
    }
    return known;
}

std::vector<std::string> ResolveNames::known_resources() const {
    return keys_of(mip_counts);
}

Diagnostic& ResolveState::error(SourceLoc loc, std::string code, std::string message) {
    return add_error(input.graph.sources.error(loc, std::move(code), std::move(message)));
}

Diagnostic& ResolveState::add_error(Diagnostic fault) {
    if (errors.size() >= kMostErrors) throw TooManyErrors{};
    return errors.emplace_back(std::move(fault));
}

uint64_t ResolveState::most_steps() const {
    return std::max<uint64_t>(1, input.limits.steps / (input.graph.tiers.size() + 1));
}

void ResolveState::spend(uint64_t count, SourceLoc loc) const {
    const uint64_t most = most_steps();
    if (count > most || steps > most - count) throw StepsUsedUp{loc};
    steps += count;
}

Diagnostic& ResolveState::pass_error(PassId pass, SourceLoc loc, std::string code, std::string message) {
    passes[pass].faulty = true;
    Diagnostic fault = input.graph.sources.error(loc, std::move(code), std::move(message));
    if (passes[pass].instance == 0 || !is_known(fault)) return add_error(std::move(fault));
    // The caller still searches for a name to suggest; these steps pay for that.
    spend(graph.passes.size() + graph.resources.size() + tried_ports, loc);
    return muted = std::move(fault);
}

bool ResolveState::is_included(SourceLoc loc) const {
    const std::vector<SourceFile>& files = input.graph.sources.files;
    return loc.file < files.size() && files[loc.file].included_at.file < files.size();
}

void ResolveState::warn(SourceLoc loc, std::string code, std::string message, std::string help) {
    if (warnings.size() >= kMostWarnings) {
        ++hidden_warnings;
        return;
    }
    Diagnostic warning = input.graph.sources.error(loc, std::move(code), std::move(message));
    warning.severity = Severity::warning;
    warning.help.push_back(std::move(help));
    warnings.push_back(std::move(warning));
}

std::optional<ExprValue> ResolveState::evaluate_here(const Expr& expression) {
    spend(expression.postfix.size(), expression.loc);
    for (const ExprNode& node : expression.postfix) {
        if (!node.name.empty() && faulty_values.contains(node.name)) return std::nullopt;
        if (node.op != ExprOp::mips_of) continue;
        const ResourceId resource = resource_id(node.name);
        if (resource != kNoId && resources[resource].suspect_shape) return std::nullopt;
    }
    Result<ExprValue> value = evaluate(expression, names, input.graph.sources);
    if (value) return *value;
    for (Diagnostic& d : value.take_errors()) {
        if (!repeats_itself || !is_known(d)) add_error(std::move(d));
    }
    return std::nullopt;
}

std::optional<double> ResolveState::number_here(const Expr& expression, const std::string& what, double least,
                                                double most, bool whole) {
    const std::optional<ExprValue> value = evaluate_here(expression);
    if (!value) return std::nullopt;
    const auto report = [&](std::string code, const std::string& message, std::string help) {
        Diagnostic fault = input.graph.sources.error(expression.loc, std::move(code), what + message);
        fault.help.push_back(std::move(help));
        if (!repeats_itself || !is_known(fault)) add_error(std::move(fault));
        return std::nullopt;
    };
    if (value->is_size) return report("W106", " is a size, not a number", "use .x or .y of it");
    const bool fits = value->x >= least && value->x <= most && (!whole || value->x == std::floor(value->x));
    if (fits) return value->x;
    return report("W109", " is " + number_text(value->x),
                  (whole ? "it is a whole number of " : "it lies between ") + number_text(least) +
                      (whole ? " to " : " and ") + number_text(most));
}

std::array<float, 4> ResolveState::color_here(const ColorDesc& color) {
    constexpr double kMost = std::numeric_limits<float>::max();
    std::array<float, 4> values{};
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(
            number_here(color.channels[i], "a channel of the colour", -kMost, kMost, false).value_or(0));
    return values;
}

bool ResolveState::is_known(const Diagnostic& fault) const {
    return std::ranges::any_of(errors, [&](const Diagnostic& d) {
        return d.code == fault.code && d.file == fault.file && d.line == fault.line &&
               d.column == fault.column;
    });
}

ResourceId ResolveState::resource_id(std::string_view name) const {
    return index_by_name(graph.resources, name);
}

std::vector<std::string> ResolveState::resource_names() const {
    std::vector<std::string> known;
    for (const ResourceDecl& resource : graph.resources) {
        if (resource.age == 0) known.push_back(resource.name);
    }
    return known;
}

std::vector<std::string> ResolveState::pass_names() const {
    return keys_of(input.graph.passes);
}

std::string range_of(const ResourceDecl& resource, const SubresourceRange& range) {
    const auto span = [](const char* what, uint32_t first, uint32_t count) {
        std::string written = ".";
        written.append(what).append("(").append(std::to_string(first));
        if (count > 1) written.append("..").append(std::to_string(first + count - 1));
        return written.append(")");
    };
    std::string text = resource.name;
    if (range.mips != resource.mips) text += span("mip", range.mip, range.mips);
    if (range.layers != resource.layers) text += span("layer", range.layer, range.layers);
    return text;
}

std::string quoted(std::string_view name) {
    std::string text = "\"";
    text += name;
    return text += '"';
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < std::min(names.size(), kMostListed); ++i) {
        if (i > 0) text += ", ";
        text += quoted(names[i]);
    }
    if (names.size() > kMostListed) text += " and " + std::to_string(names.size() - kMostListed) + " more";
    return text;
}

std::string extent_text(const Extent3D& extent) {
    std::string text = std::to_string(extent.width);
    text.append("x").append(std::to_string(extent.height));
    if (extent.depth > 1) text.append("x").append(std::to_string(extent.depth));
    return text;
}

Extent3D use_extent(const ResolveState& state, const UseDecl& use) {
    return mip_extent(state.graph.resources[use.resource].extent, use.range.mip);
}

BlendState blend_of(const PassDesc& desc, const std::string& port) {
    const auto own = desc.blend.find(port);
    if (own != desc.blend.end()) return own->second;
    const auto all = desc.blend.find("");
    return all != desc.blend.end() ? all->second : BlendState{};
}

void add_help(Diagnostic& diagnostic, std::string help) {
    if (!help.empty()) diagnostic.help.push_back(std::move(help));
}

}  // namespace weft
