#include "graph/resolve/bind/presence.h"

#include <algorithm>

#include "graph/resolve/dropped_writer.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/switches/switches_text.h"

namespace weft {
namespace {

// Returns true if a part of the previous version of the resource `name` would stay visible if the removed
// pass ran, for example because the pass blends or is "partial". Reads only the description of the pass,
// because a removed pass has no bound ports.
bool passes_on(const PassDesc& desc, const std::string& name) {
    const PortDesc* out = output_of(desc, name);
    if (!out || desc.partial || !out->ref.pass.empty() || desc.type == "raster") return true;
    const bool reads_it =
        std::ranges::any_of(desc.in, [&](const PortDesc& in) { return names_this_frames(in, name); });
    return reads_it || blend_of(desc, out->port).enabled;
}

// A removed pass may itself use the resource `name` with an `@pass`, for example "color@fog". Returns the
// name of the pass in that reference ("fog"), or null if there is no such reference.
const std::string* own_pin(const PassDesc& desc, const std::string& name) {
    for (const std::vector<PortDesc>* ports : {&desc.in, &desc.out}) {
        for (const PortDesc& port : *ports) {
            if (names_this_frames(port, name) && !port.ref.pass.empty()) return &port.ref.pass;
        }
    }
    return nullptr;
}

// Returns true if both uses, which belong to one resource, use the same mip and layer, or the same bytes.
bool share_a_part(const UseDecl& one, const UseDecl& other) {
    if (one.bytes && other.bytes)
        return one.bytes->offset_bytes < other.bytes->end_bytes() &&
               other.bytes->offset_bytes < one.bytes->end_bytes();
    const SubresourceRange& a = one.range;
    const SubresourceRange& b = other.range;
    return a.mip < b.mip + b.mips && b.mip < a.mip + a.mips && a.layer < b.layer + b.layers &&
           b.layer < a.layer + a.layers;
}

// Returns the reason why the inputs of the pass cannot depend on switches, or an empty text if they can.
std::string why_without_variants(const PassDraft& draft, const PortDesc& port) {
    const PassDesc& desc = *draft.desc;
    if (desc.rests) return "has \"rest\"";
    if (!desc.group.empty()) return "belongs to a group";
    if (!draft.is_observer && !has_shader(draft.decl.kind))
        return "is a " + desc.type + " pass, which has no shader";
    const bool counts =
        (desc.indirect && &port == &*desc.indirect) || (desc.draw_count && &port == &*desc.draw_count);
    return counts ? "reads numbers of draws or workgroups from the port" : "";
}

}  // namespace

Presence::Presence(const Declared& declared, const BoundPorts& outputs, const Suspects& suspects,
                   PassReporter& report, Reporter& reporter)
    : declared_(declared), outputs_(outputs), suspects_(suspects), report_(report), reporter_(reporter) {
    writers_.resize(declared.shapes.resources.size());
    for (PassId pass(0); pass < outputs.size(); ++pass) {
        for (const BoundPort& output : outputs[pass])
            if (output.use.resource < writers_.size())
                writers_[output.use.resource].push_back({pass, &output.use});
    }
}

std::set<std::string> Presence::writers_of(const std::string& resource, PassId except) const {
    std::set<std::string> names;
    for (PassId pass(0); pass < outputs_.size(); ++pass) {
        if (declared_.author_name(pass) == declared_.author_name(except)) continue;
        if (declared_.expansion.passes[pass].decl.carries) continue;
        for (const BoundPort& port : outputs_[pass]) {
            if (declared_.resource_name(port.use.resource) == resource)
                names.insert(declared_.author_name(pass));
        }
    }
    return names;
}

void Presence::find_pins(PassId pass, const RefDesc& ref, BoundPort& port) const {
    const Expansion& expansion = declared_.expansion;
    const std::string* name = &ref.pass;
    // Limits the number of iterations, because removed passes may refer to each other with `@pass` in a
    // cycle.
    for (size_t steps = 0; steps <= expansion.dropped.size(); ++steps) {
        const std::vector<PassId>& pins = expansion.instances.at(*name);
        reporter_.spend(1 + pins.size(), ref.loc);
        port.draft.pins = pins;
        std::erase_if(port.draft.pins, [&](PassId pin) {
            return in_other_round(expansion.passes[pin], expansion.passes[pass]);
        });
        if (port.draft.pinned()) return;
        // The "if" or "repeat" of the pass has a fault, which is reported.
        const auto found = expansion.dropped.find(*name);
        if (found == expansion.dropped.end()) return;
        const PassDesc& dropped = *found->second;
        if (!passes_on(dropped, ref.name)) break;
        if (const std::string* next = own_pin(dropped, ref.name)) {
            if (!expansion.instances.contains(*next)) break;
            name = next;
            continue;
        }
        reporter_.spend(outputs_.size() + expansion.tried_ports, ref.loc);
        const std::set<std::string> writers = writers_of(ref.name, pass);
        if (writers.size() == 1) port.draft.pins = expansion.instances.at(*writers.begin());
        const bool before = writers.empty() && declared_.shapes.origins[port.use.resource].has_content;
        port.pin_is_gone = writers.size() != 1 && !before;
        return;
    }
    port.pin_is_gone = true;
}

bool Presence::is_present(PassId pass, const BoundPort& input, bool optional) const {
    if (input.pin_is_gone) return false;
    const ResourceId resource = input.use.resource;
    const ResourceDecl& decl = declared_.shapes.resources[resource];
    // An optional port does not read a resource with `keep` that no pass of the graph writes.
    const bool is_kept =
        optional && decl.lifetime == ResourceLifetime::persistent && decl.history == 0 && decl.age == 0;
    if (suspects_.writers[resource]) return true;
    if (declared_.shapes.origins[resource].has_content && !is_kept) return true;
    if (!dropped_writer(declared_.expansion, declared_.resource_name(resource), reporter_)) return true;
    reporter_.spend(1 + writers_[resource].size(), input.use.loc);
    return std::ranges::any_of(writers_[resource], [&](const Writer& writer) {
        return writer.pass != pass && share_a_part(*writer.use, input.use);
    });
}

CombinationSet Presence::present_in(PassId pass, const BoundPort& input) const {
    const Expansion& expansion = declared_.expansion;
    const ResourceId resource = input.use.resource;
    if (expansion.switches.empty() || declared_.shapes.origins[resource].has_content ||
        suspects_.writers[resource])
        return kEveryCombination;
    // `named`: the combinations of switch values in which a pass runs whose name stands after `@`. `others`:
    // the combinations in which other writers of the resource run. If the named passes are off, the version
    // of another writer may stay visible.
    CombinationSet named = 0, others = 0;
    std::set<std::string> other_names;
    bool passes_version_on = input.draft.pins.empty(), any = false;
    reporter_.spend(1 + writers_[resource].size(), input.use.loc);
    for (const Writer& writer : writers_[resource]) {
        if (writer.pass == pass || !share_a_part(*writer.use, input.use)) continue;
        any = true;
        const PassDraft& draft = expansion.passes[writer.pass];
        if (std::ranges::find(input.draft.pins, writer.pass) != input.draft.pins.end()) {
            named = static_cast<CombinationSet>(named | draft.decl.runs_in);
            passes_version_on |= passes_on(*draft.desc, declared_.resource_name(resource));
        } else {
            others = static_cast<CombinationSet>(others | draft.decl.runs_in);
            other_names.insert(draft.desc->name);
        }
    }
    if (!any) return kEveryCombination;  // version() reports that no pass writes the resource.
    const bool sees_others = passes_version_on || other_names.size() == 1 || named == 0;
    return static_cast<CombinationSet>(named | (sees_others ? others : 0));
}

bool Presence::can_depend(PassId pass, const PortDesc& port) const {
    const PassDraft& draft = declared_.expansion.passes[pass];
    return !draft.is_observer && why_without_variants(draft, port).empty();
}

void Presence::report_switched_off(PassId pass, const PortDesc& port, CombinationSet absent) const {
    const Expansion& expansion = declared_.expansion;
    const PassDraft& draft = expansion.passes[pass];
    const std::string without = why_without_variants(draft, port);
    if (!without.empty() && (port.otherwise || port.optional)) {
        Diagnostic& d = report_.error(pass, port.ref.loc, "W235",
                                      name_reader(draft) + " " + without + ", so its port " +
                                          quote(port.port) + " cannot depend on a switch");
        add_help(d, "let a pass that always runs write " + quote(port.ref.name) +
                        " before the pass with the switch");
        add_help(d, "or keep the last content: add \"keep\": true to " + quote(port.ref.name));
        return;
    }
    if (port.otherwise) return report_replacement_off(draft, pass, port, absent);
    Diagnostic& d =
        report_.error(pass, port.ref.loc, "W234",
                      name_reader(draft) + " reads " + quote(port.ref.text) + ", but in frames in which " +
                          switches_text(expansion.switches, absent) + ", no pass writes it");
    add_help(d, "keep the last content: add \"keep\": true to " + quote(port.ref.name) +
                    "; or let a pass that always runs write it before");
    if (draft.is_observer) return;
    add_help(d, "or turn this pass off together with the pass that writes " + quote(port.ref.name) +
                    ": give both the same \"switch\"");
    if (!without.empty()) return;
    add_help(d, "or name a replacement: { \"ref\": " + quote(port.ref.text) + ", \"else\": \"name\" }");
    add_help(d, "or declare HAS_" + port.port + " in the shader and make the port \"optional\": true");
}

void Presence::report_replacement_off(const PassDraft& draft, PassId pass, const PortDesc& port,
                                      CombinationSet absent) const {
    const RefDesc& other = *port.otherwise;
    Diagnostic& d = report_.error(pass, other.loc, "W234",
                                  name_reader(draft) + " reads " + quote(other.text) + " if no pass writes " +
                                      quote(port.ref.text) + ", but in frames in which " +
                                      switches_text(declared_.expansion.switches, absent) +
                                      ", no pass writes either of the two");
    add_help(d, "name another replacement in \"else\": a resource that is written whenever " +
                    quote(port.ref.text) + " is not");
    add_help(d, "or keep the last content: add \"keep\": true to " + quote(other.name));
    add_help(d, "or declare HAS_" + port.port + " in the shader and make the port \"optional\": true");
}

void Presence::report_absent(PassId pass, const PortDesc& port) const {
    const Expansion& expansion = declared_.expansion;
    const bool pinned = expansion.dropped.contains(port.ref.pass);
    const PassDesc* writer =
        pinned ? expansion.dropped.at(port.ref.pass) : dropped_writer(expansion, port.ref.name, reporter_);
    const PassDraft& draft = expansion.passes[pass];
    std::string why = pinned ? ", but that pass is removed" : ", but no remaining pass writes it";
    if (writer) {
        why = (pinned ? ", but " : ", which only ") + quote(writer->name) +
              (pinned ? " is removed" : " writes, and that pass is removed");
        why += !writer->condition.empty() ? ": its \"if\" is false"
               : writer->view_target == ViewTarget::one
                   ? ": its repeat is empty"
                   : ": its list of views " + quote(writer->view) + " is empty";
    }
    Diagnostic& d = report_.error(pass, port.ref.loc, "W123",
                                  name_reader(draft) + " reads " + quote(port.ref.text) + why);
    if (writer) {
        const SourceLoc loc = writer->condition.empty() ? writer->loc : writer->condition.loc;
        add_note(d, reporter_.sources(), loc, "the pass is removed here");
    }
    if (draft.is_observer)
        return add_help(d, "change the parameters: with the current values no pass writes the resource");
    if (port.port.starts_with(kViewPort))
        return add_help(d, "remove the passes that draw these views with the same condition");
    add_help(d, "name a replacement: { \"ref\": " + quote(port.ref.text) + ", \"else\": \"name\" }");
    if (draft.shader)
        add_help(d, "or declare HAS_" + port.port + " in the shader and make the port \"optional\": true");
    if (writer && !writer->condition.empty() && writer->repeat.empty())
        add_help(d, "or remove this pass with the same condition: \"if\": " + quote(writer->condition.text));
}

}  // namespace weft
