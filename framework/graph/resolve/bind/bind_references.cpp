#include "graph/resolve/bind/bind_references.h"

#include <algorithm>

#include "graph/parse/reference.h"
#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/bind/divide_buffers.h"
#include "graph/resolve/bind/find_range.h"
#include "graph/resolve/bind/find_role.h"
#include "graph/resolve/bind/presence.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/shape/shape_imports.h"

namespace weft {
namespace {

class ReferenceBinder {
 public:
    ReferenceBinder(const Declared& declared, Reporter& reporter)
        : declared_(declared),
          reporter_(reporter),
          report_(declared.shapes, declared.expansion, result_.suspects, reporter),
          roles_(declared, report_, reporter) {
        result_.passes.resize(declared.expansion.passes.size());
        result_.suspects = declared.expansion.suspects;
    }

    BoundPasses run() {
        const auto count = static_cast<PassId>(result_.passes.size());
        BoundPorts outputs;
        outputs.reserve(count);
        for (PassId id(0); id < count; ++id) outputs.push_back(bind_outputs(id));
        const Presence presence(declared_, outputs, result_.suspects, report_, reporter_);
        for (PassId id(0); id < count; ++id) {
            for (BoundPort& output : outputs[id]) {
                const RefDesc& ref = output.draft.desc->ref;
                if (!ref.pass.empty()) presence.find_pins(id, ref, output);
            }
        }
        BoundPorts inputs;
        inputs.reserve(count);
        for (PassId id(0); id < count; ++id) inputs.push_back(bind_inputs(id, presence));
        for (PassId id(0); id < count; ++id) {
            store_ports(id, inputs[id]);
            store_ports(id, outputs[id]);
        }
        divide_buffers(declared_, result_, reporter_);
        return std::move(result_);
    }

 private:
    // Called when the name of an output is misspelt. Marks the resources with similar names as suspect,
    // because the author may have meant to write one of them. So the passes that read these resources cause
    // no error W110 (no pass writes the resource).
    void suspect_near_names(const std::vector<std::string>& near_names) {
        for (const std::string& near : near_names)
            result_.suspects.writers[resource_id(declared_.shapes.resources, near)] = 1;
    }

    // Returns true if `name` is probably an import that is misspelt in "imports" of the graph: the program
    // offers an import `name`, but "imports" contains only a similar name. The error about that similar name
    // was already reported. So this function only marks the pass as suspect.
    bool means_faulty_import(PassId pass, const std::string& name,
                             const std::vector<std::string>& near_names) {
        for (const std::string& near : near_names) {
            const ResourceId id = resource_id(declared_.shapes.resources, near);
            const bool is_import = !declared_.shapes.origins[id].desc;
            if (!is_import || !result_.suspects.shapes[id] || !declared_.input.imports.imports.contains(name))
                continue;
            result_.suspects.passes[pass] = 1;
            return true;
        }
        return false;
    }

    // Returns the names of the resources that the pass may use. Resources of other groups are left out.
    [[nodiscard]] std::vector<std::string> visible_resources(const PassDraft& draft) const {
        std::vector<std::string> names = resource_names(declared_.shapes.resources);
        std::erase_if(names, [&](const std::string& name) {
            const ResourceId id = resource_id(declared_.shapes.resources, name);
            const ResourceDesc* desc = declared_.shapes.origins[id].desc;
            return desc != nullptr && !desc->group.empty() && desc->group != draft.desc->group;
        });
        return names;
    }

    // Returns a help text if a group has a resource of this name, else an empty text.
    [[nodiscard]] std::string group_help(const std::string& name) const {
        for (const ResourceOrigin& origin : declared_.shapes.origins)
            if (origin.desc != nullptr && !origin.desc->group.empty() &&
                origin.desc->name == name_in_group(origin.desc->group, name))
                return "the resource " + quote(name) + " of group " + quote(origin.desc->group) +
                       " exists only for the passes of this group: move it to the \"resources\" of the graph "
                       "and add \"keep\": true, or move the pass into the group";
        return {};
    }

