// The references of ports become resources, ranges and pins.
#include <algorithm>
#include <cmath>

#include "graph/diagnostics/whole_number.h"
#include "graph/resolve/resolve_presence.h"

namespace weft {
namespace {

// A whole number in [0, count), or reported. `what` is "mip" or "layer".
std::optional<uint32_t> subresource_index(ResolveState& state, PassId pass, const RefDesc& ref,
                                          const Expr& expression, const char* what, uint32_t count) {
    const std::optional<ExprValue> value = state.evaluate_here(expression);
    if (!value) {
        state.passes[pass].faulty = true;
        return std::nullopt;
    }
    const std::optional<uint32_t> index = value->is_size ? std::nullopt : whole_number<uint32_t>(value->x);
    if (index && *index < count) return *index;
    const bool fraction = !value->is_size && value->x != std::floor(value->x);
    const std::string found = value->is_size ? "a size" : number_text(value->x);
    Diagnostic& d = state.pass_error(pass, ref.loc, "W105",
                                     std::string(what) + " " + found + " of " + quoted(ref.name) +
                                         (fraction ? " is not a whole number" : " is out of range"));
    if (fraction) add_help(d, "round it: floor(…) or ceil(…)");
    add_help(d, quoted(ref.name) + " has " +
                    (count == 1 ? std::string("only ") + what + " 0"
                                : std::string(what) + "s 0 to " + std::to_string(count - 1)));
    return std::nullopt;
}

struct Span {
    uint32_t first = 0;
    uint32_t count = 1;
};

std::optional<Span> subresource_span(ResolveState& state, PassId pass, const RefDesc& ref, const char* what,
                                     uint32_t count) {
    const bool is_mip = what[0] == 'm';
    const std::optional<Expr>& first = is_mip ? ref.mip_first : ref.layer_first;
    const std::optional<Expr>& last = is_mip ? ref.mip_last : ref.layer_last;
    if (!first) return Span{0, count};
    const std::optional<uint32_t> from = subresource_index(state, pass, ref, *first, what, count);
    if (!from || !last) return from ? std::optional(Span{*from, 1}) : std::nullopt;
    const std::optional<uint32_t> to = subresource_index(state, pass, ref, *last, what, count);
    if (!to) return std::nullopt;
    if (*to >= *from) return Span{*from, *to - *from + 1};
    Diagnostic& d = state.pass_error(
        pass, ref.loc, "W105", std::string("the ") + what + "s of " + quoted(ref.text) + " run backwards");
    add_help(d, "write the smaller first: a..b with a <= b");
    return std::nullopt;
}

// A misspelt output may be the writer that another pass waits for: that pass has no fault of its own.
void suspect_near_names(ResolveState& state, const std::string& name) {
    for (const std::string& near : did_you_mean(name, state.resource_names())) {
        state.resources[state.resource_id(near)].suspect_writers = true;
    }
}

// The import itself was reported: ports that spell its name right have no fault of their own.
bool means_faulty_import(ResolveState& state, PassId pass, const std::string& name) {
    for (const std::string& near : did_you_mean(name, state.resource_names())) {
        const ResourceWork& work = state.resources[state.resource_id(near)];
        if (work.desc || !work.suspect_shape || !state.input.imports.imports.contains(name)) continue;
        state.passes[pass].faulty = true;
        return true;
    }
    return false;
}

ResourceId find_port_resource(ResolveState& state, PassId pass, const RefDesc& ref, bool is_output) {
    const ResourceId id = state.resource_id(ref.name);
    if (id != kNoId) return id;
    if (means_faulty_import(state, pass, ref.name)) return kNoId;
    const std::string verb = is_output ? " writes " : " reads ";
    const std::string who = pass < state.passes.size() && state.observers.contains(state.pass_name(pass))
                                ? "the observer" + verb
                                : "pass " + quoted(state.pass_name(pass)) + verb;
    if (state.input.graph.imports.contains(ref.name)) {
        Diagnostic& d =
            state.pass_error(pass, ref.loc, "W103", who + quoted(ref.name) + ", which is a draw list");
        add_help(d, "draw lists go to \"draws\" of a raster pass");
        return kNoId;
    }
    Diagnostic& d = state.pass_error(pass, ref.loc, "W103", who + "unknown resource " + quoted(ref.name));
    const std::string near = did_you_mean_text(ref.name, state.resource_names());
    add_help(d, near.empty() ? "declare it in \"resources\", or import it" : near);
    if (is_output) suspect_near_names(state, ref.name);
    return kNoId;
}

// False: reported.
bool check_pin(ResolveState& state, PassId pass, const RefDesc& ref) {
    if (ref.pass == state.author_name(pass) && state.passes[pass].desc->repeat.empty()) {
        Diagnostic& d = state.pass_error(
            pass, ref.loc, "W104",
            "pass " + quoted(ref.pass) + " can't pin its own version of " + quoted(ref.name));
        add_help(d, "name the pass whose version it should see");
        return false;
    }
    if (state.faulty_passes.contains(ref.pass)) {
        state.passes[pass].faulty = true;
        return false;
    }
    if (ref.pass.empty() || state.instances.contains(ref.pass)) return true;
    Diagnostic& d =
        state.pass_error(pass, ref.loc, "W104", quoted(ref.text) + " names unknown pass " + quoted(ref.pass));
    const std::string near = did_you_mean_text(ref.pass, state.pass_names());
    add_help(d, near.empty() ? "passes are " + joined(state.pass_names()) : near);
    return false;
}

std::optional<SubresourceRange> find_range(ResolveState& state, PassId pass, const RefDesc& ref,
                                           ResourceId id) {
    const ResourceDecl& resource = state.graph.resources[id];
    if (resource.kind == ResourceKind::buffer) {
        if (!ref.mip_first && !ref.layer_first && ref.aspects == 0) return SubresourceRange{};
        Diagnostic& d = state.pass_error(pass, ref.loc, "W105",
                                         quoted(ref.name) +
                                             " is a buffer: it has no mips, "
                                             "layers or aspects");
        add_help(d, "write " + quoted(ref.name));
        return std::nullopt;
    }
    const std::optional<Span> mips = subresource_span(state, pass, ref, "mip", resource.mips);
    const std::optional<Span> layers = subresource_span(state, pass, ref, "layer", resource.layers);
    if (!mips || !layers) return std::nullopt;
    return SubresourceRange{mips->first, mips->count, layers->first, layers->count, ref.aspects};
}

// Nothing: reported. `ref` is the port's own or its "else".
std::optional<BoundPort> bind_reference(ResolveState& state, PassId pass, const PortDesc& port,
                                        const RefDesc& ref, bool is_output) {
    const ResourceId named = find_port_resource(state, pass, ref, is_output);
    if (named == kNoId) return std::nullopt;
    const ResourceId resource = find_role(state, pass, ref, named, is_output);
    if (resource == kNoId) {
        if (is_output) state.resources[named].suspect_writers = true;
        return std::nullopt;
    }
    if (!check_pin(state, pass, ref) || state.resources[resource].suspect_shape) {
        // An output is still known to write this resource, though not where.
        state.passes[pass].faulty = true;
        if (is_output) state.resources[resource].suspect_writers = true;
        return std::nullopt;
    }
    const std::optional<SubresourceRange> range = find_range(state, pass, ref, resource);
    if (!range) {
        if (is_output) state.resources[resource].suspect_writers = true;
        return std::nullopt;
    }
    BoundPort bound;
    bound.work.desc = &port;
    bound.use.port = port.port;
    bound.use.resource = resource;
    bound.use.range = *range;
    bound.use.history = ref.history;
    bound.use.is_output = is_output;
    bound.use.loc = ref.loc;
    if (port.sampler) bound.use.sampler = *port.sampler;
    return bound;
}

std::vector<BoundPort> collect_outputs(ResolveState& state, PassId id) {
    const IndexScope scope(state, id);
    const PassDesc& desc = *state.passes[id].desc;
    std::vector<BoundPort> ports;
    for (const PortDesc* port : written_ports(desc)) {
        std::optional<BoundPort> bound = bind_reference(state, id, *port, port->ref, true);
        if (!bound) continue;
        bound->work.is_depth_port = desc.depth && port == &*desc.depth;
        bound->work.is_resolve = std::ranges::any_of(
            desc.resolves, [&](const ResolveDesc& resolve) { return port == &resolve.target; });
        ports.push_back(std::move(*bound));
    }
    return ports;
}

// What the port names, or what it takes instead, or nothing.
void add_input(ResolveState& state, PassId pass, const PortDesc& port, const BoundPorts& outputs,
               std::vector<BoundPort>& ports) {
    for (const RefDesc* ref : {&port.ref, port.otherwise ? &*port.otherwise : nullptr}) {
        if (!ref) break;
        std::optional<BoundPort> bound = bind_reference(state, pass, port, *ref, false);
        if (!bound) return;
        if (!ref->pass.empty()) resolve_pins(state, pass, *ref, outputs, *bound);
        if (!is_present(state, pass, *bound, outputs)) continue;
        ports.push_back(std::move(*bound));
        return;
    }
    if (port.optional) {
        state.passes[pass].absent.push_back(port.port);
    } else {
        report_absent(state, pass, port);
    }
}

// Inputs first, then outputs, each in the order of their names.
void store_ports(ResolveState& state, PassId id, std::vector<BoundPort> ports) {
    std::ranges::stable_sort(ports, {},
                             [](const BoundPort& p) { return std::pair(p.use.is_output, p.use.port); });
    for (BoundPort& port : ports) {
        state.graph.passes[id].uses.push_back(std::move(port.use));
        state.passes[id].ports.push_back(std::move(port.work));
    }
}

void collect_ports(ResolveState& state) {
    BoundPorts outputs;
    for (PassId id = 0; id < state.passes.size(); ++id) outputs.push_back(collect_outputs(state, id));
    for (PassId id = 0; id < state.passes.size(); ++id) {
        for (BoundPort& output : outputs[id]) {
            const RefDesc& ref = output.work.desc->ref;
            if (!ref.pass.empty()) resolve_pins(state, id, ref, outputs, output);
        }
    }
    for (PassId id = 0; id < state.passes.size(); ++id) {
        const IndexScope scope(state, id);
        std::vector<BoundPort> ports;
        const PassDesc& desc = *state.passes[id].desc;
        for (const PortDesc& port : desc.in) add_input(state, id, port, outputs, ports);
        if (desc.indirect) {
            const size_t before = ports.size();
            add_input(state, id, *desc.indirect, outputs, ports);
            if (ports.size() > before) ports.back().work.is_indirect = true;
        }
        ports.insert(ports.end(), outputs[id].begin(), outputs[id].end());
        store_ports(state, id, std::move(ports));
    }
}

// Leaving a binding empty takes a shader that knows what to do without it.
void check_optional_ports(ResolveState& state, PassId pass) {
    const PassWork& work = state.passes[pass];
    for (const PortDesc& port : work.desc->in) {
        if (!port.optional) continue;
        const std::string constant = "HAS_" + port.port;
        const bool known =
            work.shader && std::ranges::any_of(work.shader->spec_constants, [&](const auto& c) {
                return c.type == ScalarType::boolean && c.name == constant;
            });
        if (known || (has_shader(state.graph.passes[pass].kind) && !work.shader)) continue;
        const std::string who = work.shader
                                    ? "shader " + quoted(work.desc->shader) + " does not know " + constant
                                    : state.graph.passes[pass].type + " passes have no shader to ask";
        Diagnostic& d = state.pass_error(pass, port.loc, "W168",
                                         "port " + quoted(port.port) + " of pass " +
                                             quoted(state.pass_name(pass)) + " can't be optional: " + who);
        add_help(d, work.shader ? "declare it: layout(constant_id = 0) const bool " + constant + " = false;"
                                : "give it an \"else\"");
    }
}

void suspect_outputs(ResolveState& state, PassId id) {
    if (!state.passes[id].faulty) return;
    for (const UseDecl& use : state.graph.passes[id].uses) {
        if (use.is_output) state.resources[use.resource].suspect_writers = true;
    }
}

}  // namespace

void bind_ports(ResolveState& state) {
    collect_ports(state);
    for (PassId id = 0; id < state.passes.size(); ++id) {
        const IndexScope scope(state, id);
        const PassKind kind = state.graph.passes[id].kind;
        if (kind == PassKind::raster) check_draws(state, id);
        if (has_shader(kind)) resolve_view(state, id);
        check_optional_ports(state, id);
        if (has_shader(kind)) {
            if (!state.passes[id].shader) continue;
            bind_shader_pass(state, id);
            check_shader_fits(state, id);
            set_constants(state, id);
        } else if (kind == PassKind::custom) {
            if (state.passes[id].custom) bind_custom_pass(state, id);
        } else {
            bind_fixed_pass(state, id);
        }
    }
    for (PassId id = 0; id < state.passes.size(); ++id) suspect_outputs(state, id);
}

}  // namespace weft
