#include "graph/parse/expression.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "graph/syntax/reference_name.h"

namespace weft {
namespace {

constexpr int kMaxNesting = 64;
constexpr const char* kLanguage =
    "expressions allow + - * / % ( ) min max ceil floor log2 mips(resource) .x .y, names and numbers";

struct FunctionRule {
    std::string_view name;
    ExprOp op;
    int min_arguments;
    int max_arguments;
};
constexpr std::array kFunctions{
    FunctionRule{"min", ExprOp::min, 2, 16},  FunctionRule{"max", ExprOp::max, 2, 16},
    FunctionRule{"ceil", ExprOp::ceil, 1, 1}, FunctionRule{"floor", ExprOp::floor, 1, 1},
    FunctionRule{"log2", ExprOp::log2, 1, 1},
};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_name_start(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_name_char(char c) {
    return is_name_start(c) || is_digit(c);
}

// Parses an expression by recursive descent and emits postfix code: operands first, then their operator.
// Stops at the first error.
class ExpressionParser {
 public:
    ExpressionParser(const LocatedText& text, size_t position, const SourceMap& sources)
        : text_(text), position_(position), sources_(sources) {}

    bool parse() { return sum() && check_length(); }
    bool at_end() {
        skip_spaces();
        return position_ >= text_.text.size();
    }
    bool fail(size_t offset, size_t length, const std::string& message, const std::string& help = {}) {
        if (error_) return false;
        error_ = sources_.error(text_.at(offset, length), "W106", message);
        error_->help.push_back(help.empty() ? kLanguage : help);
        return false;
    }
    bool fail_here(const std::string& wanted) {
        skip_spaces();
        if (position_ >= text_.text.size())
            return fail(position_, 1, "the expression ends where " + wanted + " was wanted");
        return fail(position_, 1,
                    std::string("found '") + text_.text[position_] + "' where " + wanted + " was wanted");
    }

    [[nodiscard]] size_t position() const { return position_; }
    std::vector<ExprNode> take_nodes() { return std::move(nodes_); }
    Diagnostic take_error() { return std::move(*error_); }

 private:
    [[nodiscard]] char peek(size_t ahead = 0) const {
        return position_ + ahead < text_.text.size() ? text_.text[position_ + ahead] : '\0';
    }
    void skip_spaces() {
        while (peek() == ' ' || peek() == '\t') ++position_;
    }
    bool accept(char c) {
        skip_spaces();
        if (peek() != c) return false;
        ++position_;
        return true;
    }
    bool check_length() {
        if (nodes_.size() <= kMaxExpressionNodes) return true;
        return fail(0, text_.text.size(), "the expression is too long: at most 1,024 parts are allowed",
                    "move a part of the expression to \"sizes\" or \"consts\", and use its name here");
    }
    bool emit(ExprOp op, size_t offset, size_t length, double number = 0, std::string name = {}) {
        nodes_.push_back({op, number, std::move(name), text_.at(offset, length)});
        return check_length();
    }

    bool sum() {
        if (++nesting_ > kMaxNesting)
            return fail(position_, 1, "the expression is nested too deeply: at most 64 levels are allowed");
        if (!product()) return false;
        for (;;) {
            skip_spaces();
            const size_t at = position_;
            const bool add = accept('+');
            if (!add && !accept('-')) break;
            if (!product() || !emit(add ? ExprOp::add : ExprOp::sub, at, 1)) return false;
        }
        --nesting_;
        return true;
    }

    bool product() {
        if (!unary()) return false;
        for (;;) {
            skip_spaces();
            const size_t at = position_;
            const char c = peek();
            if (c != '*' && c != '/' && c != '%') return true;
            ++position_;
            const ExprOp op = c == '*' ? ExprOp::mul : c == '/' ? ExprOp::div : ExprOp::mod;
            if (!unary() || !emit(op, at, 1)) return false;
        }
    }

    bool unary() {
        skip_spaces();
        std::vector<size_t> signs;
        while (accept('-')) signs.push_back(position_ - 1);
        if (!selection()) return false;
        for (auto it = signs.rbegin(); it != signs.rend(); ++it)
            if (!emit(ExprOp::negate, *it, 1)) return false;
        return true;
    }

    bool selection() {
        if (!primary()) return false;
        // A single dot selects a component, as in "size.x". Two dots belong to a range, such as "0..3".
        while (peek() == '.' && peek(1) != '.') {
            const size_t at = position_++;
            const char c = peek();
            if ((c != 'x' && c != 'y') || is_name_char(peek(1)))
                return fail(at, 1, "found '.' without x or y after it",
                            "write .x for the width, .y for the height");
            ++position_;
            if (!emit(c == 'x' ? ExprOp::select_x : ExprOp::select_y, at, 2)) return false;
        }
        return true;
    }

    bool primary() {
        skip_spaces();
        if (accept('(')) return sum() && (accept(')') || fail_here("')'"));
        if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) return number();
        if (is_name_start(peek())) return name_or_call();
        return fail_here("a number, a name or '('");
    }

    bool number() {
        const size_t begin = position_;
        while (is_digit(peek())) ++position_;
        if (peek() == '.' && is_digit(peek(1))) {
            ++position_;
            while (is_digit(peek())) ++position_;
        }
        const std::string_view spelling = text_.text.substr(begin, position_ - begin);
        if (is_name_start(peek()))
            return fail(begin, spelling.size() + 1, "a name cannot begin with a digit",
                        "put an operator between the number and the name");
        double value = 0;
        const auto parsed = std::from_chars(spelling.data(), spelling.data() + spelling.size(), value);
        if (parsed.ec != std::errc{}) return fail(begin, spelling.size(), "the number is out of range");
        return emit(ExprOp::number, begin, spelling.size(), value);
    }

    std::string word() {
        const size_t begin = position_;
        while (is_name_char(peek())) ++position_;
        return std::string(text_.text.substr(begin, position_ - begin));
    }

    // Reads a name, which may begin with the names of modules: "glass::bias".
    std::string full_word() {
        std::string name = word();
        while (peek() == ':' && peek(1) == ':' && is_name_start(peek(2))) {
            position_ += kInGroup.size();
            name = name_in_group(name, word());
        }
        return name;
    }

    bool name_or_call() {
        const size_t begin = position_;
        const std::string name = full_word();
        skip_spaces();
        if (peek() != '(') {
            position_ = begin + name.size();
            return emit(ExprOp::name, begin, name.size(), 0, name);
        }
        ++position_;
        if (name == "mips") return mips_call();
        for (const FunctionRule& rule : kFunctions)
            if (rule.name == name) return call(rule, begin);
        std::vector<std::string> known{"mips"};
        for (const FunctionRule& rule : kFunctions) known.emplace_back(rule.name);
        const std::string near = did_you_mean_text(name, known);
        return fail(begin, name.size(), "unknown function \"" + name + "\"",
                    near.empty() ? "functions are min, max, ceil, floor, log2 and mips" : near);
    }

    bool mips_call() {
        skip_spaces();
        const size_t begin = position_;
        if (!is_name_start(peek())) return fail_here("the name of an image");
        const std::string name = full_word();
        if (!emit(ExprOp::mips_of, begin, name.size(), 0, name)) return false;
        return accept(')') || fail_here("')'");
    }

    bool call(const FunctionRule& rule, size_t begin) {
        int arguments = 0;
        do {
            if (!sum()) return false;
            ++arguments;
            if (arguments >= 2 && arguments <= rule.max_arguments && !emit(rule.op, begin, rule.name.size()))
                return false;
        } while (accept(','));
        if (!accept(')')) return fail_here("',' or ')'");
        if (arguments < rule.min_arguments || arguments > rule.max_arguments) {
            const std::string wanted = rule.max_arguments == 1 ? "one argument" : "2 to 16 arguments";
            return fail(begin, rule.name.size(),
                        std::string(rule.name) + " takes " + wanted + ", found " + std::to_string(arguments));
        }
        return rule.max_arguments > 1 || emit(rule.op, begin, rule.name.size());
    }

    const LocatedText& text_;
    size_t position_;
    const SourceMap& sources_;
    int nesting_ = 0;
    std::vector<ExprNode> nodes_;
    std::optional<Diagnostic> error_;
};

Result<Expr> parse_from(const LocatedText& text, size_t& position, const SourceMap& sources, bool whole) {
    ExpressionParser parser(text, position, sources);
    const size_t begin = position;
    if (!parser.parse()) return parser.take_error();
    if (whole && !parser.at_end()) {
        parser.fail_here("an operator or the end");
        return parser.take_error();
    }
    position = parser.position();
    Expr expression;
    expression.postfix = parser.take_nodes();
    size_t end = position;
    while (end > begin && text.text[end - 1] == ' ') --end;
    expression.text = std::string(text.text.substr(begin, end - begin));
    expression.loc = text.at(begin, end - begin);
    return expression;
}

}  // namespace

Result<Expr> parse_expression(const LocatedText& text, const SourceMap& sources) {
    size_t position = 0;
    return parse_from(text, position, sources, true);
}

Result<Expr> parse_expression_at(const LocatedText& text, size_t& position, const SourceMap& sources) {
    return parse_from(text, position, sources, false);
}

Expr number_expression(double number, SourceLoc loc) {
    std::array<char, 32> spelling{};
    const auto end = std::to_chars(spelling.data(), spelling.data() + spelling.size(), number).ptr;
    return {{{ExprOp::number, number, {}, loc}}, std::string(spelling.data(), end), loc};
}

Expr name_expression(const std::string& name, SourceLoc loc) {
    return {{{ExprOp::name, 0, name, loc}}, name, loc};
}

Expr size_expression(const Expr& width, const Expr& height, SourceLoc loc) {
    Expr size{width.postfix, "[" + width.text + ", " + height.text + "]", loc};
    size.postfix.insert(size.postfix.end(), height.postfix.begin(), height.postfix.end());
    size.postfix.push_back({ExprOp::make_size, 0, {}, loc});
    return size;
}

bool is_reserved_word(std::string_view name) {
    const auto named = [&](const FunctionRule& rule) { return rule.name == name; };
    return name == "output" || name == "mips" || std::any_of(kFunctions.begin(), kFunctions.end(), named);
}

bool is_identifier(std::string_view name) {
    return !name.empty() && is_name_start(name.front()) &&
           std::all_of(name.begin(), name.end(), is_name_char);
}

}  // namespace weft