    ResourceId find_port_resource(PassId pass, const RefDesc& ref, bool is_output) {
        const ResourceId id = resource_id(declared_.shapes.resources, ref.name);
        if (id != kNoId) return id;
        const std::vector<std::string> near_names =
            did_you_mean(ref.name, visible_resources(declared_.expansion.passes[pass]));
        if (means_faulty_import(pass, ref.name, near_names)) return kNoId;
        const std::string verb = is_output ? " writes " : " reads ";
        const std::string who = name_reader(declared_.expansion.passes[pass]) + verb;
        const auto import = declared_.input.graph.imports.find(ref.name);
        if (import != declared_.input.graph.imports.end()) {
            const bool turns = is_turns(import->second), views = is_view_list(import->second);
            Diagnostic& d = report_.error(pass, ref.loc, "W103",
                                          who + quote(ref.name) + ", which is " +
                                              (turns   ? "a list of turns"
                                               : views ? "a list of views"
                                                       : "a draw list"));
            add_help(d, turns   ? "name lists of turns in \"turns\" of a group"
                        : views ? "name lists of views in \"view\" or \"views\" of a pass"
                                : "name draw lists in \"draws\" of a raster pass");
            return kNoId;
        }
        Diagnostic& d = report_.error(pass, ref.loc, "W103", who + "unknown resource " + quote(ref.name));
        if (const std::string help = group_help(ref.name); !help.empty()) {
            add_help(d, help);
            return kNoId;
        }
        const std::string near = did_you_mean_text(near_names);
        add_help(d, near.empty() ? "declare the resource in \"resources\", or import it" : near);
        if (is_output) suspect_near_names(near_names);
        return kNoId;
    }

    // Checks the pass that a reference names with `@pass`. Returns false if an error was reported, now or
    // earlier.
    bool check_pin(PassId pass, const RefDesc& ref) {
        if (ref.pass == declared_.author_name(pass) &&
            declared_.expansion.passes[pass].desc->repeat.empty()) {
            Diagnostic& d = report_.error(
                pass, ref.loc, "W104",
                "pass " + quote(ref.pass) +
                    " names itself after @, but a pass cannot read its own result of " + quote(ref.name));
            add_help(d, "name the earlier pass whose result this pass reads");
            return false;
        }
        if (declared_.expansion.faulty.contains(ref.pass)) {
            result_.suspects.passes[pass] = 1;
            return false;
        }
        if (ref.pass.empty() || declared_.expansion.instances.contains(ref.pass)) return true;
        Diagnostic& d =
            report_.error(pass, ref.loc, "W104", quote(ref.text) + " names unknown pass " + quote(ref.pass));
        const std::string near = did_you_mean_text(ref.pass, list_pass_names(declared_.input.graph));
        add_help(d,
                 near.empty() ? "the passes are " + quote_all(list_pass_names(declared_.input.graph)) : near);
        return false;
    }

    // Binds one reference of a port: `ref` is the port's own reference, or the reference in its "else".
    // Returns nullopt if an error was reported, now or earlier.
    std::optional<BoundPort> bind_reference(PassId pass, const PortDesc& port, const RefDesc& ref,
                                            bool is_output) {
        const ResourceId named = find_port_resource(pass, ref, is_output);
        if (named == kNoId) return std::nullopt;
        const ResourceId resource = roles_.find(pass, ref, named, is_output);
        if (resource == kNoId) {
            if (is_output) result_.suspects.writers[named] = 1;
            return std::nullopt;
        }
        if (!check_pin(pass, ref) || result_.suspects.shapes[resource]) {
            // The port is not bound. If it is an output, the pass does write this resource, but the written
            // range is unknown.
            result_.suspects.passes[pass] = 1;
            if (is_output) result_.suspects.writers[resource] = 1;
            return std::nullopt;
        }
        const std::optional<FoundRange> range =
            find_range(pass, ref, declared_.shapes.resources[resource],
                       declared_.evaluator(pass, result_.suspects, reporter_), result_.suspects, report_);
        if (!range) {
            if (is_output) result_.suspects.writers[resource] = 1;
            return std::nullopt;
        }
        BoundPort bound;
        bound.draft.desc = &port;
        bound.use.port = port.port;
        bound.use.resource = resource;
        bound.use.range = range->range;
        bound.use.bytes = range->bytes;
        bound.use.each = port.each;
        bound.use.history = ref.history;
        bound.use.is_output = is_output;
        bound.use.loc = ref.loc;
        if (port.sampler) bound.use.sampler = *port.sampler;
        bound.use.wakes = port.wakes;
        return bound;
    }

