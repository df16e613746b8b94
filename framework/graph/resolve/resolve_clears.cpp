// Clear values against the formats of what they clear: a value that the format can't hold would be cut off
// without a word, or is undefined behaviour.
#include <algorithm>
#include <cmath>
#include <limits>

#include "graph/diagnostics/whole_number.h"
#include "graph/resolve/resolve_context.h"

namespace weft {
namespace {

struct ValueRange {
    double least = 0;
    double most = 0;
    bool whole = false;
};

// Bits of one channel of a format without depth.
uint32_t channel_bits(const FormatInfo& format) {
    return format.components == 0 ? 0 : 8u * format.bytes_per_texel / format.components;
}

ValueRange float_range(const FormatInfo& format) {
    constexpr double kMostHalf = 65504;
    const std::string_view name = format.name;
    if (name == "b10g11r11f") return {0, 64512};
    if (name == "rgb9e5") return {0, 65408};
    if (name.find("snorm") != std::string_view::npos) return {-1, 1};
    if (!name.ends_with("f")) return {0, 1};  // unorm and sRGB
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
    explicit ClearCheck(ResolveState& state) : state_(state) {}

    void run() {
        for (ResourceId id = 0; id < state_.resources.size(); ++id) {
            const ResourceDesc* desc = state_.resources[id].desc;
            if (!desc || state_.graph.resources[id].age > 0) continue;
            if (desc->clear) check(*desc->clear, id);
            if (desc->first_frame) check(*desc->first_frame, id);
        }
        for (PassId pass = 0; pass < state_.passes.size(); ++pass) {
            const IndexScope scope(state_, pass);
            check_pass(state_.graph.passes[pass], *state_.passes[pass].desc);
        }
    }

 private:
    void check_pass(const PassDecl& pass, const PassDesc& desc) {
        for (const UseDecl& use : pass.uses) {
            if (!writes(use.access)) continue;
            const auto own = desc.clear_ports.find(use.port);
            if (own != desc.clear_ports.end()) {
                check(own->second, use.resource);
            } else if (desc.clear && is_cleared_by_pass(pass, use)) {
                check(*desc.clear, use.resource);
            }
        }
    }

    // The pass's own value is a colour: depth attachments take the resource's.
    bool is_cleared_by_pass(const PassDecl& pass, const UseDecl& use) const {
        if (pass.kind == PassKind::clear) return true;
        return use.access == Access::color_write || use.access == Access::color_read_write;
    }

    void check(const ColorDesc& color, ResourceId id) {
        const ResourceDecl& resource = state_.graph.resources[id];
        if (state_.resources[id].suspect_shape) return;
        if (resource.kind == ResourceKind::buffer)
            return check_channel(color.channels[0], {INT32_MIN, UINT32_MAX, true},
                                 "the words of buffer " + quoted(resource.name));
        const FormatInfo& format = format_info(resource.format);
        const std::string who = quoted(resource.name) + ", whose format is " + quoted(format.name) + ",";
        // One number stands for all channels: of depth and stencil it is the depth.
        const bool one = same_place(color.channels[0].loc, color.channels[1].loc);
        if (format.depth) check_channel(color.channels[0], {0, 1}, who);
        if (format.stencil && (!format.depth || !one)) check_channel(color.channels[1], {0, 255, true}, who);
        if (format.depth || format.stencil) return;
        const uint32_t channels = one ? 1 : std::min<uint32_t>(format.components, 4);
        for (uint32_t i = 0; i < channels; ++i)
            check_channel(color.channels[i], range_of_format(format), who);
    }

    void check_channel(const Expr& channel, const ValueRange& range, const std::string& who) {
        const std::optional<ExprValue> value = state_.evaluate_here(channel);
        if (!value || value->is_size) return;  // reported where it is read
        const double x = value->x;
        const bool inside = x >= range.least && x <= range.most && (!range.whole || x == std::floor(x));
        // Colours are kept in single precision; its next number above all bits means all bits.
        const bool exact = !range.whole || static_cast<double>(saturated_float(x)) == x || x == UINT32_MAX;
        if (inside && exact) return;
        Diagnostic fault = state_.input.graph.sources.error(channel.loc, "W109",
                                                            who + " can't be cleared to " + number_text(x));
        add_help(fault, inside ? "whole numbers are exact up to 16777216"
                               : (range.whole ? "it holds whole numbers of " : "it holds values of ") +
                                     number_text(range.least) + " to " + number_text(range.most));
        if (!state_.is_known(fault)) state_.add_error(std::move(fault));
    }

    ResolveState& state_;
};

}  // namespace

void check_clear_values(ResolveState& state) {
    ClearCheck(state).run();
}

}  // namespace weft
