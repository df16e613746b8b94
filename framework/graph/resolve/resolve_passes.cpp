// Passes get their kinds and shaders; observed references become passes of their own.
#include <algorithm>
#include <array>

#include "graph/parse/reference.h"
#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

struct KindName {
    std::string_view name;
    PassKind kind;
};
constexpr std::array kKinds{
    KindName{"blit", PassKind::copy},
    KindName{"clear", PassKind::clear},
    KindName{"compute", PassKind::compute},
    KindName{"copy", PassKind::copy},
    KindName{"fullscreen", PassKind::fullscreen},
    KindName{"raster", PassKind::raster},
    KindName{"readback", PassKind::readback},
};

void declare_observers(ResolveState& state) {
    for (const std::string& text : state.input.observed) {
        const Result<RefDesc> ref = parse_reference({.text = text, .literal = {}}, state.input.graph.sources);
        if (!ref) {
            for (const Diagnostic& fault : ref.errors()) state.add_error(fault);
            continue;
        }
        PassDesc desc;
        desc.name = "observe:" + text;
        desc.type = "readback";
        desc.in.push_back({.port = "src", .ref = *ref, .sampler = std::nullopt, .loc = {}});
        desc.order_key = UINT32_MAX;
        state.observers.emplace(desc.name, std::move(desc));
    }
}

void find_kind(ResolveState& state, PassId id) {
    PassDecl& decl = state.graph.passes[id];
    const auto* built_in = std::ranges::find(kKinds, std::string_view(decl.type), &KindName::name);
    if (built_in != kKinds.end()) {
        decl.kind = built_in->kind;
        return;
    }
    decl.kind = PassKind::custom;
    const auto custom = state.input.passes.find(decl.type);
    if (custom != state.input.passes.end()) {
        state.passes[id].custom = &custom->second;
        return;
    }
    std::vector<std::string> known;
    for (const KindName& kind : kKinds) known.emplace_back(kind.name);
    for (const auto& [name, unused] : state.input.passes) known.push_back(name);
    Diagnostic& d = state.pass_error(id, decl.loc, "W115",
                                     "pass " + quoted(decl.name) + " has unknown type " + quoted(decl.type));
    const std::string near = did_you_mean_text(decl.type, known);
    add_help(d, near.empty() ? "types are " + joined(known) : near);
}

void find_shader(ResolveState& state, PassId id) {
    PassWork& work = state.passes[id];
    const PassDecl& decl = state.graph.passes[id];
    if (!has_shader(decl.kind)) return;
    const auto program = state.input.shaders.find(work.desc->shader);
    // A program without modules failed to compile, and whoever compiled it said so.
    if (program != state.input.shaders.end() && program->second.modules.empty()) {
        work.faulty = true;
        return;
    }
    if (program == state.input.shaders.end()) {
        Diagnostic& d = state.pass_error(id, work.desc->shader_loc, "W177",
                                         work.desc->shader.empty()
                                             ? decl.type + " pass " + quoted(decl.name) + " has no shader"
                                             : "shader " + quoted(work.desc->shader) + " of pass " +
                                                   quoted(decl.name) + " was not compiled");
        add_help(d, "name a shader: \"shader\": \"name" +
                        std::string(decl.kind == PassKind::compute      ? ".comp\""
                                    : decl.kind == PassKind::fullscreen ? ".frag\""
                                                                        : "\" for name/name.vert and .frag"));
        return;
    }
    const ShaderStageMask wanted =
        stage_bit(decl.kind == PassKind::compute ? ShaderStage::compute : ShaderStage::fragment);
    work.shader = &program->second.interface;
    if (work.shader->stages & wanted) return;
    work.shader = nullptr;
    Diagnostic& d =
        state.pass_error(id, work.desc->shader_loc, "W177",
                         "shader " + quoted(work.desc->shader) + " is not one for a " + decl.type + " pass");
    add_help(d, decl.kind == PassKind::compute ? "it needs a .comp shader" : "it needs a fragment stage");
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

// So many of a repeat's passes each frame, in order; 0 (or false) is all of them.
void take_turns(ResolveState& state, const PassWork& work, PassDecl& decl) {
    if (work.desc->per_frame.empty()) return;
    constexpr double kMost = 1u << 20;
    const std::optional<double> each =
        state.number_here(work.desc->per_frame, "\"perFrame\" of pass " + quoted(work.desc->name), 0, kMost);
    if (!each || *each == 0) return;
    const auto passes = static_cast<uint32_t>(state.instances[work.desc->name].size());
    const auto at_once = static_cast<uint32_t>(*each);
    decl.turn = work.instance / at_once;
    decl.turns = (passes + at_once - 1) / at_once;
}

// Ids follow the names.
void name_passes(ResolveState& state) {
    std::map<std::string, PassWork> by_name;
    const auto add = [&](const PassDesc& desc) {
        std::vector<PassInstance> instances = pass_instances(state, desc);
        state.instances[desc.name].assign(instances.size(), kNoId);
        for (uint32_t i = 0; i < instances.size(); ++i) {
            by_name[instances[i].name] = {
                .desc = &desc, .indices = std::move(instances[i].indices), .instance = i};
        }
    };
    for (const auto& [name, desc] : state.input.graph.passes) add(desc);
    for (const auto& [name, desc] : state.observers) add(desc);
    for (auto& [name, work] : by_name) {
        state.instances[work.desc->name][work.instance] = static_cast<PassId>(state.passes.size());
        state.graph.passes.push_back(declare(*work.desc, name));
        take_turns(state, work, state.graph.passes.back());
        state.passes.push_back(std::move(work));
    }
}

}  // namespace

std::vector<const PortDesc*> written_ports(const PassDesc& desc) {
    std::vector<const PortDesc*> ports;
    for (const PortDesc& port : desc.out) ports.push_back(&port);
    if (desc.depth) ports.push_back(&*desc.depth);
    for (const ResolveDesc& resolve : desc.resolves) ports.push_back(&resolve.target);
    return ports;
}

bool has_shader(PassKind kind) {
    return kind == PassKind::compute || kind == PassKind::fullscreen || kind == PassKind::raster;
}

void declare_passes(ResolveState& state) {
    declare_observers(state);
    name_passes(state);
    for (PassId id = 0; id < state.passes.size(); ++id) {
        const IndexScope scope(state, id);
        set_state(state, id);
        find_kind(state, id);
        check_state(state, id);
        find_shader(state, id);
        PassDecl& decl = state.graph.passes[id];
        decl.side_effect = decl.kind == PassKind::readback;
        if (state.passes[id].desc->flops.empty()) continue;
        if (const auto flops = state.evaluate_here(state.passes[id].desc->flops)) decl.flops = flops->x;
    }
}

}  // namespace weft
