#include <algorithm>
#include <array>

#include "graph/resolve/check/check_buffer_use.h"
#include "graph/resolve/check/check_sampler.h"
#include "graph/resolve/checks.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

// Index: NumericClass.
constexpr std::array kNumericNames{"float", "int", "uint", "depth"};
static_assert(kNumericNames.size() == static_cast<size_t>(NumericClass::depth) + 1);
// Index: ImageDim.
constexpr std::array kDimNames{"1D", "2D", "3D", "Cube"};
static_assert(kDimNames.size() == static_cast<size_t>(ImageDim::cube) + 1);

const char* numeric_name(NumericClass numeric) {
    return kNumericNames.at(static_cast<size_t>(numeric));
}

const char* dim_name(ImageDim dim) {
    return kDimNames.at(static_cast<size_t>(dim));
}

class InterfaceCheck {
 public:
    InterfaceCheck(const Declared& declared, const FormattedGraph& graph, PassId pass, Suspects& suspects,
                   PassReporter& report)
        : declared_(declared),
          graph_(graph),
          pass_(pass),
          desc_(*declared.expansion.passes[pass].desc),
          suspects_(suspects),
          report_(report) {}

    void run() {
        const BoundPass& pass = graph_.passes[pass_];
        for (size_t i = 0; i < pass.uses.size(); ++i) {
            const UseDecl& use = pass.uses[i];
            const ResourceDecl& resource = graph_.resources[use.resource];
            if (suspects_.shapes[use.resource]) continue;
            check_writable(use, resource);
            if (resource.kind == ResourceKind::image && !check_aspects(use, resource))
                suspects_.uses[pass_][i] = 1;
            else
                check_use(use, resource, pass.ports[i]);
        }
    }

 private:
    void check_use(const UseDecl& use, const ResourceDecl& resource, const PortDraft& port) {
        if (port.color_output) return check_color(use, resource, *port.color_output);
        if (port.is_depth_port) return check_depth(use, resource);
        if (use.access == Access::none) return;
        if (resource.kind == ResourceKind::buffer)
            return check_buffer_use(declared_, pass_, use, resource, port.binding, report_);
        if (!port.binding) return;
        if (!check_numbers(use, resource, *port.binding)) return;
        if (port.binding->kind == BindingKind::storage_image && resource.samples > 1) {
            error(use, "W173",
                  port_text(use) + " is a storage image, but " + quote(resource.name) + " is multisampled",
                  "resolve the image first, or declare a sampler2DMS in the shader");
            return;
        }
        if (port.binding->kind == BindingKind::storage_image) check_storage(use, resource, *port.binding);
        check_dimensions(use, resource, *port.binding);
        check_filter(use, resource);
        if (use.access == Access::sampled_read)
            check_sampler(declared_.input.profile, pass_, *port.desc, *port.binding, port_text(use), report_);
    }

    // For a read-only import, the access states before and after a frame contain only reads. So a write would
    // change the import for all later frames without synchronisation.
    void check_writable(const UseDecl& use, const ResourceDecl& resource) {
        if (!writes(use.access)) return;
        const auto import = declared_.input.imports.imports.find(resource.name);
        if (resource.lifetime != ResourceLifetime::imported ||
            import == declared_.input.imports.imports.end() || !import->second.read_only)
            return;
        error(use, "W147",
              "pass " + quote(declared_.pass_name(pass_)) + " writes " + quote(resource.name) +
                  ", which the program only lets passes read",
              "copy the import to a resource of the graph with a pass of type \"copy\", and write that "
              "resource");
    }

    void error(const UseDecl& use, const char* code, const std::string& message, const std::string& help) {
        add_help(report_.error(pass_, use.loc, code, message), help);
    }

    std::string port_text(const UseDecl& use) const {
        return "port " + quote(use.port) + " of pass " + quote(declared_.pass_name(pass_));
    }

    bool check_aspects(const UseDecl& use, const ResourceDecl& resource) {
        if ((use.range.aspects & ~resource.aspects) == 0) return true;
        Diagnostic& d =
            report_.error(pass_, use.loc, "W105",
                          quote(resource.name) + " has format " + quote(format_info(resource.format).name) +
                              ", which does not have this aspect");
        add_help(d, "remove .depth or .stencil, or change the format");
        return false;
    }

