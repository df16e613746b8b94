#include "graph/parse/parse_context.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "graph/parse/expression.h"
#include "graph/parse/reference.h"

namespace weft {
namespace {

constexpr size_t kShortList = 16;

}  // namespace

Diagnostic& ParseContext::error(SourceLoc loc, std::string code, std::string message) {
    if (is_full()) return dropped_ = Diagnostic{};
    const size_t before = errors_.size();
    add({sources_.error(loc, std::move(code), std::move(message))});
    return errors_.size() == before ? dropped_ = Diagnostic{} : errors_.back();
}

void ParseContext::error(SourceLoc loc, std::string code, std::string message, std::string help) {
    error(loc, std::move(code), std::move(message)).help.push_back(std::move(help));
}

void ParseContext::add(Diagnostics errors) {
    for (Diagnostic& one : errors) {
        if (is_full()) return;
        one.pointer = pointer();
        if (one.source_line.size() > kMaxExcerptBytes) one.source_line.clear();
        // If a file belongs to several modules, each of its errors is reported only once.
        const auto is_known = [&](const Diagnostic& d) {
            return d.line == one.line && d.column == one.column && d.file == one.file && d.code == one.code &&
                   d.message == one.message;
        };
        if (modules_ != nullptr && std::ranges::any_of(errors_, is_known)) continue;
        errors_.push_back(std::move(one));
    }
}

bool ParseContext::within(size_t count, uint64_t limit, SourceLoc loc, const std::string& what,
                          const char* limit_name, const std::string& help) {
    if (count <= limit) return true;
    if (is_full()) return false;
    error(loc, "W125", "the graph has more than " + std::to_string(limit) + " " + what,
          help + ", " + raise_limit_text(limit_name));
    is_over_limit_ = true;
    return false;
}

std::string ParseContext::resource_name(const std::string& name, SourceLoc place) const {
    if (names_ != nullptr && names_->resources.contains(name)) return declared_name(name);
    return modules_ == nullptr ? name : modules_->full_name(NameKind::resource, name, place);
}

std::string ParseContext::pass_name(const std::string& name, SourceLoc place) const {
    if (names_ != nullptr && names_->passes.contains(name)) return declared_name(name);
    return modules_ == nullptr || name.empty() ? name : modules_->full_name(NameKind::pass, name, place);
}

std::string ParseContext::view_name(const std::string& name, SourceLoc place) const {
    return modules_ == nullptr ? name : modules_->full_name(NameKind::view, name, place);
}

std::string ParseContext::import_name(const std::string& name, SourceLoc place) const {
    return modules_ == nullptr ? name : modules_->import_name(name, place);
}

std::string ParseContext::param_name(const std::string& name, SourceLoc place) const {
    return modules_ == nullptr ? name : modules_->full_name(NameKind::value, name, place);
}

std::string ParseContext::value_name(const ExprNode& node) const {
    const bool is_index = indices_.contains(node.name) || node.name == kViewIndex;
    return is_index ? node.name : modules_->full_name(NameKind::value, node.name, node.loc);
}

bool ParseContext::complete(Expr& expression) {
    if (names_ != nullptr || modules_ != nullptr)
        for (ExprNode& node : expression.postfix) {
            if (node.op == ExprOp::mips_of) node.name = resource_name(node.name, node.loc);
            if (node.op == ExprOp::name && modules_ != nullptr) node.name = value_name(node);
        }
    parts_ += expression.postfix.size();
    return within(parts_, limits_.expression_parts, expression.loc, "parts of expressions",
                  "graph.expressionParts", "define repeated expressions once, in \"consts\" or \"sizes\"");
}

bool ParseContext::complete(RefDesc& ref) {
    ref.name = resource_name(ref.name, ref.loc);
    ref.pass = pass_name(ref.pass, ref.loc);
    for (std::optional<Expr>* part : {&ref.mip_first, &ref.mip_last, &ref.layer_first, &ref.layer_last,
                                      &ref.element_first, &ref.element_last})
        if (*part && !complete(**part)) return false;
    return true;
}

Diagnostics ParseContext::take_errors() {
    if (errors_.size() >= kMaxErrors) errors_.back().help.emplace_back("only the first 100 errors are shown");
    const std::string& main = sources_.files.empty() ? std::string() : sources_.files.front().path;
    std::stable_sort(errors_.begin(), errors_.end(), [&](const Diagnostic& a, const Diagnostic& b) {
        const bool a_included = a.file != main, b_included = b.file != main;
        return std::tie(a_included, a.file, a.line, a.column) <
               std::tie(b_included, b.file, b.line, b.column);
    });
    return std::move(errors_);
}

// Returns the JSON pointer (RFC 6901) of the value that is being parsed, for error messages.
std::string ParseContext::pointer() const {
    std::string text;
    for (const std::string& key : path_) {
        text += '/';
        for (const char c : key) {
            if (c == '~')
                text += "~0";
            else if (c == '/')
                text += "~1";
            else
                text += c;
        }
    }
    return text;
}

void wrong_type(ParseContext& context, const JsonNode& node, std::string_view wanted) {
    Diagnostic& error =
        context.error(node.loc, "W102",
                      std::string("found ") + json_kind_name(node.kind) + ", wanted " + std::string(wanted));
    if (node.kind == JsonKind::string &&
        wanted.find(json_kind_name(JsonKind::number)) != std::string_view::npos)
        error.help.emplace_back("write the number without quotes");
    else if (node.kind == JsonKind::string && wanted == json_kind_name(JsonKind::boolean))
        error.help.emplace_back("write true or false without quotes");
    else if (wanted == json_kind_name(JsonKind::object))
        error.help.emplace_back("write { … } here");
    else if (wanted == json_kind_name(JsonKind::array))
        error.help.emplace_back("write [ … ] here");
    else
        error.help.emplace_back("write a value of the wanted type here");
}

bool expect(ParseContext& context, const JsonNode& node, JsonKind wanted) {
    if (node.kind == wanted) return true;
    wrong_type(context, node, json_kind_name(wanted));
    return false;
}

bool read_string(ParseContext& context, const JsonNode& node, std::string& out) {
    if (!expect(context, node, JsonKind::string)) return false;
    if (node.string.empty()) {
        context.error(node.loc, "W109", "the string is empty", "write a text, or remove the key");
        return false;
    }
    out = node.string;
    return true;
}

bool read_bool(ParseContext& context, const JsonNode& node, bool& out) {
    if (!expect(context, node, JsonKind::boolean)) return false;
    out = node.boolean;
    return true;
}

bool read_number(ParseContext& context, const JsonNode& node, double& out) {
    if (!expect(context, node, JsonKind::number)) return false;
    out = node.number;
    return true;
}

bool read_float(ParseContext& context, const JsonNode& node, float& out) {
    double number = 0;
    if (!read_number(context, node, number)) return false;
    if (std::abs(number) > static_cast<double>(std::numeric_limits<float>::max())) {
        context.error(node.loc, "W109", "the number is out of range",
                      "use a magnitude of at most 3.4e38, the limit of single precision");
        return false;
    }
    out = static_cast<float>(number);
    return true;
}

bool read_integer(ParseContext& context, const JsonNode& node, int64_t min, int64_t max, int64_t& out) {
    double number = 0;
    if (!read_number(context, node, number)) return false;
    if (number != std::floor(number) || number < static_cast<double>(min) ||
        number > static_cast<double>(max)) {
        context.error(node.loc, "W109", "found " + node.string + ", wanted a whole number",
                      "write a number from " + std::to_string(min) + " to " + std::to_string(max));
        return false;
    }
    out = static_cast<int64_t>(number);
    return true;
}

bool expect_items(ParseContext& context, const JsonNode& node, size_t count, const std::string& wanted,
                  std::string help) {
    if (!expect(context, node, JsonKind::array)) return false;
    if (node.items.size() == count) return true;
    context.error(node.loc, "W109",
                  "found " + std::to_string(node.items.size()) + " values, wanted " + wanted,
                  std::move(help));
    return false;
}

bool read_numbers(ParseContext& context, const JsonNode& node, std::span<double> out) {
    const std::string count = std::to_string(out.size());
    if (!expect_items(context, node, out.size(), count, "write " + count + " numbers")) return false;
    bool good = true;
    for (size_t i = 0; i < out.size(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        good = read_number(context, node.items[i], out[i]) && good;
    }
    return good;
}

bool read_expression(ParseContext& context, const JsonNode& node, Expr& out) {
    if (node.kind == JsonKind::number) {
        out = number_expression(node.number, node.loc);
        return context.complete(out);
    }
    if (node.kind != JsonKind::string) {
        wrong_type(context, node, "a number or an expression in a string");
        return false;
    }
    Result<Expr> parsed = parse_expression({node.string, node.loc}, context.sources());
    if (!parsed) {
        context.add(parsed.take_errors());
        return false;
    }
    if (!context.complete(*parsed)) return false;
    out = std::move(*parsed);
    return true;
}

namespace {

// Reads one channel of a colour. A literal number must fit into a float, because colour channels are floats.
bool read_channel(ParseContext& context, const JsonNode& node, Expr& out) {
    float number = 0;
    if (node.kind == JsonKind::number && !read_float(context, node, number)) return false;
    return read_expression(context, node, out);
}

}  // namespace

void read_color(ParseContext& context, const JsonNode& node, std::optional<ColorDesc>& out) {
    ColorDesc color;
    const bool one = node.kind == JsonKind::number || node.kind == JsonKind::string;
    if (one) {
        if (!read_channel(context, node, color.channels[0])) return;
        color.channels.fill(color.channels[0]);
        out = color;
        return;
    }
    if (node.kind != JsonKind::array) return wrong_type(context, node, "a number or four numbers");
    if (!expect_items(context, node, color.channels.size(), "4", "write 4 numbers")) return;
    bool good = true;
    for (size_t i = 0; i < color.channels.size(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        good = read_channel(context, node.items[i], color.channels[i]) && good;
    }
    if (good) out = color;
}

bool read_size(ParseContext& context, const JsonNode& node, Expr& out) {
    if (node.kind != JsonKind::array) return read_expression(context, node, out);
    if (!expect_items(context, node, 2, "two", "write a size as [width, height]")) return false;
    Expr width, height;
    const bool has_width = read_expression(context, node.items[0], width);
    if (!read_expression(context, node.items[1], height) || !has_width) return false;
    out = size_expression(width, height, node.loc);
    return true;
}

void read_names(ParseContext& context, const JsonNode& node, std::vector<std::string>& names,
                std::vector<SourceLoc>& locs) {
    if (!expect(context, node, JsonKind::array)) return;
    for (size_t i = 0; i < node.items.size() && !context.is_full(); ++i) {
        const PointerScope scope(context, std::to_string(i));
        std::string name;
        if (!read_string(context, node.items[i], name)) continue;
        names.push_back(std::move(name));
        locs.push_back(node.items[i].loc);
    }
}

namespace {

// Reports a name such as "glass::blur" if no module has the name "glass".
void unknown_module(ParseContext& context, std::string_view what, const std::string& name,
                    const std::string& module, SourceLoc loc) {
    const std::vector<std::string> known =
        context.modules() != nullptr ? context.modules()->names() : std::vector<std::string>();
    const std::string near = did_you_mean_text(module, known);
    context.error(loc, "W109",
                  "\"" + name + "\" is not a valid name for " + std::string(what) +
                      ": no module has the name \"" + module + "\"",
                  !near.empty() ? near
                  : known.empty()
                      ? "a name with :: belongs to a module: include its file with \"as\": \"" + module + "\""
                      : "the modules are " + quoted_list(known));
}

}  // namespace

bool check_identifier(ParseContext& context, std::string_view what, const std::string& name, SourceLoc loc) {
    if (name.size() > context.limits().name_bytes) {
        context.error(loc, "W004",
                      "the name of " + std::string(what) + " has " + std::to_string(name.size()) +
                          " bytes, more than " + std::to_string(context.limits().name_bytes),
                      "choose a shorter name, " + raise_limit_text("graph.nameBytes"));
        return false;
    }
    if (is_identifier(name)) return true;
    if (const size_t owner = name.rfind(kInGroup); owner != std::string::npos) {
        unknown_module(context, what, name, name.substr(0, owner), loc);
        return false;
    }
    context.error(loc, "W109", "\"" + name + "\" is not a valid name for " + std::string(what),
                  "use only letters, digits and _, and begin with a letter or _");
    return false;
}

bool check_part_name(ParseContext& context, std::string_view what, const std::string& name, SourceLoc loc) {
    const ModuleNames* modules = context.modules();
    if (modules == nullptr || context.group() != nullptr || name.size() > context.limits().name_bytes)
        return check_identifier(context, what, name, loc);
    return check_identifier(context, what, std::string(modules->own_part(name)), loc);
}

bool read_reference(ParseContext& context, const JsonNode& node, RefDesc& out) {
    if (!expect(context, node, JsonKind::string)) return false;
    Result<RefDesc> ref = parse_reference({node.string, node.loc}, context.sources());
    if (!ref) {
        context.add(ref.take_errors());
        return false;
    }
    out = std::move(*ref);
    return context.complete(out);
}

void unknown_key(ParseContext& context, const JsonMember& member, std::string_view what,
                 const std::vector<std::string>& allowed) {
    Diagnostic& error =
        context.error(member.key_loc, "W101", "unknown key \"" + member.key + "\" in " + std::string(what));
    const std::string near = did_you_mean_text(member.key, allowed);
    if (!near.empty()) error.help.push_back(near);
    if (allowed.size() <= kShortList)
        error.help.push_back(allowed.empty() ? "no keys are allowed here"
                                             : "allowed keys are " + quoted_list(allowed));
    else if (near.empty())
        error.help.emplace_back("remove this key, or move it to another object");
}

void missing_key(ParseContext& context, SourceLoc loc, std::string_view what, std::string_view key,
                 std::string help) {
    context.error(loc, "W108", std::string(what) + " needs the key \"" + std::string(key) + "\"",
                  std::move(help));
}

void bad_choice(ParseContext& context, const JsonNode& node, const std::string& found,
                const std::vector<std::string>& allowed) {
    Diagnostic& error = context.error(node.loc, "W109", "\"" + found + "\" is not an allowed value here");
    const std::string near = did_you_mean_text(found, allowed);
    if (!near.empty()) error.help.push_back(near);
    error.help.push_back("allowed values are " + quoted_list(allowed));
}

}  // namespace weft
