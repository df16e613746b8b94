#include "load/shared_resources.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "graph/diagnostics/quoted_list.h"
#include "graph/resolve/fault_text.h"
#include "graph/syntax/merge.h"
#include "load/load_steps.h"

namespace weft {
namespace {

// One tier (quality level) of a graph, resolved. `tier` is "" for the graph without a tier.
struct ResolvedTier {
    std::string tier;
    const GraphDesc* desc = nullptr;
    ResolvedGraph graph;
};

// A property in which a shared resource may differ between two tiers.
struct Property {
    const char* name;
    std::function<std::string(const ResourceDecl&)> text;
    // The expression that gives the property, or null.
    std::function<const Expr*(const ResourceDesc&)> expression;
};

std::string text_of(const Extent3D& e) {
    return std::to_string(e.width) + " x " + std::to_string(e.height) +
           (e.depth > 1 ? " x " + std::to_string(e.depth) : "");
}

const Expr* no_expression(const ResourceDesc& /*unused*/) {
    return nullptr;
}

const std::vector<Property>& properties() {
    using Decl = ResourceDecl;
    using Desc = ResourceDesc;
    static const std::vector<Property> all{
        {"kind",
         [](const Decl& d) {
             return std::to_string(static_cast<int>(d.kind)) + std::to_string(static_cast<int>(d.image_kind));
         },
         no_expression},
        {"format", [](const Decl& d) { return std::string(format_info(d.format).name); }, no_expression},
        {"size", [](const Decl& d) { return text_of(d.extent); }, [](const Desc& d) { return &d.size; }},
        {"mips", [](const Decl& d) { return std::to_string(d.mips); }, [](const Desc& d) { return &d.mips; }},
        {"layers", [](const Decl& d) { return std::to_string(d.layers); },
         [](const Desc& d) { return &d.layers; }},
        {"samples", [](const Decl& d) { return std::to_string(d.samples); },
         [](const Desc& d) { return &d.samples; }},
        {"count", [](const Decl& d) { return std::to_string(d.size_bytes) + " bytes"; },
         [](const Desc& d) { return &d.count; }}};
    return all;
}

std::string tier_text(const std::string& tier) {
    return tier.empty() ? "in the graph without a tier" : "in tier " + quote(tier);
}

bool is_shared(const GraphDesc& desc, const std::string& name) {
    const auto found = desc.resources.find(name);
    return found != desc.resources.end() && found->second.keep == KeepMode::shared;
}

class SharedCheck {
 public:
    // `tiers` has each tier of the graph at most once.
    explicit SharedCheck(const std::vector<ResolvedTier>& tiers) : tiers_(tiers) {}

    // Compares one resource in all tiers, and returns the union of its usages.
    UsageMask check(const std::string& name) {
        UsageMask usage = 0;
        const ResolvedTier* first = nullptr;
        for (const ResolvedTier& tier : tiers_) {
            const ResourceId id = find_resource(tier.graph, name);
            if (!is_shared(*tier.desc, name) || id == kNoId) continue;
            usage |= tier.graph.resources[id].usage;
            if (first == nullptr)
                first = &tier;
            else
                compare(name, *first, tier);
        }
        return usage;
    }

    Diagnostics take_faults() { return std::move(faults_); }

 private:
    static const ResourceDecl& decl(const ResolvedTier& tier, const std::string& name) {
        return tier.graph.resources[find_resource(tier.graph, name)];
    }

    // Returns the place in the file that gives a property of the resource.
    static SourceLoc place(const ResolvedTier& tier, const std::string& name, const Property& property) {
        const ResourceDesc& desc = tier.desc->resources.at(name);
        const Expr* expression = property.expression(desc);
        return expression != nullptr && !expression->empty() ? expression->loc : desc.loc;
    }

    static SourceLoc tier_place(const ResolvedTier& tier) {
        const auto found = std::ranges::find(tier.desc->tiers, tier.tier, &TierDesc::name);
        return found == tier.desc->tiers.end() ? SourceLoc{} : found->loc;
    }

