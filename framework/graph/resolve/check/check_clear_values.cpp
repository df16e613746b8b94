// Checks that clear values fit the formats of the images. In Vulkan, a value outside the range of a format is
// clamped silently or is undefined behaviour.
#include <algorithm>
#include <cmath>
#include <limits>

#include "graph/diagnostics/quantity_text.h"
#include "graph/diagnostics/whole_number.h"
#include "graph/resolve/checks.h"
#include "graph/resolve/evaluator.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

struct ValueRange {
    double least = 0;
    double most = 0;
    bool whole = false;
};

// Returns the bits of one channel of a colour format, on the assumption that all channels have the same size.
uint32_t channel_bits(const FormatInfo& format) {
    return format.components == 0 ? 0 : 8u * format.bytes_per_texel / format.components;
}

ValueRange float_range(const FormatInfo& format) {
    constexpr double kMostHalf = 65504;
    const std::string_view name = format.name;
    if (name == "b10g11r11f") return {0, 64512};  // The greatest 10-bit float, the type of channel b.
    if (name == "rgb9e5") return {0, 65408};      // Mantissa 511/512 times 2^16.
    if (name.find("snorm") != std::string_view::npos) return {-1, 1};
    // The names of float formats end with "f". All other formats at this point are unorm or sRGB.
    if (!name.ends_with("f")) return {0, 1};
    if (channel_bits(format) == 16) return {-kMostHalf, kMostHalf};
    return {-double{std::numeric_limits<float>::max()}, double{std::numeric_limits<float>::max()}};
}

ValueRange range_of_format(const FormatInfo& format) {
    const uint32_t bits = std::min(channel_bits(format), 32u);
    switch (format.numeric) {
        case NumericClass::uint:
            return {0, std::ldexp(1.0, static_cast<int>(bits)) - 1, true};
        case NumericClass::sint:
            return {-std::ldexp(1.0, static_cast<int>(bits) - 1),
                    std::ldexp(1.0, static_cast<int>(bits) - 1) - 1, true};
        case NumericClass::depth:
            return {0, 1};
        case NumericClass::float_like:
            break;
    }
    return float_range(format);
}

bool same_place(const SourceLoc& a, const SourceLoc& b) {
    return a.file == b.file && a.line == b.line && a.column == b.column;
}

class ClearCheck {
 public:
    ClearCheck(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
               Reporter& reporter)
        : declared_(declared), graph_(graph), suspects_(suspects), reporter_(reporter) {}

    void run() {
        const Evaluator evaluator = declared_.evaluator(suspects_, reporter_);
        for (ResourceId id(0); id < graph_.resources.size(); ++id) {
            const ResourceDesc* desc = declared_.shapes.origins[id].desc;
            if (!desc || graph_.resources[id].age > 0) continue;
            if (desc->clear) check(evaluator, *desc->clear, id);
            if (desc->first_frame) check(evaluator, *desc->first_frame, id);
        }
        for (PassId pass(0); pass < graph_.passes.size(); ++pass) check_pass(pass);
    }

 private:
    void check_pass(PassId id) {
        const Evaluator evaluator = declared_.evaluator(id, suspects_, reporter_);
        const PassDraft& draft = declared_.expansion.passes[id];
        const PassDesc& desc = *draft.desc;
        for (const UseDecl& use : graph_.passes[id].uses) {
            if (!writes(use.access)) continue;
            const auto own = desc.clear_ports.find(use.port);
            if (own != desc.clear_ports.end()) {
                check(evaluator, own->second, use.resource);
            } else if (desc.clear && is_cleared_by_pass(draft.decl.kind, use)) {
                check(evaluator, *desc.clear, use.resource);
            }
        }
    }

    // Returns true if the key "clear" of the pass applies to this use. In a pass that draws, "clear" is a
    // colour and applies only to colour attachments. Its depth attachment is cleared with the "clear" of the
    // resource instead.
    static bool is_cleared_by_pass(PassKind kind, const UseDecl& use) {
        if (kind == PassKind::clear) return true;
        return use.access == Access::color_write || use.access == Access::color_read_write;
    }

    void check(const Evaluator& evaluator, const ColorDesc& color, ResourceId id) {
        const ResourceDecl& resource = graph_.resources[id];
        if (suspects_.shapes[id]) return;
        if (resource.kind == ResourceKind::buffer)
            return check_channel(evaluator, color.channels[0], {INT32_MIN, UINT32_MAX, true},
                                 "the words of buffer " + quote(resource.name));
        const FormatInfo& format = format_info(resource.format);
        const std::string who = quote(resource.name) + ", whose format is " + quote(format.name) + ",";
        // A single number is stored in all four channels, so all channel expressions have the same location.
        // For formats with depth and stencil, a single number is only the depth.
        const bool one = same_place(color.channels[0].loc, color.channels[1].loc);
        if (format.depth) check_channel(evaluator, color.channels[0], {0, 1}, who);
        if (format.stencil && (!format.depth || !one))
            check_channel(evaluator, color.channels[1], {0, 255, true}, who);
        if (format.depth || format.stencil) return;
        const uint32_t channels = one ? 1 : std::min<uint32_t>(format.components, 4);
        for (uint32_t i = 0; i < channels; ++i)
            check_channel(evaluator, color.channels[i], range_of_format(format), who);
    }

    void check_channel(const Evaluator& evaluator, const Expr& channel, const ValueRange& range,
                       const std::string& who) {
        const std::optional<ExprValue> value = evaluator.value(channel);
        // A channel that cannot be evaluated, or is a size instead of a number, is reported elsewhere.
        if (!value || value->is_size) return;
        const double x = value->x;
        const bool inside = x >= range.least && x <= range.most && (!range.whole || x == std::floor(x));
        // Clear values are stored as floats. A float cannot represent UINT32_MAX exactly, but the next
        // greater float is used for "all bits set", so UINT32_MAX is allowed.
        const bool exact = !range.whole || static_cast<double>(saturated_float(x)) == x || x == UINT32_MAX;
        if (inside && exact) return;
        Diagnostic fault =
            reporter_.sources().error(channel.loc, "W109", who + " cannot be cleared to " + number_text(x));
        add_help(fault, inside ? "choose a number up to 16777216: greater whole numbers are not exact"
                               : (range.whole ? "choose a whole number from " : "choose a value from ") +
                                     number_text(range.least) + " to " + number_text(range.most));
        reporter_.add_once(std::move(fault));
    }

    const Declared& declared_;
    const VersionedGraph& graph_;
    const Suspects& suspects_;
    Reporter& reporter_;
};

}  // namespace

void check_clear_values(const Declared& declared, const VersionedGraph& graph, const Suspects& suspects,
                        Reporter& reporter) {
    ClearCheck(declared, graph, suspects, reporter).run();
}

}  // namespace weft