    // Selects layers if the port is an attachment of a pass with "views": the layer of the view that the pass
    // draws, or the layers of all its views. If the reference itself selects a layer, this layer is kept. For
    // a pass that draws several views, the selected layer is then the layer of the first view. Returns false
    // after reporting an error.
    bool select_layer(PassId pass, BoundPort& port) {
        const PassDraft& draft = declared_.expansion.passes[pass];
        const std::string& name = port.use.port;
        const bool is_color = draft.shader != nullptr &&
                              std::ranges::any_of(draft.shader->fragment_outputs,
                                                  [&](const auto& output) { return output.name == name; });
        if (!is_color && !port.draft.is_depth_port && !port.draft.is_resolve) return true;
        const ResourceDecl& resource = declared_.shapes.resources[port.use.resource];
        if (resource.kind != ResourceKind::image) return true;
        const uint32_t views = std::max(draft.views, 1u);
        if (port.draft.desc->ref.layer_first) {
            if (draft.views > 0) port.use.range.layers = views;
            return true;
        }
        const auto view = static_cast<uint32_t>(draft.indices.at(kViewIndex));
        if (view < resource.layers && views <= resource.layers) {
            port.use.range.layer = view;
            port.use.range.layers = views;
            return true;
        }
        Diagnostic& d = report_.error(pass, port.use.loc, "W192",
                                      "pass " + quote(draft.desc->name) + " draws " +
                                          std::to_string(declared_.values.views.at(draft.desc->view).count) +
                                          " views, but " + quote(resource.name) + " has only " +
                                          std::to_string(resource.layers) +
                                          (resource.layers == 1 ? " layer" : " layers"));
        add_help(d, "give the image one layer for each view: \"layers\": \"" + draft.desc->view + "Views\"");
        add_help(d, "or let each view draw to a rectangle of the image: \"into\": \"rects\"");
        result_.suspects.writers[port.use.resource] = 1;
        return false;
    }

    std::vector<BoundPort> bind_outputs(PassId id) {
        const PassDesc& desc = *declared_.expansion.passes[id].desc;
        std::vector<BoundPort> ports;
        for (const PortDesc* port : written_ports(desc)) {
            std::optional<BoundPort> bound = bind_reference(id, *port, port->ref, true);
            if (!bound) continue;
            bound->draft.is_depth_port = desc.depth && port == &*desc.depth;
            bound->draft.is_resolve = std::ranges::any_of(
                desc.resolves, [&](const ResolveDesc& resolve) { return port == &resolve.target; });
            if (desc.view_target == ViewTarget::layers && !select_layer(id, *bound)) continue;
            ports.push_back(std::move(*bound));
        }
        return ports;
    }

