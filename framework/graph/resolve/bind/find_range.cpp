#include "graph/resolve/bind/find_range.h"

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

class RangeFinder {
 public:
    RangeFinder(PassId pass, const RefDesc& ref, const Evaluator& evaluator, Suspects& suspects,
                PassReporter& report)
        : pass_(pass), ref_(ref), evaluator_(evaluator), suspects_(suspects), report_(report) {}

    std::optional<SubresourceRange> find(const ResourceDecl& resource) const {
        if (resource.kind == ResourceKind::buffer) {
            if (!ref_.mip_first && !ref_.layer_first && ref_.aspects == 0) return SubresourceRange{};
            Diagnostic& d = report_.error(pass_, ref_.loc, "W105",
                                          quote(ref_.name) +
                                              " is a buffer, and buffers have no mips, "
                                              "layers or aspects");
            add_help(d, "write " + quote(ref_.name));
            return std::nullopt;
        }
        const std::optional<Span> mips = subresource_span("mip", resource.mips);
        const std::optional<Span> layers = subresource_span("layer", resource.layers);
        if (!mips || !layers) return std::nullopt;
        return SubresourceRange{mips->first, mips->count, layers->first, layers->count, ref_.aspects};
    }

 private:
    // Evaluates the index of a mip or layer, which must be a whole number in [0, count). `what` is "mip" or
    // "layer". Returns nullopt after reporting an error.
    std::optional<uint32_t> subresource_index(const Expr& expression, const char* what,
                                              uint32_t count) const {
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

    std::optional<Span> subresource_span(const char* what, uint32_t count) const {
        const bool is_mip = what[0] == 'm';
        const std::optional<Expr>& first = is_mip ? ref_.mip_first : ref_.layer_first;
        const std::optional<Expr>& last = is_mip ? ref_.mip_last : ref_.layer_last;
        if (!first) return Span{0, count};
        const std::optional<uint32_t> from = subresource_index(*first, what, count);
        if (!from || !last) return from ? std::optional(Span{*from, 1}) : std::nullopt;
        const std::optional<uint32_t> to = subresource_index(*last, what, count);
        if (!to) return std::nullopt;
        if (*to >= *from) return Span{*from, *to - *from + 1};
        Diagnostic& d =
            report_.error(pass_, ref_.loc, "W105",
                          std::string("the ") + what + "s of " + quote(ref_.text) + " are in reverse order");
        add_help(d, "write the smaller number first: a..b with a <= b");
        return std::nullopt;
    }

    PassId pass_;
    const RefDesc& ref_;
    const Evaluator& evaluator_;
    Suspects& suspects_;
    PassReporter& report_;
};

}  // namespace

std::optional<SubresourceRange> find_range(PassId pass, const RefDesc& ref, const ResourceDecl& resource,
                                           const Evaluator& evaluator, Suspects& suspects,
                                           PassReporter& report) {
    return RangeFinder(pass, ref, evaluator, suspects, report).find(resource);
}

}  // namespace weft
