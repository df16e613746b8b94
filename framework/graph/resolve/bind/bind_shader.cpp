// Binds the ports of a pass to the bindings of its shader. The formats of images are not known in this stage,
// so check_interfaces() later checks that they fit.
#include <algorithm>

#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/bind/check_array.h"
#include "graph/resolve/bind/check_table.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/pass_ports.h"

namespace weft {
namespace {

constexpr std::string_view kParamsBlock = "Params";

bool is_port(const ShaderBinding& binding) {
    return binding.set == kPortSet && binding.name != kParamsBlock;
}

bool is_buffer(BindingKind kind) {
    return kind == BindingKind::uniform_buffer || kind == BindingKind::storage_buffer;
}

bool is_storage(BindingKind kind) {
    return kind == BindingKind::storage_image || kind == BindingKind::storage_buffer;
}

class ShaderBinder {
 public:
    explicit ShaderBinder(PassBinding& pass) : at_(pass) {}

    void run() {
        merge_ports_named_twice();
        for (size_t i = 0; i < at_.bound.uses.size(); ++i) bind(at_.bound.uses[i], at_.bound.ports[i]);
        report_bindings_without_port();
    }

 private:
    const PassDesc& desc() const { return *at_.draft.desc; }

    static bool is_bound(const PortDraft& port) {
        return !port.is_depth_port && !port.is_resolve && !port.is_indirect && !port.is_draw_count &&
               !port.is_view;
    }

    // Returns the index of the output with the same name as the input `in`, or the number of uses if there is
    // none. Ignores depth attachments, resolve targets and indirect buffers. They are not bindings of the
    // shader, so another port may have the same name.
    size_t output_of_same_name(size_t in) const {
        size_t out = 0;
        for (; out < at_.bound.uses.size(); ++out) {
            const bool binding = at_.bound.uses[out].is_output && is_bound(at_.bound.ports[out]);
            if (!at_.bound.uses[in].is_output && is_bound(at_.bound.ports[in]) && binding &&
                at_.bound.uses[out].port == at_.bound.uses[in].port)
                break;
        }
        return out;
    }

    // If "in" and "out" contain a port of the same name, the two ports are one binding of the shader, which
    // is read and written in place. Merges them into one port.
    void merge_ports_named_twice() {
        for (size_t in = 0; in < at_.bound.uses.size();) {
            const size_t out_index = output_of_same_name(in);
            if (out_index == at_.bound.uses.size()) {
                ++in;
                continue;
            }
            const auto out = at_.bound.uses.begin() + static_cast<std::ptrdiff_t>(out_index);
            if (out->resource != at_.bound.uses[in].resource || out->range != at_.bound.uses[in].range ||
                out->each != at_.bound.uses[in].each) {
                Diagnostic& d =
                    at_.error(out->loc, "W165",
                              "port " + quote(out->port) + " of pass " + quote(at_.draft.decl.name) +
                                  " is bound to two different resources");
                add_help(
                    d,
                    "give input and output the same reference, or different names: each name is one binding "
                    "of the shader");
            }
            PortDraft& port = at_.bound.ports[out_index];
            if (!port.pinned()) port.pins = at_.bound.ports[in].pins;
            port.reads_own_port = true;
            at_.bound.uses.erase(at_.bound.uses.begin() + static_cast<std::ptrdiff_t>(in));
            at_.bound.ports.erase(at_.bound.ports.begin() + static_cast<std::ptrdiff_t>(in));
        }
    }

    const ShaderBinding* find_binding(const UseDecl& use) const {
        const auto& bindings = at_.draft.shader->bindings;
        const auto found = std::ranges::find_if(
            bindings, [&](const ShaderBinding& b) { return is_port(b) && b.name == use.port; });
        return found == bindings.end() ? nullptr : &*found;
    }

    void bind_table(UseDecl& use, PortDraft& port) {
        const ShaderBinding* binding = is_bound(port) ? find_binding(use) : nullptr;
        if (binding == nullptr && is_bound(port) && !use.is_output) return report_no_binding(use, port);
        if (!check_table(at_, use, binding)) return;
        port.binding = binding;
        use.binding = binding->binding;
        use.access = Access::sampled_read;
    }

    void bind(UseDecl& use, PortDraft& port) {
        if (is_table(at_, use)) return bind_table(use, port);
        if (use.each != EachPart::none && !is_bound(port)) return report_no_array(at_, use, port);
        if (port.is_depth_port) return bind_depth(use, port);
        if (port.is_view) {
            port.binding = find_view_block(*at_.draft.shader);
            use.access = Access::uniform_read;
            return;
        }
        if (!is_bound(port)) {
            use.access = port.is_resolve ? Access::color_write : Access::indirect_read;
            return;
        }
        if (use.is_output && at_.draft.decl.kind != PassKind::compute && bind_color(use, port)) return;
        const ShaderBinding* found = find_binding(use);
        if (found == nullptr) return report_no_binding(use, port);
        port.binding = found;
        use.binding = found->binding;
        if (!check_direction(use, *found) || !check_array(at_, use, port, *found)) return;
        use.access = access_of(use, port, *found);
    }

