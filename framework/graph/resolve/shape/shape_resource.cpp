#include "graph/resolve/shape/shape_resource.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "graph/diagnostics/quantity_text.h"
#include "graph/diagnostics/whole_number.h"
#include "graph/parse/grammar_tables.h"
#include "graph/parse/module_scope.h"
#include "graph/resolve/evaluator.h"
#include "graph/resolve/fault_text.h"
#include "graph/resolve/shape/shape_export.h"

namespace weft {
namespace {

constexpr uint32_t kCubeFaces = 6;

// Rounds down to a whole number, but returns at least 1, so that repeated halving of a size ends at 1. Clamps
// values that are far above the limits of any device. A clamped value still exceeds these limits, so the
// check of the limits reports it.
uint32_t at_least_one(double value) {
    constexpr double kMost = 1u << 30;
    return saturated<uint32_t>(std::clamp(std::floor(value), 1.0, kMost));
}

// `render_name` is the name of the size "render" for the resource; see render_size_name().
ExprValue default_size(const Values& values, const std::string& render_name) {
    const auto render = values.by_name.find(render_name);
    return render != values.by_name.end() ? render->second : values.by_name.at("output");
}

bool default_size_is_faulty(const Values& values, const std::string& render_name) {
    return values.faulty.contains(render_name);
}

struct Element {
    std::string_view name;
    uint32_t bytes;
};
constexpr std::array kElements{Element{"u32", 4},   Element{"i32", 4},    Element{"f32", 4},
                               Element{"vec2", 8},  Element{"uvec2", 8},  Element{"ivec2", 8},
                               Element{"vec4", 16}, Element{"uvec4", 16}, Element{"ivec4", 16},
                               Element{"mat4", 64}};

class ResourceShaper {
 public:
    ResourceShaper(const ResolveInput& input, const Values& values, ResourceId id, Shapes& shapes,
                   Reporter& reporter)
        : input_(input),
          values_(values),
          shapes_(shapes),
          decl_(shapes.resources[id]),
          is_suspect_(shapes.suspects.shapes[id]),
          desc_(*shapes.origins[id].desc),
          evaluator_(values, shapes, shapes.suspects, reporter),
          reporter_(reporter) {}

    void run() {
        decl_.pre_exposed = desc_.pre_exposed;
        const auto use = input_.request.exports.find(desc_.name);
        if (use != input_.request.exports.end() && !shape_export(desc_, use->second, decl_, reporter_))
            is_suspect_ = 1;
        if (has_textures()) return shape_table();
        if (desc_.clear) decl_.clear = evaluator_.color(*desc_.clear);
        if (has_file() && !import_file()) return;
        if (desc_.is_buffer) {
            shape_buffer();
        } else {
            shape_image();
        }
    }

 private:
    // Returns the value of an expression, or `fallback` if the expression is absent. Returns nullopt after
    // reporting an error.
    std::optional<ExprValue> value(const Expr& expression, ExprValue fallback) {
        if (expression.empty()) return fallback;
        const std::optional<ExprValue> found = evaluator_.value(expression);
        if (!found) is_suspect_ = 1;
        return found;
    }

    std::optional<double> number(const Expr& expression, double fallback, const char* what) {
        const std::optional<ExprValue> found = value(expression, number_value(fallback));
        if (!found) return std::nullopt;
        if (!found->is_size && found->x > 0) return found->x;
        if (!found->is_size) {
            report_nothing(expression,
                           std::string(what) + " of " + quote(desc_.name) + " is " + number_text(found->x));
            return std::nullopt;
        }
        is_suspect_ = 1;
        Diagnostic& d = reporter_.error(expression.loc, "W106",
                                        std::string(what) + " of " + quote(desc_.name) +
                                            " is a size (width and height), but must be a number");
        add_help(d, "use .x or .y of the size, or their product");
        return std::nullopt;
    }

    // Reports a size or count of zero or less. Such a value is a mistake of the author: halving a positive
    // size repeatedly never gives zero or less.
    void report_nothing(const Expr& expression, const std::string& message) {
        is_suspect_ = 1;
        add_help(reporter_.error(expression.empty() ? desc_.loc : expression.loc, "W109", message),
                 "make the value greater than zero, for example with max(…, 1)");
    }

    std::string render_name() const { return render_size_name(input_.graph, desc_.name); }

    bool has_file() const { return !desc_.file.name.empty(); }
    bool has_textures() const { return !desc_.textures.empty(); }
    bool has_picture() const { return desc_.file.width_px > 0; }