    // Binds an input to the resource that its reference names. If all writers of that resource are removed
    // (by `if`, or because their repeat is empty), binds the input to the reference in its "else" instead.
    // Without an "else", an optional port stays unbound, and for any other port an error is reported. If
    // switches turn all writers off in some frames, the input is bound to both references. Each of the two
    // uses stores the combinations of switch values in which the pass reads it.
    void add_input(PassId pass, const PortDesc& port, const Presence& presence,
                   std::vector<BoundPort>& ports) {
        const CombinationSet runs_in = declared_.expansion.passes[pass].decl.runs_in;
        bool found = false;    // True: a pass of the graph writes one of the references.
        bool depends = false;  // True: the switches decide which reference the port reads.
        // The combinations of switch values for which the port has no use yet.
        CombinationSet missing = kEveryCombination;
        for (const RefDesc* ref : {&port.ref, port.otherwise ? &*port.otherwise : nullptr}) {
            if (!ref) break;
            std::optional<BoundPort> bound = bind_reference(pass, port, *ref, false);
            if (!bound) return;
            if (!ref->pass.empty()) presence.find_pins(pass, *ref, *bound);
            if (!presence.is_present(pass, *bound, port.optional)) continue;
            const CombinationSet present = presence.present_in(pass, *bound);
            found = true;
            if ((present & missing & runs_in) == 0) continue;
            const bool is_last = (missing & runs_in & ~present) == 0;
            bound->use.used_in = is_last ? missing : static_cast<CombinationSet>(present & missing);
            missing = static_cast<CombinationSet>(missing & ~bound->use.used_in);
            depends |= bound->use.used_in != kEveryCombination;
            ports.push_back(std::move(*bound));
            if (is_last) break;
        }
        const auto absent = static_cast<CombinationSet>(missing & runs_in);
        if (missing == kEveryCombination && port.optional)
            result_.passes[pass].absent.push_back(port.port);
        else if (missing == kEveryCombination && !found)
            presence.report_absent(pass, port);
        else if ((absent != 0 && !port.optional) || (depends && !presence.can_depend(pass, port)))
            presence.report_switched_off(pass, port, absent);
    }

    // Sorts `ports` by name, and appends them to the bound ports of the pass.
    void store_ports(PassId id, std::vector<BoundPort>& ports) {
        std::ranges::stable_sort(ports, {}, [](const BoundPort& p) { return std::string_view(p.use.port); });
        for (BoundPort& port : ports) {
            result_.passes[id].uses.push_back(std::move(port.use));
            result_.passes[id].ports.push_back(std::move(port.draft));
        }
    }

    std::vector<BoundPort> bind_inputs(PassId id, const Presence& presence) {
        std::vector<BoundPort> ports;
        const PassDesc& desc = *declared_.expansion.passes[id].desc;
        for (const PortDesc& port : desc.in) add_input(id, port, presence, ports);
        const auto add = [&](const std::optional<PortDesc>& port, bool PortDraft::*role) {
            if (!port) return;
            const size_t before = ports.size();
            add_input(id, *port, presence, ports);
            if (ports.size() > before) ports.back().draft.*role = true;
        };
        add(desc.indirect, &PortDraft::is_indirect);
        add(desc.draw_count, &PortDraft::is_draw_count);
        if (has_shader(declared_.expansion.passes[id].decl.kind)) add_view(id, presence, ports);
        return ports;
    }

    // Finds the view of the pass. If the shader reads the view from a buffer, adds this buffer as an input of
    // the pass.
    void add_view(PassId id, const Presence& presence, std::vector<BoundPort>& ports) {
        PassBinding pass = pass_binding(declared_, id, result_, report_, reporter_);
        const std::optional<BufferView> view = bind_view(pass);
        const size_t before = ports.size();
        if (view) add_input(id, *view->port, presence, ports);
        if (ports.size() == before) return;
        ports.back().draft.is_view = true;
        if (!select_view_element(pass, *view, ports.back().use)) ports.pop_back();
    }

    const Declared& declared_;
    Reporter& reporter_;
    BoundPasses result_;
    PassReporter report_;
    RoleFinder roles_;
};

}  // namespace

BoundPasses bind_references(const Declared& declared, Reporter& reporter) {
    return ReferenceBinder(declared, reporter).run();
}

}  // namespace weft
