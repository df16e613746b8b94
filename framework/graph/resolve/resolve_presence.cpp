#include "graph/resolve/resolve_presence.h"

#include <algorithm>

namespace weft {
namespace {

bool names_this_frames(const PortDesc& port, const std::string& name) {
    return port.ref.name == name && port.ref.history == 0;
}

// The port by which a pass writes a resource; null: it doesn't.
const PortDesc* output_of(const PassDesc& desc, const std::string& name) {
    for (const PortDesc* port : written_ports(desc)) {
        if (names_this_frames(*port, name)) return port;
    }
    return nullptr;
}

// Whether a pass leaves the version before it visible, as far as its description tells.
bool passes_on(const PassDesc& desc, const std::string& name) {
    const PortDesc* out = output_of(desc, name);
    if (!out || desc.partial || !out->ref.pass.empty() || desc.type == "raster") return true;
    const bool reads_it =
        std::ranges::any_of(desc.in, [&](const PortDesc& in) { return names_this_frames(in, name); });
    return reads_it || blend_of(desc, out->port).enabled;
}

// The pass that a dropped one pins itself.
const std::string* own_pin(const PassDesc& desc, const std::string& name) {
    for (const std::vector<PortDesc>* ports : {&desc.in, &desc.out}) {
        for (const PortDesc& port : *ports) {
            if (names_this_frames(port, name) && !port.ref.pass.empty()) return &port.ref.pass;
        }
    }
    return nullptr;
}

// Names of the passes, but `except`, that write a resource.
std::set<std::string> writers_of(const ResolveState& state, const BoundPorts& outputs,
                                 const std::string& resource, PassId except) {
    std::set<std::string> names;
    for (PassId pass = 0; pass < outputs.size(); ++pass) {
        if (state.author_name(pass) == state.author_name(except)) continue;
        for (const BoundPort& port : outputs[pass]) {
            if (state.resource_name(port.use.resource) == resource) names.insert(state.author_name(pass));
        }
    }
    return names;
}

bool share_mips_and_layers(const SubresourceRange& a, const SubresourceRange& b) {
    return a.mip < b.mip + b.mips && b.mip < a.mip + a.mips && a.layer < b.layer + b.layers &&
           b.layer < a.layer + a.layers;
}

}  // namespace

const PassDesc* dropped_writer(const ResolveState& state, const std::string& name) {
    for (const auto& [unused, desc] : state.dropped) {
        state.spend(1 + desc->out.size(), desc->loc);
        if (output_of(*desc, name)) return desc;
    }
    return nullptr;
}

void resolve_pins(const ResolveState& state, PassId pass, const RefDesc& ref, const BoundPorts& outputs,
                  BoundPort& port) {
    const std::string* name = &ref.pass;
    // Dropped passes may pin each other in a circle.
    for (size_t steps = 0; steps <= state.dropped.size(); ++steps) {
        const std::vector<PassId>& pins = state.instances.at(*name);
        state.spend(1 + pins.size(), ref.loc);
        port.work.pins = pins;
        if (port.work.pinned()) return;
        const PassDesc& dropped = *state.dropped.at(*name);
        if (!passes_on(dropped, ref.name)) break;
        if (const std::string* next = own_pin(dropped, ref.name)) {
            if (!state.instances.contains(*next)) break;
            name = next;
            continue;
        }
        state.spend(outputs.size() + state.tried_ports, ref.loc);
        const std::set<std::string> writers = writers_of(state, outputs, ref.name, pass);
        if (writers.size() == 1) port.work.pins = state.instances.at(*writers.begin());
        const bool before = writers.empty() && state.resources[port.use.resource].has_content;
        port.pin_is_gone = writers.size() != 1 && !before;
        return;
    }
    port.pin_is_gone = true;
}

bool is_present(const ResolveState& state, PassId pass, const BoundPort& input, const BoundPorts& outputs) {
    if (input.pin_is_gone) return false;
    const ResourceWork& resource = state.resources[input.use.resource];
    if (resource.has_content || resource.suspect_writers) return true;
    if (!dropped_writer(state, state.resource_name(input.use.resource))) return true;
    for (PassId writer = 0; writer < outputs.size(); ++writer) {
        state.spend(1 + outputs[writer].size(), input.use.loc);
        if (writer == pass) continue;
        for (const BoundPort& output : outputs[writer]) {
            if (output.use.resource == input.use.resource &&
                share_mips_and_layers(output.use.range, input.use.range))
                return true;
        }
    }
    return false;
}

void report_absent(ResolveState& state, PassId pass, const PortDesc& port) {
    const bool pinned = state.dropped.contains(port.ref.pass);
    const PassDesc* writer = pinned ? state.dropped.at(port.ref.pass) : dropped_writer(state, port.ref.name);
    const std::string who = state.observers.contains(state.pass_name(pass))
                                ? "the observer"
                                : "pass " + quoted(state.pass_name(pass));
    std::string why = pinned ? ", and that pass is left out" : ", but nobody who is left writes it";
    if (writer) {
        why = (pinned ? ", but " : ", which only ") + quoted(writer->name) +
              (pinned ? " is left out" : " writes, and that pass is left out");
        why += writer->condition.empty() ? ": its repeat is empty" : ": its \"if\" is false";
    }
    Diagnostic& d =
        state.pass_error(pass, port.ref.loc, "W123", who + " reads " + quoted(port.ref.text) + why);
    if (writer) {
        const SourceLoc loc = writer->condition.empty() ? writer->loc : writer->condition.loc;
        const Diagnostic place = state.input.graph.sources.error(loc, "", "");
        if (place.line != 0) d.notes.push_back({place.file, place.line, place.column, "left out here"});
    }
    if (state.observers.contains(state.pass_name(pass)))
        return add_help(d, "it is unavailable as the parameters stand");
    add_help(d, "say what to read instead: { \"ref\": " + quoted(port.ref.text) + ", \"else\": \"name\" }");
    add_help(d, "or declare HAS_" + port.port + " in the shader and make the port \"optional\": true");
    if (writer && !writer->condition.empty() && writer->repeat.empty())
        add_help(d, "or leave this pass out too: \"if\": " + quoted(writer->condition.text));
}

}  // namespace weft