    void report_misfit(const SourceLoc& loc, const std::string& message, const std::string& help) {
        is_suspect_ = 1;
        add_help(reporter_.error(loc, "W146", message), help);
    }

    // Makes the resource an import that is never written: the program uploads the content of the file before
    // the first frame. Returns false if the file was not found; the error was reported.
    bool import_file() {
        decl_.file = desc_.file.name;
        decl_.file_path = desc_.file.path;
        decl_.lifetime = ResourceLifetime::imported;
        const StageMask shaders = stage::kVertexShader | stage::kFragmentShader | stage::kComputeShader;
        const AccessState read = desc_.is_buffer
                                     ? AccessState{shaders, access::kStorageRead, Layout::undefined}
                                     : AccessState{shaders, access::kSampledRead, Layout::shader_read_only};
        decl_.import = ImportState{read, read, 0, true};
        // The layout shader_read_only between frames is only allowed for images that may be sampled.
        decl_.usage = usage::kTransferDst | (desc_.is_buffer ? 0 : usage::kSampled);
        if (!desc_.file.path.empty()) return true;
        report_missing(desc_.file);
        return false;
    }

    void report_missing(const FileDesc& file) {
        is_suspect_ = 1;
        add_help(
            reporter_.error(file.loc, "W145",
                            "the file " + quote(file.name) + " of " + quote(desc_.name) + " was not read"),
            "load the graph with load_graph(), which reads the files of resources");
    }

    // Makes the resource a table of the pictures in the files. Like an image with a file, it is an import
    // that is never written.
    void shape_table() {
        decl_.kind = ResourceKind::image;
        decl_.lifetime = ResourceLifetime::imported;
        decl_.import = ImportState{texture_table_state(), texture_table_state(), 0, true};
        decl_.usage = usage::kTransferDst | usage::kSampled;
        decl_.textures = static_cast<uint32_t>(desc_.textures.size());
        const std::optional<double> mips = number(desc_.mips, 1, "the mip count");
        if (!mips) return;
        for (const FileDesc& file : desc_.textures) {
            const auto full = static_cast<uint32_t>(std::bit_width(std::max(file.width_px, file.height_px)));
            decl_.texture_files.push_back({file.name, file.path, file.width_px, file.height_px,
                                           desc_.full_mips ? full : std::min(full, at_least_one(*mips))});
            check_texture(file);
        }
    }

    void check_texture(const FileDesc& file) {
        if (file.path.empty()) return report_missing(file);
        if (file.width_px == 0)
            return report_misfit(file.loc,
                                 "the file " + quote(file.name) + " of the table " + quote(desc_.name) +
                                     " is no picture that Weft can read",
                                 "save the picture as PNG, JPEG, Radiance HDR, EXR or PFM");
        check_limit("texture " + quote(file.name) + " of " + quote(desc_.name) + " is " +
                        std::to_string(file.width_px) + " x " + std::to_string(file.height_px) + " px",
                    std::max(file.width_px, file.height_px), input_.profile.max_image_2d_px,
                    input_.limits.image_side_px, "graph.imageSidePx", " px for each side");
    }

    // Returns the size of an image: the size of the picture in its file, or otherwise the value of the key
    // "size".
    std::optional<ExprValue> image_size() {
        if (!has_file()) return value(desc_.size, default_size(values_, render_name()));
        if (!has_picture() && desc_.size.empty()) {
            report_misfit(desc_.file.loc,
                          "the file " + quote(desc_.file.name) +
                              " is no picture that Weft can read, so its bytes are texels of unknown size",
                          "add \"size\": [width, height] for a file of raw texels, or save the picture as "
                          "PNG, JPEG, Radiance HDR, EXR or PFM");
            return std::nullopt;
        }
        if (!has_picture()) return value(desc_.size, number_value(1));
        const ExprValue found{static_cast<double>(desc_.file.width_px),
                              static_cast<double>(desc_.file.height_px), true};
        if (desc_.size.empty()) return found;
        const std::optional<ExprValue> stated = value(desc_.size, found);
        if (!stated || (std::floor(stated->x) == found.x && std::floor(stated->y) == found.y)) return stated;
        report_misfit(desc_.size.loc,
                      "the size of " + quote(desc_.name) + " is " + number_text(stated->x) + " x " +
                          number_text(stated->y) + ", but its picture has " + number_text(found.x) + " x " +
                          number_text(found.y) + " pixels",
                      "remove \"size\": the size comes from the file");
        return std::nullopt;
    }