    void check_color(const UseDecl& use, const ResourceDecl& resource, const StageVariable& output) {
        const FormatInfo& format = format_info(resource.format);
        if (resource.kind == ResourceKind::buffer || format.numeric == NumericClass::depth) {
            error(use, "W173",
                  port_text(use) + " is a colour output, but " + quote(resource.name) + " is " +
                      (resource.kind == ResourceKind::buffer ? "a buffer" : "a depth image"),
                  "name a colour image here; name a depth image in \"depth\"");
            return;
        }
        const NumericClass wanted = output.scalar == ScalarType::i32   ? NumericClass::sint
                                    : output.scalar == ScalarType::u32 ? NumericClass::uint
                                                                       : NumericClass::float_like;
        if (wanted == format.numeric) return;
        error(use, "W172",
              port_text(use) + " writes " + numeric_name(wanted) + " values, but " + quote(resource.name) +
                  " has format " + quote(format.name),
              "change the type of the output in the shader, or change the format");
    }

    void check_depth(const UseDecl& use, const ResourceDecl& resource) {
        if (resource.kind == ResourceKind::buffer ||
            !(resource.aspects & (aspect::kDepth | aspect::kStencil))) {
            error(use, "W182",
                  "\"depth\" of pass " + quote(declared_.pass_name(pass_)) + " is " + quote(resource.name) +
                      ", which is not a depth image",
                  "give the image a depth format, for example \"d32f\"");
            return;
        }
        if (!desc_.state.stencil_test || (resource.aspects & aspect::kStencil)) return;
        error(use, "W182",
              "pass " + quote(declared_.pass_name(pass_)) + " tests stencil, but " + quote(resource.name) +
                  " has no stencil",
              "use a format with stencil: \"d32f_s8\", \"d24_s8\", or the list of alternatives "
              "\"d32f_s8|d24_s8\"");
    }

    bool check_numbers(const UseDecl& use, const ResourceDecl& resource, const ShaderBinding& binding) {
        const FormatInfo& format = format_info(resource.format);
        NumericClass found = format.numeric;
        if (found == NumericClass::depth) {
            found = use.range.aspects == aspect::kStencil ? NumericClass::uint : NumericClass::float_like;
        }
        const NumericClass wanted =
            binding.numeric == NumericClass::depth ? NumericClass::float_like : binding.numeric;
        if (found != wanted) {
            error(use, "W172",
                  port_text(use) + ": shader " + quote(desc_.shader) + " expects " + numeric_name(wanted) +
                      " values, but " + quote(resource.name) + " has format " + quote(format.name),
                  "change the declaration in the shader, or change the format");
            return false;
        }
        if (!binding.shadow || format.depth) return true;
        error(use, "W172",
              port_text(use) + " is a shadow sampler, which compares depths, but " + quote(resource.name) +
                  " has format " + quote(format.name),
              "declare a plain sampler, or bind a depth image");
        return false;
    }

    void check_storage(const UseDecl& use, const ResourceDecl& resource, const ShaderBinding& binding) {
        const std::string name(format_info(resource.format).name);
        if (binding.storage_format == Format::undefined) {
            if (!binding.reads || declared_.input.profile.storage_read_without_format) return;
            error(use, "W172",
                  port_text(use) + " is read without a format, which the device does not support",
                  "declare layout(" + name + ") in the shader, or declare it `writeonly`");
            return;
        }
        const ResourceDesc* desc = declared_.shapes.origins[use.resource].desc;
        if (binding.reads && desc && desc->formats.size() > 1) {
            error(use, "W172",
                  quote(resource.name) + " has a choice of formats, but " + port_text(use) +
                      " reads it as a storage image with the format that the shader declares",
                  "name only the format of the shader: " + quote(format_info(binding.storage_format).name));
            return;
        }
        if (binding.storage_format == resource.format) return;
        error(use, "W172",
              port_text(use) + ": the shader declares layout(" +
                  std::string(format_info(binding.storage_format).name) + "), but " + quote(resource.name) +
                  " has format " + quote(name),
              "use the same format in both");
    }