    bool bind_color(UseDecl& use, PortDraft& port) {
        const auto& outputs = at_.draft.shader->fragment_outputs;
        const auto found = std::ranges::find(outputs, use.port, &StageVariable::name);
        if (found == outputs.end()) return false;
        if (use.each != EachPart::none) report_no_array(at_, use, port);
        port.color_output = &*found;
        const BlendState blend = blend_of(desc(), use.port);
        const bool cleared = clears(use.port);
        const bool keeps_part = blend.enabled || blend.write_mask != 0xF || desc().partial || port.pinned();
        // The single triangle of a fullscreen pass writes every texel unless its state or its shader may
        // leave texels out.
        const bool covered = desc().covers || fullscreen_covers();
        use.access = Access::color_write;
        if (cleared) {
            port.rank = WriteRank::fresh;
        } else if (keeps_part) {
            port.rank = WriteRank::in_place;
        } else {
            port.rank = covered ? WriteRank::fresh : WriteRank::resumes;
        }
        return true;
    }

    bool fullscreen_covers() const {
        const RasterState& s = desc().state;
        const bool whole_triangle =
            s.cull == CullMode::none && s.fill == FillMode::fill &&
            (s.topology == Topology::triangles || s.topology == Topology::triangle_strip);
        return at_.draft.decl.kind == PassKind::fullscreen && whole_triangle && !at_.draft.shader->discards &&
               !s.depth_test && !s.stencil_test && !s.scissor && !s.viewport && !s.alpha_to_coverage;
    }

    // Returns true if a pass with "into": "rects" draws a view other than the first. Such a pass must keep
    // the rectangles of the earlier views, so only the pass of the first view clears.
    bool is_later_rect() const {
        return desc().view_target == ViewTarget::rects && at_.draft.indices.at(kViewIndex) > 0;
    }

    bool clears(const std::string& port) const {
        return (desc().clear || desc().clear_ports.contains(port)) && !is_later_rect();
    }

    void bind_depth(UseDecl& use, PortDraft& port) {
        const RasterState& s = desc().state;
        const auto changes = [](const StencilFaceState& f) {
            return f.write_mask != 0 && (f.fail != StencilOp::keep || f.depth_fail != StencilOp::keep ||
                                         f.pass != StencilOp::keep);
        };
        const bool writes_stencil = s.stencil_test && (changes(s.stencil_front) || changes(s.stencil_back));
        if (!s.depth_test && !s.depth_write && !s.stencil_test) {
            Diagnostic& d = at_.error(use.loc, "W182",
                                      "pass " + quote(at_.draft.decl.name) + " has the depth attachment " +
                                          quote(at_.declared.resource_name(use.resource)) +
                                          ", but neither tests nor writes it");
            add_help(d, "set the depth state, for example \"state\": { \"depth\": \"greater_write\" }");
            return;
        }
        if (!s.depth_write && !writes_stencil) {
            use.access = Access::depth_read;
            return;
        }
        use.access = Access::depth_write;
        port.rank = WriteRank::resumes;
        if (desc().partial || port.pinned()) port.rank = WriteRank::in_place;
        if (desc().clear_ports.contains(use.port) && !is_later_rect()) port.rank = WriteRank::fresh;
    }

    bool check_direction(const UseDecl& use, const ShaderBinding& binding) {
        const auto what = [&] {
            return "port " + quote(use.port) + " of pass " + quote(at_.draft.decl.name);
        };
        if (use.is_output && !binding.writes) {
            Diagnostic& d = error(
                use, "W112", what() + " is an output, but shader " + quote(desc().shader) + " only reads it");
            add_help(d, is_storage(binding.kind)
                            ? "remove `readonly` in the shader, or move the port to \"in\""
                            : "declare a storage image or buffer in the shader, or move the port to \"in\"");
            return false;
        }
        if (!use.is_output && binding.writes) {
            Diagnostic& d = error(
                use, "W112", what() + " is an input, but shader " + quote(desc().shader) + " may write it");
            add_help(d, "add `readonly` in the shader, or move the port to \"out\"");
            return false;
        }
        const bool buffer = at_.declared.shapes.resources[use.resource].kind == ResourceKind::buffer;
        if (buffer != is_buffer(binding.kind)) {
            Diagnostic& d =
                error(use, "W173",
                      what() + " is " + (buffer ? "a buffer" : "an image") + ", but shader " +
                          quote(desc().shader) + " declares " + (buffer ? "an image" : "a buffer"));
            add_help(d, "bind " + std::string(buffer ? "an image" : "a buffer") +
                            " to the port, or change the declaration in the shader");
            return false;
        }
        return true;
    }