    // A picture has one layer.
    bool fits_picture() {
        if (!has_picture() || (decl_.layers == 1 && desc_.image_kind == ImageKind::d2)) return true;
        report_misfit(desc_.loc,
                      quote(desc_.name) + " is no plain 2D image, so the picture " + quote(desc_.file.name) +
                          " cannot fill it",
                      "remove \"kind\", \"cube\" and \"layers\", or use a file of raw texels");
        return false;
    }

    // Returns the number of elements of a buffer with a file.
    std::optional<double> count_in_file(uint32_t stride) {
        const double whole = std::floor(static_cast<double>(desc_.file.size_bytes) / stride);
        if (whole < 1 || desc_.file.size_bytes % stride != 0) {
            report_misfit(desc_.file.loc,
                          "the file " + quote(desc_.file.name) + " has " +
                              std::to_string(desc_.file.size_bytes) + " bytes, which is no multiple of " +
                              std::to_string(stride) + ", the size of " + quote(desc_.element),
                          "choose another type, or correct the file");
            return std::nullopt;
        }
        const std::optional<double> count = number(desc_.count, whole, "the element count");
        if (!count || std::floor(*count) <= whole) return count;
        report_misfit(desc_.count.loc,
                      quote(desc_.name) + " has " + number_text(*count) + " elements, but the file " +
                          quote(desc_.file.name) + " has only " + number_text(whole),
                      "remove \"count\": the number comes from the file");
        return std::nullopt;
    }

    bool check_size(const ExprValue& size) {
        if (size.x > 0 && size.y > 0) return true;
        report_nothing(desc_.size, "the size of " + quote(desc_.name) + " is " + number_text(size.x) + " x " +
                                       number_text(size.y));
        return false;
    }

    void shape_image() {
        decl_.kind = ResourceKind::image;
        decl_.image_kind = desc_.image_kind;
        if (!count_samples()) return;
        if (desc_.size.empty() && !has_file() && default_size_is_faulty(values_, render_name())) {
            is_suspect_ = 1;
            return;
        }
        const std::optional<ExprValue> size = image_size();
        const std::optional<double> layers = number(desc_.layers, 1, "the layer count");
        if (!size || !layers || !check_size(*size)) return;
        decl_.extent = {at_least_one(size->x), at_least_one(size->y), 1};
        set_layers(at_least_one(*layers));
        if (!fits_picture()) return;
        check_cube();
        const uint32_t largest = std::max({decl_.extent.width, decl_.extent.height, decl_.extent.depth});
        const uint32_t full = static_cast<uint32_t>(std::bit_width(largest));
        const std::optional<double> mips = number(desc_.mips, 1, "the mip count");
        if (!mips) return;
        decl_.mips = desc_.full_mips ? full : std::min(full, at_least_one(*mips));
        check_image_limits();
        shapes_.mip_counts[desc_.name] = decl_.mips;
    }

    bool count_samples() {
        if (desc_.samples.empty()) return true;
        const std::optional<double> samples =
            evaluator_.number(desc_.samples, "the number of samples of " + quote(desc_.name), 1, 8);
        if (samples) decl_.samples = static_cast<uint32_t>(*samples);
        if (!samples) is_suspect_ = 1;
        return samples.has_value();
    }

    bool is_cube() const {
        return desc_.image_kind == ImageKind::cube || desc_.image_kind == ImageKind::cube_array;
    }

    void check_cube() {
        if (!is_cube() || decl_.extent.width == decl_.extent.height) return;
        is_suspect_ = 1;
        Diagnostic& d = reporter_.error(desc_.size.empty() ? desc_.loc : desc_.size.loc, "W109",
                                        "the faces of cube " + quote(desc_.name) + " are " +
                                            extent_text(decl_.extent) + ", which is not square");
        add_help(d, "write one number for the side, for example \"size\": 128");
    }

    void set_layers(uint32_t layers) {
        const bool cube = is_cube();
        if (desc_.image_kind == ImageKind::d3) {
            decl_.extent.depth = layers;
        } else {
            decl_.layers = cube ? kCubeFaces * layers : layers;
            if (layers > 1 && desc_.image_kind == ImageKind::d2) decl_.image_kind = ImageKind::d2_array;
        }
    }

