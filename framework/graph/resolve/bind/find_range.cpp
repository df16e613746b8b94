#include "graph/resolve/bind/find_range.h"

#include <algorithm>
#include <cmath>

#include "graph/diagnostics/quantity_text.h"
#include "graph/diagnostics/whole_number.h"
#include "graph/resolve/fault_text.h"

namespace weft {
namespace {

struct Span {
    uint32_t first = 0;
    uint32_t count = 1;
};

// One dimension of a resource, in which a reference can select a range.
struct Dimension {
    const char* what;  // "mip", "layer" or "element".
    const std::optional<Expr>& first;
    const std::optional<Expr>& last;
};

class RangeFinder {
 public:
    RangeFinder(PassId pass, const RefDesc& ref, const Evaluator& evaluator, Suspects& suspects,
                PassReporter& report)
        : pass_(pass), ref_(ref), evaluator_(evaluator), suspects_(suspects), report_(report) {}

    std::optional<FoundRange> find(const ResourceDecl& resource) const {
        if (resource.kind == ResourceKind::buffer) return find_elements(resource);
        if (ref_.element_first) {
            fail(quote(ref_.name) + " is an image, and only buffers have elements",
                 "select mips or layers: " + quote(ref_.name + ".mip(0)"));
            return std::nullopt;
        }
        const std::optional<Span> mips = span({"mip", ref_.mip_first, ref_.mip_last}, resource.mips);
        const std::optional<Span> layers =
            span({"layer", ref_.layer_first, ref_.layer_last}, resource.layers);
        if (!mips || !layers) return std::nullopt;
        return FoundRange{{mips->first, mips->count, layers->first, layers->count, ref_.aspects}, {}};
    }

 private:
    void fail(const std::string& message, const std::string& help) const {
        add_help(report_.error(pass_, ref_.loc, "W105", message), help);
    }

    std::optional<FoundRange> find_elements(const ResourceDecl& buffer) const {
        if (ref_.mip_first || ref_.layer_first || ref_.aspects != 0) {
            fail(quote(ref_.name) + " is a buffer, and buffers have no mips, layers or aspects",
                 "write " + quote(ref_.name) + ", or select elements: " + quote(ref_.name + ".range(0..3)"));
            return std::nullopt;
        }
        if (!ref_.element_first) return FoundRange{};
        const uint64_t stride = buffer.stride_bytes;
        if (stride == 0) {
            fail("the size of the elements of " + quote(ref_.name) + " is unknown",
                 "name the whole buffer: " + quote(ref_.name) +
                     "; or let the program set the stride of its buffer");
            return std::nullopt;
        }
        const auto count = static_cast<uint32_t>(std::min<uint64_t>(buffer.size_bytes / stride, UINT32_MAX));
        const std::optional<Span> elements = span({"element", ref_.element_first, ref_.element_last}, count);
        if (!elements) return std::nullopt;
        return FoundRange{{}, ByteRange{elements->first * stride, elements->count * stride}};
    }

    // Evaluates the index of a mip, layer or element, which must be a whole number in [0, count). Returns
    // nullopt after reporting an error.
    std::optional<uint32_t> index(const Expr& expression, const char* what, uint32_t count) const {
        const std::optional<ExprValue> value = evaluator_.value(expression);
        if (!value) {
            suspects_.passes[pass_] = 1;
            return std::nullopt;
        }
        const std::optional<uint32_t> index =
            value->is_size ? std::nullopt : whole_number<uint32_t>(value->x);
        if (index && *index < count) return *index;
        const bool fraction = !value->is_size && value->x != std::floor(value->x);
        const std::string found = value->is_size ? "a size" : number_text(value->x);
        Diagnostic& d = report_.error(pass_, ref_.loc, "W105",
                                      std::string(what) + " " + found + " of " + quote(ref_.name) +
                                          (fraction ? " is not a whole number" : " is out of range"));
        if (fraction) add_help(d, "round the value with floor(…) or ceil(…)");
        add_help(d, quote(ref_.name) + " has " +
                        (count == 1 ? std::string("only ") + what + " 0"
                                    : std::string(what) + "s 0 to " + std::to_string(count - 1)));
        return std::nullopt;
    }

    std::optional<Span> span(const Dimension& in, uint32_t count) const {
        if (!in.first) return Span{0, count};
        const std::optional<uint32_t> from = index(*in.first, in.what, count);
        if (!from || !in.last) return from ? std::optional(Span{*from, 1}) : std::nullopt;
        const std::optional<uint32_t> to = index(*in.last, in.what, count);
        if (!to) return std::nullopt;
        if (*to >= *from) return Span{*from, *to - *from + 1};
        fail(std::string("the ") + in.what + "s of " + quote(ref_.text) + " are in reverse order",
             "write the smaller number first: a..b with a <= b");
        return std::nullopt;
    }

    PassId pass_;
    const RefDesc& ref_;
    const Evaluator& evaluator_;
    Suspects& suspects_;
    PassReporter& report_;
};

}  // namespace

std::optional<FoundRange> find_range(PassId pass, const RefDesc& ref, const ResourceDecl& resource,
                                     const Evaluator& evaluator, Suspects& suspects, PassReporter& report) {
    return RangeFinder(pass, ref, evaluator, suspects, report).find(resource);
}

}  // namespace weft