    void check_dimensions(const UseDecl& use, const ResourceDecl& resource, const ShaderBinding& binding) {
        // The elements of an array have the same shape, so it is enough to check the first one.
        const SubresourceRange part = element_range(use, 0);
        if (binding.kind == BindingKind::storage_image && part.mips != 1) {
            error(use, "W173",
                  port_text(use) + " is a storage image, which must be one mip, but " + quote(resource.name) +
                      " has " + std::to_string(part.mips),
                  use.each == EachPart::layer && element_count(use) == 1
                      ? "write \"each\": \"mip\": then each element of the array in the shader is one mip"
                      : "select one mip: " + quote(resource.name + ".mip(0)"));
            return;
        }
        const bool is_cube =
            resource.image_kind == ImageKind::cube || resource.image_kind == ImageKind::cube_array;
        const bool is_3d = resource.image_kind == ImageKind::d3;
        bool fits = false;
        switch (binding.dim) {
            case ImageDim::d2:
                fits = !is_3d && (binding.arrayed || part.layers == 1);
                break;
            case ImageDim::d3:
                fits = is_3d;
                break;
            case ImageDim::cube:
                fits = is_cube && (binding.arrayed ? part.layers % 6 == 0 : part.layers == 6);
                break;
            case ImageDim::d1:
                break;
        }
        if (fits && binding.multisampled == (resource.samples > 1)) return;
        const std::string declared = std::string(dim_name(binding.dim)) + (binding.multisampled ? "MS" : "") +
                                     (binding.arrayed ? "Array" : "");
        error(
            use, "W173",
            port_text(use) + " is declared as " + declared + " in shader " + quote(desc_.shader) + ", but " +
                quote(range_of(resource, part)) + " has " + std::to_string(part.layers) + " layers and " +
                std::to_string(resource.samples) + " samples" +
                (is_3d     ? " and is 3D"
                 : is_cube ? " and is a cube"
                           : ""),
            "change the declaration in the shader, or select a layer: " + quote(resource.name + ".layer(0)"));
    }

    void check_filter(const UseDecl& use, const ResourceDecl& resource) {
        if (use.access != Access::sampled_read) return;
        const NumericClass numeric = format_info(resource.format).numeric;
        const bool integers = numeric == NumericClass::uint || numeric == NumericClass::sint;
        const bool linear =
            use.sampler.filter == SamplerFilter::linear || use.sampler.mip_filter == SamplerFilter::linear;
        if (!integers || !linear) return;
        error(use, "W172",
              port_text(use) + " filters " + quote(resource.name) + " linearly, but its format has integers",
              "use \"sampler\": { \"filter\": \"nearest\", \"mipFilter\": \"nearest\" }");
    }

    const Declared& declared_;
    const FormattedGraph& graph_;
    PassId pass_;
    const PassDesc& desc_;
    Suspects& suspects_;
    PassReporter& report_;
};

bool both_writes_or_other_layout(const std::vector<ResourceDecl>& resources, const UseDecl& a,
                                 const UseDecl& b) {
    if (a.resource != b.resource || !overlaps(a.range, b.range)) return false;
    if (writes(a.access) && writes(b.access)) return true;
    const ResourceDecl& resource = resources[a.resource];
    if (resource.kind == ResourceKind::buffer) return false;
    return access_state(a.access, 0, resource.aspects).layout !=
           access_state(b.access, 0, resource.aspects).layout;
}

// Checks the ports of a pass against each other: during a pass, each subresource has one layout, and at most
// one port writes it.
void check_layouts(const Declared& declared, const FormattedGraph& graph, PassId pass, PassReporter& report) {
    const std::vector<UseDecl>& uses = graph.passes[pass].uses;
    for (size_t i = 0; i < uses.size(); ++i) {
        for (size_t j = i + 1; j < uses.size(); ++j) {
            if (uses[i].access == Access::none || uses[j].access == Access::none) continue;
            if (!both_writes_or_other_layout(graph.resources, uses[i], uses[j])) continue;
            const bool both_write = writes(uses[i].access) && writes(uses[j].access);
            Diagnostic& d =
                report.error(pass, uses[j].loc, both_write ? "W164" : "W163",
                             "ports " + quote(uses[i].port) + " and " + quote(uses[j].port) + " of pass " +
                                 quote(declared.pass_name(pass)) +
                                 (both_write ? " both write " : " need different layouts of ") +
                                 quote(range_of(graph.resources[uses[j].resource], uses[j].range)));
            if (both_write) {
                add_help(d, "give each port its own mips, layers, elements or resource");
            } else {
                add_help(d, "use storage images for both ports, read a copy, or use other mips and layers");
                if (declared.expansion.passes[pass].group != kNoId)
                    add_help(
                        d,
                        "or read the image in an earlier pass of the group, and keep what is needed in a "
                        "resource of the group");
            }
            return;
        }
    }
}

}  // namespace

Suspects check_interfaces(const Declared& declared, const FormattedGraph& graph, Reporter& reporter) {
    Suspects suspects = graph.suspects;
    for (const BoundPass& pass : graph.passes) suspects.uses.emplace_back(pass.uses.size());
    PassReporter report(declared.shapes, declared.expansion, suspects, reporter);
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        InterfaceCheck(declared, graph, pass, suspects, report).run();
        if (!suspects.passes[pass]) check_layouts(declared, graph, pass, report);
    }
    return suspects;
}

}  // namespace weft