    Access access_of(const UseDecl& use, PortDraft& port, const ShaderBinding& binding) const {
        if (binding.kind == BindingKind::sampled_image) return Access::sampled_read;
        if (binding.kind == BindingKind::uniform_buffer) return Access::uniform_read;
        if (!use.is_output) return Access::storage_read;
        const bool in_place = port.reads_own_port || desc().partial || port.pinned();
        port.rank = in_place ? WriteRank::in_place : binding.reads ? WriteRank::resumes : WriteRank::fresh;
        return Access::storage_write;
    }

    Diagnostic& error(const UseDecl& use, const char* code, std::string message) {
        return at_.error(use.loc, code, std::move(message));
    }

    std::vector<std::string> list_bindings(bool outputs) const {
        std::vector<std::string> names;
        if (outputs && at_.draft.decl.kind != PassKind::compute) {
            for (const StageVariable& output : at_.draft.shader->fragment_outputs)
                names.push_back(output.name);
        }
        for (const ShaderBinding& binding : at_.draft.shader->bindings) {
            if (is_port(binding)) names.push_back(binding.name);
        }
        std::ranges::sort(names);
        return names;
    }

    void report_no_binding(const UseDecl& use, const PortDraft& port) {
        const std::vector<std::string> names = list_bindings(use.is_output);
        Diagnostic& d = at_.error(port.desc->loc.line != 0 ? port.desc->loc : use.loc, "W170",
                                  "shader " + quote(desc().shader) + " has no binding " + quote(use.port) +
                                      " for the port of this name in pass " + quote(at_.draft.decl.name));
        add_help(d, did_you_mean_text(use.port, names));
        add_help(d, names.empty() ? "the shader uses no bindings"
                                  : "the bindings of the shader are " + quote_all(names));
        if (!use.is_output)
            add_help(d,
                     "the compiler removes an image or a buffer that the shader declares but does not use");
    }

    bool has_optional_switch(const std::string& binding) const {
        return std::ranges::any_of(at_.draft.shader->spec_constants, [&](const SpecConstant& c) {
            return c.type == ScalarType::boolean && c.name == "HAS_" + binding;
        });
    }

    // Returns true if the description of the pass has a port of this name. Does not search the bound ports: a
    // port with an error is not bound, and a second error "the port is missing" would be wrong.
    bool names_port(const std::string& name) const {
        const auto named = [&](const PortDesc& p) { return p.port == name; };
        return std::ranges::any_of(desc().in, named) || std::ranges::any_of(desc().out, named);
    }

    void report_bindings_without_port() {
        for (const ShaderBinding& binding : at_.draft.shader->bindings) {
            if (!is_port(binding) || names_port(binding.name) || has_optional_switch(binding.name)) continue;
            report_no_port(binding.name, "binds", binding.writes ? "out" : "in");
        }
        if (at_.draft.decl.kind == PassKind::compute) return;
        for (const StageVariable& output : at_.draft.shader->fragment_outputs) {
            if (!names_port(output.name)) report_no_port(output.name, "writes", "out");
        }
    }

    // Returns true if the pass probably misspells the port `name`: the pass has a port with a similar name,
    // and the shader has no binding of that similar name. An error about that port was already reported.
    bool is_misspelt(const std::string& name) const {
        std::vector<std::string> unmatched;
        const std::vector<std::string> known = list_bindings(true);
        for (const auto* ports : {&desc().in, &desc().out})
            for (const PortDesc& port : *ports)
                if (std::ranges::find(known, port.port) == known.end()) unmatched.push_back(port.port);
        return !did_you_mean(name, unmatched).empty();
    }

    void report_no_port(const std::string& name, const std::string& verb, const std::string& direction) {
        if (is_misspelt(name)) return;
        const SourceLoc loc = desc().shader_loc.line != 0 ? desc().shader_loc : desc().loc;
        Diagnostic& d =
            at_.error(loc, "W171",
                      "shader " + quote(desc().shader) + " " + verb + " " + quote(name) + ", but pass " +
                          quote(at_.draft.decl.name) + " has no port of this name");
        add_help(d, add_port_text(direction, name));
    }

    PassBinding& at_;
};

}  // namespace

void bind_shader_ports(PassBinding& pass) {
    ShaderBinder(pass).run();
}

}  // namespace weft
