#include "graph/resolve/expand.h"

#include "graph/parse/reference.h"
#include "graph/resolve/carry/carry_passes.h"
#include "graph/resolve/expand/draft_pass.h"
#include "graph/resolve/expand/expand_groups.h"
#include "graph/resolve/expand/expand_repeat.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/lower/choose_lowering.h"
#include "graph/resolve/switches/find_switches.h"

namespace weft {
namespace {

std::map<std::string, PassDesc> find_observers(const ResolveInput& input, Reporter& reporter) {
    std::map<std::string, PassDesc> observers;
    for (const std::string& text : input.request.observed) {
        const Result<RefDesc> ref = parse_reference({.text = text, .literal = {}}, input.graph.sources);
        if (!ref) {
            for (const Diagnostic& fault : ref.errors()) reporter.add(fault);
            continue;
        }
        PassDesc desc;
        desc.name = "observe:" + text;
        desc.type = "readback";
        desc.in.push_back({.port = "src", .ref = *ref, .sampler = std::nullopt, .loc = {}});
        desc.order_key = UINT32_MAX;
        observers.emplace(desc.name, std::move(desc));
    }
    return observers;
}

PassDecl declare(const PassDesc& desc, std::string name) {
    PassDecl decl;
    decl.name = std::move(name);
    decl.type = desc.type;
    decl.queue = desc.queue;
    decl.shader = desc.shader;
    decl.order_key = desc.order_key;
    decl.loc = desc.loc;
    return decl;
}

// Finds the slice of a pass (`draft`) in a repeat with "perFrame". The `count` passes of the repeat are
// divided into slices. Frame 0 runs all slices, and each later frame runs one slice. The value of "perFrame"
// is the number of passes per slice. 0 or false means that every frame runs all passes.
void slice(const Evaluator& evaluator, size_t count, PassDraft& draft) {
    if (draft.desc->per_frame.empty()) return;
    constexpr double kMost = 1u << 20;
    const std::optional<double> each =
        evaluator.number(draft.desc->per_frame, "\"perFrame\" of pass " + quote(draft.desc->name), 0, kMost);
    if (!each || *each == 0) return;
    const auto passes = static_cast<uint32_t>(count);
    const auto at_once = static_cast<uint32_t>(*each);
    draft.decl.frame_slice = draft.instance / at_once;
    draft.decl.frame_slices = (passes + at_once - 1) / at_once;
}

ChosenLowering find_lowering(const ResolveInput& input, const Values& values, const Shapes& shapes,
                             const PassDesc& desc, const SeparateViews& separate, Reporter& reporter) {
    if (desc.view_target != ViewTarget::layers) return {};
    const auto reason = separate.find(desc.name);
    if (reason != separate.end()) return {ViewLowering::none, 0, reason->second};
    return choose_lowering(input, values, shapes, desc, reporter);
}

// Makes the passes of all descriptions. The key of the returned map is the name of the pass, such as
// "blur#2".
std::map<std::string, PassDraft> draft_passes(const ResolveInput& input, const Values& values,
                                              const Evaluator& evaluator, const Shapes& shapes,
                                              const SeparateViews& separate, Expansion& expansion,
                                              Reporter& reporter) {
    std::map<std::string, PassDraft> drafts;
    RepeatCounts counts;
    const auto add = [&](const PassDesc& desc, bool is_observer) {
        const ChosenLowering lowering = find_lowering(input, values, shapes, desc, separate, reporter);
        std::vector<PassInstance> found = repeat_pass(input, values, evaluator, shapes, desc,
                                                      lowering.views > 0, counts, expansion, reporter);
        expansion.instances[desc.name].assign(found.size(), kNoId);
        for (uint32_t i = 0; i < found.size(); ++i) {
            drafts[found[i].name] = {.decl = declare(desc, found[i].name),
                                     .desc = &desc,
                                     .indices = std::move(found[i].indices),
                                     .instance = i,
                                     .views = lowering.views,
                                     .is_observer = is_observer};
            drafts[found[i].name].decl.lowering = lowering.kind;
            drafts[found[i].name].decl.lowering_reason = lowering.reason;
        }
    };
    for (const auto& [name, desc] : input.graph.passes) add(desc, false);
    for (const auto& [name, desc] : expansion.observers) add(desc, true);
    for (const auto& [name, desc] : expansion.carries) {
        add(desc, false);
        drafts[name].decl.carries = true;
    }
    return drafts;
}

// Stores the passes sorted by name; the index of a pass in this order is its PassId.
void name_passes(const Evaluator& evaluator, std::map<std::string, PassDraft> drafts, Expansion& expansion) {
    for (auto& [name, draft] : drafts) {
        std::vector<PassId>& instances = expansion.instances[draft.desc->name];
        instances[draft.instance] = static_cast<PassId>(expansion.passes.size());
        slice(evaluator, instances.size(), draft);
        expansion.passes.push_back(std::move(draft));
    }
    expansion.suspects.passes.resize(expansion.passes.size());
}

}  // namespace

Expansion expand(const ResolveInput& input, const Values& values, const Shapes& shapes, Reporter& reporter,
                 const SeparateViews& separate) {
    Expansion expansion;
    expansion.suspects = shapes.suspects;
    expansion.too_large = shapes.too_large;
    if (expansion.too_large) return expansion;
    expansion.observers = find_observers(input, reporter);
    expansion.carries = describe_carries(input, shapes);
    const Evaluator evaluator(values, shapes, expansion.suspects, reporter);
    name_passes(evaluator, draft_passes(input, values, evaluator, shapes, separate, expansion, reporter),
                expansion);
    if (!input.graph.groups.empty()) expand_groups(input, evaluator, expansion);
    PassReporter report(shapes, expansion, expansion.suspects, reporter);
    find_switches(input, expansion, report, reporter);
    for (PassId id(0); id < expansion.passes.size(); ++id) {
        PassDraft& draft = expansion.passes[id];
        const Evaluator in_pass = evaluator.in_repeat(draft.indices, draft.instance > 0);
        draft.decl.state = evaluate_state(*draft.desc, in_pass);
        find_kind(input, id, draft, report);
        check_state(input.profile, id, draft, report);
        find_shader(input, id, draft, expansion.suspects, report);
        draft.decl.side_effect = draft.decl.kind == PassKind::readback;
        if (draft.desc->flops.empty()) continue;
        if (const auto flops = in_pass.value(draft.desc->flops)) draft.decl.flops = flops->x;
    }
    return expansion;
}

}  // namespace weft
