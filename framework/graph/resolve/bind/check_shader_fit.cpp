#include <algorithm>

#include "graph/resolve/bind/bind_pass.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

constexpr uint32_t kFrameSet = 0;

class ShaderFit {
 public:
    explicit ShaderFit(PassBinding& pass) : at_(pass) {}

    void run() {
        for (const ShaderBinding& binding : at_.draft.shader->bindings)
            if (binding.set != kPortSet) check_binding(binding);
        check_points();
        check_local_size();
    }

 private:
    SourceLoc loc() const {
        return at_.draft.desc->shader_loc.line != 0 ? at_.draft.desc->shader_loc : at_.draft.decl.loc;
    }
    std::string shader() const { return "shader " + quote(at_.draft.desc->shader); }

    Diagnostic& error(const char* code, const std::string& message, const std::string& help) {
        Diagnostic& fault = at_.error(loc(), code, message);
        add_help(fault, help);
        return fault;
    }

    bool draws_lists() const {
        return at_.draft.decl.kind == PassKind::raster && !at_.draft.desc->draws_without_list();
    }

    void check_binding(const ShaderBinding& binding) {
        const std::string what = shader() + " reads " + quote(binding.name) + " at set " +
                                 std::to_string(binding.set) + ", binding " + std::to_string(binding.binding);
        if (binding.set != kFrameSet && !draws_lists()) {
            // Descriptor sets 2 and 3 exist only in passes with draw lists. For a raster pass without draw
            // lists, the error W167 was already reported.
            if (at_.draft.decl.kind != PassKind::raster)
                error("W185", what + ", which exists only in raster passes that draw a draw list",
                      "remove set and binding from the layout: then the variable is a port of the pass");
            return;
        }
        if (binding.set != kFrameSet && report_missing_set(what, binding.set)) return;
        const std::vector<OfferedBinding>& offered = at_.declared.input.imports.bindings;
        if (offered.empty()) return;
        const auto found = std::ranges::find_if(offered, [&](const OfferedBinding& o) {
            return o.set == binding.set && o.binding == binding.binding;
        });
        if (found == offered.end())
            return add_offers(error("W185", what + ", but the program binds nothing there",
                                    "remove set and binding from the layout: then the variable is a port of "
                                    "the pass"),
                              binding.set);
        const std::string fault = mismatch(binding, *found);
        if (!fault.empty())
            add_offers(
                error("W185", what + ", " + fault,
                      "include frame_set.glsl, material_set.glsl or surface_vertex.glsl, which declare "
                      "the bindings of Weft correctly"),
                binding.set);
    }

    // Reports the first draw list of the pass for which the program does not bind descriptor set `set`.
    // Returns false if there is no such draw list.
    bool report_missing_set(const std::string& what, uint32_t set) {
        const auto& catalog = at_.declared.input.imports.imports;
        for (const std::string& list : at_.draft.desc->draws) {
            const auto found = catalog.find(list);
            if (found == catalog.end() || (found->second.draw_sets >> set & 1) != 0) continue;
            error("W256",
                  what + ", but the program binds no set " + std::to_string(set) + " for its draw list " +
                      quote(list),
                  "give the layout and the bindings of this set in SessionInput::draw_sets, and bind the set "
                  "in "
                  "DrawList::record()");
            return true;
        }
        return false;
    }

    // Adds a help text that lists the descriptors that the program binds in descriptor set 2 or 3.
    void add_offers(Diagnostic& fault, uint32_t set) {
        if (set == kFrameSet) return;
        std::string offers;
        for (const OfferedBinding& o : at_.declared.input.imports.bindings) {
            if (o.set != set) continue;
            offers += (offers.empty() ? "" : ", ") + std::to_string(o.binding) + ": " + kind_text(o) +
                      " in " + stages_text(o.stages);
        }
        add_help(fault, "the program binds in set " + std::to_string(set) + ": " +
                            (offers.empty() ? "nothing" : offers));
    }

    static std::string kind_text(const OfferedBinding& offered) {
        switch (offered.kind) {
            case BindingKind::sampled_image:
                return offered.arrayed ? "sampler2DArray" : "sampler2D";
            case BindingKind::storage_image:
                return "storage image";
            case BindingKind::uniform_buffer:
                return "uniform block of " + std::to_string(offered.bytes) + " bytes";
            case BindingKind::storage_buffer:
                return "storage buffer";
        }
        return "";
    }

    static std::string stages_text(ShaderStageMask stages) {
        std::string text;
        for (const auto& [stage, name] :
             {std::pair{ShaderStage::vertex, "vertex"}, std::pair{ShaderStage::fragment, "fragment"},
              std::pair{ShaderStage::compute, "compute"}})
            if ((stages & stage_bit(stage)) != 0) text += (text.empty() ? "" : " and ") + std::string(name);
        return text.empty() ? "no stage" : text + " shaders";
    }

    // Returns the first reason why a binding of the shader does not match the descriptor that the program
    // binds there, or an empty text if they match.
    static std::string mismatch(const ShaderBinding& binding, const OfferedBinding& offered) {
        if (binding.kind != offered.kind || binding.count != 1)
            return "but the program binds a descriptor of another type there";
        if ((binding.stages & ~offered.stages) != 0) return "which is not visible to this shader stage";
        const bool image = binding.kind == BindingKind::sampled_image;
        if (image && (binding.dim != ImageDim::d2 || binding.arrayed != offered.arrayed ||
                      binding.multisampled || binding.shadow || binding.numeric != NumericClass::float_like))
            return "but the program binds another kind of image there";
        if (binding.kind == BindingKind::uniform_buffer && binding.block_bytes > offered.bytes)
            return "whose block has " + std::to_string(offered.bytes) + " bytes, not " +
                   std::to_string(binding.block_bytes);
        if (binding.kind == BindingKind::storage_buffer && binding.writes)
            return "and may write the buffer: declare the buffer `readonly`";
        return "";
    }

    void check_points() {
        if (at_.draft.decl.kind == PassKind::compute || at_.draft.shader->writes_point_size) return;
        const RasterState& state = at_.draft.desc->state;
        const bool points = state.topology == Topology::points;
        if (!points && state.fill != FillMode::point) return;
        error("W186",
              "pass " + quote(at_.draft.decl.name) + " draws points, but the vertex stage of " + shader() +
                  " does not write gl_PointSize",
              at_.draft.decl.kind == PassKind::fullscreen
                  ? "remove \"topology\" and \"fill\": a fullscreen pass draws one triangle"
                  : "write gl_PointSize = 1.0; in the vertex stage");
    }

    void check_local_size() {
        if (at_.draft.decl.kind != PassKind::compute || at_.draft.shader->states_local_size ||
            at_.draft.instance > 0)
            return;
        at_.reporter.warn(loc(), "W137",
                          shader() + " has no local size, so each workgroup has only one invocation",
                          "declare the size: layout(local_size_x = 8, local_size_y = 8) in;");
    }

    PassBinding& at_;
};

}  // namespace

void check_shader_fit(PassBinding& pass) {
    ShaderFit(pass).run();
}

}  // namespace weft