    void check_image_limits() {
        const GraphLimits& limits = input_.limits;
        const DeviceProfile& device = input_.profile;
        const Extent3D& e = decl_.extent;
        check_limit("image " + quote(desc_.name) + " is " + extent_text(e) + " px",
                    std::max({e.width, e.height, e.depth}), device.max_image_2d_px, limits.image_side_px,
                    "graph.imageSidePx", " px for each side");
        check_limit("image " + quote(desc_.name) + " has " + std::to_string(decl_.layers) + " layers",
                    decl_.layers, device.max_image_layers, limits.layers, "graph.layers", " layers");
        check_limit("image " + quote(desc_.name) + " has " + std::to_string(decl_.mips) + " mips", decl_.mips,
                    UINT32_MAX, limits.mips, "graph.mips", " mips");
        if (decl_.samples != 1 && (decl_.mips != 1 || !std::has_single_bit(decl_.samples))) {
            Diagnostic& d = reporter_.error(
                desc_.loc, "W119",
                "image " + quote(desc_.name) + " cannot have this combination of samples and mips");
            add_help(d, "use one mip with 2, 4 or 8 samples, or one sample with any number of mips");
        }
    }

    // Checks a value against two limits. The limit of the device comes first, because the user can raise the
    // graph's limit but not that of the device.
    void check_limit(const std::string& what, uint32_t value, uint32_t device, uint64_t limit,
                     const std::string& name, const std::string& unit) {
        if (value > device) return over_limit(what, std::to_string(device) + unit);
        if (value <= limit) return;
        is_suspect_ = 1;
        Diagnostic& d =
            reporter_.error(desc_.loc, "W125", what + "; the limit is " + std::to_string(limit) + unit);
        add_help(d, "reduce this value, " + raise_limit_text(name));
    }

    void over_limit(const std::string& what, const std::string& limit) {
        is_suspect_ = 1;
        Diagnostic& d = reporter_.error(desc_.loc, "W119", what + "; the device allows at most " + limit);
        add_help(d,
                 "reduce this value; the limit comes from the device profile " + quote(input_.profile.name));
    }

    std::optional<uint32_t> element_bytes() {
        const auto plain = std::ranges::find(kElements, desc_.element, &Element::name);
        if (plain != kElements.end()) return plain->bytes;
        const auto& strides = input_.imports.strides;
        const auto known = strides.find(desc_.element);
        if (known != strides.end()) return known->second;
        is_suspect_ = 1;
        std::vector<std::string> names = plain_elements();
        for (const auto& [name, unused] : strides) names.push_back(name);
        Diagnostic& d = reporter_.error(
            desc_.loc, "W116",
            "buffer " + quote(desc_.name) + " has elements of unknown type " + quote(desc_.element));
        const std::string near = did_you_mean_text(desc_.element, names);
        add_help(d, near.empty() ? "the known types are " + quote_all(names) : near);
        return std::nullopt;
    }

    void shape_buffer() {
        decl_.kind = ResourceKind::buffer;
        decl_.aspects = aspect::kColor;
        const std::optional<uint32_t> stride = element_bytes();
        if (!stride) return;
        const std::optional<double> count =
            has_file() ? count_in_file(*stride) : number(desc_.count, 1, "the element count");
        if (!count) return;
        const uint64_t limit = input_.profile.max_storage_buffer_bytes;
        const double elements = std::max(1.0, std::floor(*count));
        decl_.stride_bytes = *stride;
        // Compares as floating point, because the integer product could exceed 2^64.
        if (elements * *stride > static_cast<double>(limit)) {
            over_limit("buffer " + quote(desc_.name) + " is larger than " + std::to_string(limit) + " bytes",
                       std::to_string(limit) + " bytes for each buffer");
            return;
        }
        decl_.size_bytes = saturated<uint64_t>(elements) * *stride;
    }

    const ResolveInput& input_;
    const Values& values_;
    Shapes& shapes_;
    ResourceDecl& decl_;
    uint8_t& is_suspect_;
    const ResourceDesc& desc_;
    Evaluator evaluator_;
    Reporter& reporter_;
};

}  // namespace

std::vector<std::string> plain_elements() {
    std::vector<std::string> names;
    for (const Element& element : kElements) names.emplace_back(element.name);
    return names;
}

void shape_resource(const ResolveInput& input, const Values& values, ResourceId id, Shapes& shapes,
                    Reporter& reporter) {
    ResourceShaper(input, values, id, shapes, reporter).run();
}

}  // namespace weft
