#include "graph/parse/reference.h"

#include <cctype>
#include <charconv>
#include <optional>

#include "graph/parse/expression.h"

namespace weft {
namespace {

bool is_word_char(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

class ReferenceParser {
 public:
    ReferenceParser(const LocatedText& text, const SourceMap& sources) : text_(text), sources_(sources) {}

    Result<RefDesc> parse() {
        ref_.text = std::string(text_.text);
        ref_.loc = text_.literal;
        if (!name(ref_.name, "the name of a resource")) return std::move(*error_);
        while (position_ < text_.text.size())
            if (!part()) return std::move(*error_);
        return ref_;
    }

 private:
    bool fail(size_t offset, size_t length, const std::string& message, const std::string& help = {}) {
        if (error_) return false;
        error_ = sources_.error(text_.at(offset, length), "W106", message);
        error_->help.push_back(
            help.empty()
                ? "write name@pass[-N].mip(e).layer(e).depth or name.range(a..b); only the name is required"
                : help);
        return false;
    }
    bool fail_at(size_t offset, const std::string& wanted) {
        if (offset >= text_.text.size())
            return fail(offset, 1, "the reference ends where " + wanted + " was wanted");
        return fail(offset, 1,
                    std::string("found '") + text_.text[offset] + "' where " + wanted + " was wanted");
    }
    [[nodiscard]] char peek() const { return position_ < text_.text.size() ? text_.text[position_] : '\0'; }
    bool expect(char c) {
        if (peek() != c) return fail_at(position_, std::string("'") + c + "'");
        ++position_;
        return true;
    }
    void skip_spaces() {
        while (peek() == ' ') ++position_;
    }
    std::string word() {
        const size_t begin = position_;
        while (is_word_char(peek())) ++position_;
        return std::string(text_.text.substr(begin, position_ - begin));
    }
    bool identifier(std::string& out, const std::string& wanted) {
        const size_t begin = position_;
        out = word();
        if (!is_identifier(out)) return fail_at(begin, wanted);
        return true;
    }
    // Reads the name of a resource or pass, such as "raw", "relight::raw" or "glass::relight::raw".
    bool name(std::string& out, const std::string& wanted) {
        if (!identifier(out, wanted)) return false;
        while (text_.text.substr(position_, kInGroup.size()) == kInGroup) {
            position_ += kInGroup.size();
            std::string inner;
            if (!identifier(inner, wanted)) return false;
            out = name_in_group(out, inner);
        }
        return true;
    }

    bool part() {
        switch (peek()) {
            case '@':
                return pin();
            case '[':
                return history();
            case '.':
                return selector();
            default:
                return fail_at(position_, "'@', '[', '.' or the end");
        }
    }

    bool pin() {
        if (!ref_.pass.empty()) return fail(position_, 1, "the reference names two passes");
        ++position_;
        return name(ref_.pass, "the name of a pass");
    }

    bool history() {
        const size_t begin = position_++;
        if (ref_.history != 0) return fail(begin, 1, "the reference names an earlier frame twice");
        const std::string help = "write [-1] for the content at the end of the previous frame";
        if (peek() != '-')
            return fail(begin, 1, "the number of an earlier frame must be written as [-1], [-2], …", help);
        ++position_;
        const size_t digits = position_;
        const std::string number = word();
        const auto parsed = std::from_chars(number.data(), number.data() + number.size(), ref_.history);
        if (parsed.ec != std::errc{} || parsed.ptr != number.data() + number.size() || ref_.history == 0 ||
            ref_.history > kMaxHistory)
            return fail(digits, number.size(), "a reference can go back 1 to 16 frames, [-1] to [-16]", help);
        return expect(']');
    }

    bool selector() {
        const size_t begin = ++position_;
        const std::string name = word();
        if (name == "mip") return range(begin, name, ref_.mip_first, ref_.mip_last);
        if (name == "layer") return range(begin, name, ref_.layer_first, ref_.layer_last);
        if (name == "range") return range(begin, name, ref_.element_first, ref_.element_last);
        if (name == "depth" || name == "stencil") {
            if (ref_.aspects != 0) return fail(begin, name.size(), "the reference selects two aspects");
            ref_.aspects = name == "depth" ? aspect::kDepth : aspect::kStencil;
            return true;
        }
        if (name.empty()) return fail_at(begin, "mip, layer, range, depth or stencil");
        const std::string near = did_you_mean_text(name, {"mip", "layer", "range", "depth", "stencil"});
        return fail(begin, name.size(), "unknown selector \"." + name + "\"",
                    near.empty()
                        ? "allowed selectors are .mip(e), .layer(e), .range(a..b), .depth and .stencil"
                        : near);
    }

    bool range(size_t begin, const std::string& name, std::optional<Expr>& first, std::optional<Expr>& last) {
        if (first) return fail(begin, name.size(), "the reference has ." + name + "() twice");
        if (!expect('(') || !expression(first)) return false;
        skip_spaces();
        if (text_.text.substr(position_, 2) == "..") {
            position_ += 2;
            if (!expression(last)) return false;
            skip_spaces();
        }
        return expect(')');
    }

    bool expression(std::optional<Expr>& out) {
        Result<Expr> parsed = parse_expression_at(text_, position_, sources_);
        if (!parsed) {
            error_ = parsed.take_errors().front();
            return false;
        }
        out = std::move(*parsed);
        return true;
    }

    const LocatedText& text_;
    const SourceMap& sources_;
    size_t position_ = 0;
    RefDesc ref_;
    std::optional<Diagnostic> error_;
};

}  // namespace

Result<RefDesc> parse_reference(const LocatedText& text, const SourceMap& sources) {
    return ReferenceParser(text, sources).parse();
}

}  // namespace weft