    void compare(const std::string& name, const ResolvedTier& first, const ResolvedTier& other) {
        const ResourceDecl &a = decl(first, name), &b = decl(other, name);
        for (const Property& property : properties()) {
            if (property.text(a) == property.text(b)) continue;
            return report(name, first, other, property);
        }
    }

    void report(const std::string& name, const ResolvedTier& first, const ResolvedTier& other,
                const Property& property) {
        if (std::ranges::find(reported_, name) != reported_.end()) return;
        reported_.push_back(name);
        const ResourceDecl &a = decl(first, name), &b = decl(other, name);
        SourceLoc loc = place(other, name, property), note = place(first, name, property);
        // If both places are the same, one expression has two values, because a parameter or a size differs
        // between the tiers. The note then names the place of the other tier.
        if (loc.file == note.file && loc.line == note.line && loc.column == note.column)
            note = tier_place(other);
        const std::string what = property.name;
        const bool says_kind = what == "kind";
        Diagnostic d = other.desc->sources.error(
            loc, "W198",
            "resource " + quote(name) + R"( has "keep": "shared", but its )" + what +
                " differs: " + (says_kind ? std::string() : property.text(a) + " ") + tier_text(first.tier) +
                (says_kind ? " and " : ", " + property.text(b) + " ") + tier_text(other.tier));
        add_note(d, other.desc->sources, note,
                 note.line == tier_place(other).line ? "this tier changes the " + what
                                                     : "the other " + what + " is given here");
        add_help(d, "give the resource the same " + what + " in all tiers");
        add_help(d,
                 R"(or write "keep": true: each tier then has its own memory, and Weft copies the content)");
        faults_.push_back(std::move(d));
    }

    const std::vector<ResolvedTier>& tiers_;
    std::vector<std::string> reported_;
    Diagnostics faults_;
};

void add_tier(const TierVariant& variant, const LoadInput& plain, const SkippedFormats& skipped,
              std::vector<ResolvedTier>& tiers) {
    Diagnostics ignored;
    LoadInput input = plain;
    input.request.tier = variant.desc.tier;
    Result<ResolvedGraph> graph = resolve_formats(variant.desc, variant.shaders, input, skipped, ignored);
    if (graph) tiers.push_back({variant.desc.tier, &variant.desc, std::move(*graph)});
}

}  // namespace

Result<SharedUsages> agree_on_shared(const JsonDoc& document, const TierVariant& own, const LoadInput& input,
                                     const SkippedFormats& skipped) {
    const auto shares = [](const auto& entry) { return entry.second.keep == KeepMode::shared; };
    if (tier_names(document).empty() || std::ranges::none_of(own.desc.resources, shares))
        return SharedUsages{};
    const LoadInput plain = as_written(input);
    std::vector<std::string> names = tier_names(document);
    names.insert(names.begin(), "");
    std::erase(names, own.desc.tier);
    const std::vector<TierVariant> others = load_tiers(document, names, plain);
    std::vector<ResolvedTier> tiers;
    add_tier(own, plain, skipped, tiers);
    for (const TierVariant& other : others) add_tier(other, plain, skipped, tiers);
    // The order does not depend on the tier that is loaded, so that each tier gives the same message.
    const auto rank = [&](const ResolvedTier& tier) {
        const auto at = std::ranges::find(own.desc.tiers, tier.tier, &TierDesc::name);
        return tier.tier.empty() ? 0 : 1 + (at - own.desc.tiers.begin());
    };
    std::ranges::sort(tiers, {}, rank);
    SharedCheck check(tiers);
    SharedUsages usages;
    for (const auto& [name, desc] : own.desc.resources)
        if (desc.keep == KeepMode::shared) usages[name] = check.check(name);
    Diagnostics faults = check.take_faults();
    if (!faults.empty()) return faults;
    return usages;
}

void set_usages(const SharedUsages& usages, ResolvedGraph& graph) {
    for (const auto& [name, usage] : usages)
        if (const ResourceId id = find_resource(graph, name); id != kNoId) graph.resources[id].usage |= usage;
}

}  // namespace weft
