// Purpose: the state that all parts of the parser share: the list of errors, and readers for single values.
// Internal to weft_graph. A reader that finds an invalid value reports an error. Parsing then continues, so
// that further errors are found. Errors: W004 name too long, W101 unknown key, W102 wrong type, W108 missing
// key, W109 bad value, W125 limit exceeded.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "graph/diagnostics/quoted_list.h"
#include "graph/parse/grammar_tables.h"
#include "graph/syntax/module_names.h"
#include "graph/syntax/reference_name.h"
#include "weft/graph_desc.h"
#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// The names of the resources and passes of one group, without the name of the group.
struct GroupNames {
    const GroupDesc& group;
    std::set<std::string, std::less<>> resources, passes;
};

class ParseContext {
 public:
    static constexpr size_t kMaxErrors = 100;

    explicit ParseContext(const SourceMap& sources, const GraphLimits& limits = {})
        : sources_(sources), limits_(limits) {}

    // Adds an error and returns it. The reference is valid until the next error is added. If is_full() is
    // true, the error is not added: the function returns an empty Diagnostic that is never reported.
    Diagnostic& error(SourceLoc loc, std::string code, std::string message);
    void error(SourceLoc loc, std::string code, std::string message, std::string help);
    void add(Diagnostics errors);
    [[nodiscard]] const SourceMap& sources() const { return sources_; }
    [[nodiscard]] const GraphLimits& limits() const { return limits_; }
    // Checks that `count` is at most `limit`. If not, reports W125, ends parsing and returns false. `what`
    // names the counted things in the message, for example "debug views". `limit_name` is the name under
    // which a user can raise the limit, for example "graph.debugViews".
    bool within(size_t count, uint64_t limit, SourceLoc loc, const std::string& what, const char* limit_name,
                const std::string& help);
    // Completes a parsed expression or reference. Inside a group or module, the names of its parts become
    // full names such as "relight::raw". The parts (numbers, names and operations) are added to the total of
    // the graph. If the total exceeds the limit graph.expressionParts, reports an error and returns false.
    bool complete(Expr& expression);
    bool complete(RefDesc& ref);
    // Returns true if parsing should stop: kMaxErrors errors were reported, or within() has found a count
    // above its limit.
    [[nodiscard]] bool is_full() const { return is_over_limit_ || errors_.size() >= kMaxErrors; }
    [[nodiscard]] bool has_errors() const { return !errors_.empty(); }
    // Returns the errors, sorted by file, line and column. Errors of the main file come before those of
    // included files.
    [[nodiscard]] Diagnostics take_errors();

    // Sets the group whose content is parsed next; null: none.
    void set_group(const GroupNames* names) { names_ = names; }
    // Returns the group whose content is being parsed, or null.
    [[nodiscard]] const GroupDesc* group() const { return names_ == nullptr ? nullptr : &names_->group; }
    // Sets the names of the modules; null: the graph has no modules.
    void set_modules(const ModuleNames* modules) { modules_ = modules; }
    [[nodiscard]] const ModuleNames* modules() const { return modules_; }
    // Sets the indices that the expressions of the next pass or group may name.
    void set_indices(std::set<std::string, std::less<>> indices) { indices_ = std::move(indices); }
    [[nodiscard]] const std::set<std::string, std::less<>>& indices() const { return indices_; }

    // Returns the full name of a resource or pass that is declared here: "relight::raw" for "raw" in the
    // group "relight". Names in the sections of the graph are full names already.
    [[nodiscard]] std::string declared_name(const std::string& name) const {
        return names_ == nullptr ? name : name_in_group(names_->group.name, name);
    }
    // Return the full name of the part that `name` means at this place: "relight::raw" for "raw" if the group
    // "relight" is being parsed and has such a part; "glass::raw" if the file belongs to the module "glass";
    // else `name` itself.
    [[nodiscard]] std::string resource_name(const std::string& name, SourceLoc place) const;
    [[nodiscard]] std::string pass_name(const std::string& name, SourceLoc place) const;
    [[nodiscard]] std::string view_name(const std::string& name, SourceLoc place) const;
    [[nodiscard]] std::string import_name(const std::string& name, SourceLoc place) const;
    [[nodiscard]] std::string param_name(const std::string& name, SourceLoc place) const;

    void push(std::string_view key) { path_.emplace_back(key); }
    void pop() { path_.pop_back(); }

 private:
    [[nodiscard]] std::string pointer() const;
    [[nodiscard]] std::string value_name(const ExprNode& node) const;

    const SourceMap& sources_;
    const GraphLimits limits_;
    const GroupNames* names_ = nullptr;
    const ModuleNames* modules_ = nullptr;
    std::set<std::string, std::less<>> indices_;
    size_t parts_ = 0;
    bool is_over_limit_ = false;
    Diagnostics errors_;
    Diagnostic dropped_;
    std::vector<std::string> path_;
};

// Appends a key to the JSON pointer of reported errors while this object exists.
class PointerScope {
 public:
    PointerScope(ParseContext& context, std::string_view key) : context_(context) { context_.push(key); }
    ~PointerScope() { context_.pop(); }
    PointerScope(const PointerScope&) = delete;
    PointerScope& operator=(const PointerScope&) = delete;

 private:
    ParseContext& context_;
};

template <class T>
struct KeyRule {
    std::string_view key;
    void (*read)(ParseContext&, const JsonNode&, T&);
};
template <class E>
struct Choice {
    std::string_view name;
    E value;
};

// Readers for single JSON values. A reader that finds an invalid value reports an error and, if it returns a
// bool, returns false.
void wrong_type(ParseContext& context, const JsonNode& node, std::string_view wanted);
bool expect(ParseContext& context, const JsonNode& node, JsonKind wanted);
bool read_string(ParseContext& context, const JsonNode& node, std::string& out);
bool read_bool(ParseContext& context, const JsonNode& node, bool& out);
bool read_number(ParseContext& context, const JsonNode& node, double& out);
bool read_float(ParseContext& context, const JsonNode& node, float& out);
bool read_integer(ParseContext& context, const JsonNode& node, int64_t min, int64_t max, int64_t& out);
// Checks that a value is an array with `count` items. `wanted` is the count in the message; `help` tells what
// to write.
bool expect_items(ParseContext& context, const JsonNode& node, size_t count, const std::string& wanted,
                  std::string help);
// Reads an array of exactly out.size() numbers.
bool read_numbers(ParseContext& context, const JsonNode& node, std::span<double> out);
// Reads an expression: a number, or a string that contains an expression.
bool read_expression(ParseContext& context, const JsonNode& node, Expr& out);
// Reads a colour: one number for all four channels, or an array of four numbers. Strings with expressions are
// allowed as numbers.
void read_color(ParseContext& context, const JsonNode& node, std::optional<ColorDesc>& out);
// Reads an expression as read_expression() does, but also accepts true as 1 and false as 0.
bool read_switch(ParseContext& context, const JsonNode& node, Expr& out);
// Reads a size or a number: one number or expression, or an array [width, height] of numbers or expressions.
bool read_size(ParseContext& context, const JsonNode& node, Expr& out);
// Reads an array of names and records the source location of each name.
void read_names(ParseContext& context, const JsonNode& node, std::vector<std::string>& names,
                std::vector<SourceLoc>& locs);
bool check_identifier(ParseContext& context, std::string_view what, const std::string& name, SourceLoc loc);
// Reads a string that contains a reference to a resource, such as "hiz.mip(0)".
bool read_reference(ParseContext& context, const JsonNode& node, RefDesc& out);

void unknown_key(ParseContext& context, const JsonMember& member, std::string_view what,
                 const std::vector<std::string>& allowed);
void missing_key(ParseContext& context, SourceLoc loc, std::string_view what, std::string_view key,
                 std::string help);
void bad_choice(ParseContext& context, const JsonNode& node, const std::string& found,
                const std::vector<std::string>& allowed);

// Searches a table of allowed words and sets `out` to the value of the word `name`. Returns false if the
// table does not contain this word.
template <class E>
bool find_choice(std::span<const Choice<E>> choices, std::string_view name, E& out) {
    for (const Choice<E>& choice : choices) {
        if (choice.name != name) continue;
        out = choice.value;
        return true;
    }
    return false;
}

template <class E>
std::vector<std::string> choice_names(std::span<const Choice<E>> choices) {
    std::vector<std::string> names;
    for (const Choice<E>& choice : choices) names.emplace_back(choice.name);
    return names;
}

template <class E, size_t N>
bool read_choice(ParseContext& context, const JsonNode& node, const std::array<Choice<E>, N>& choices,
                 E& out) {
    const std::span<const Choice<E>> span(choices);
    if (!expect(context, node, JsonKind::string)) return false;
    if (find_choice(span, node.string, out)) return true;
    bad_choice(context, node, node.string, choice_names(span));
    return false;
}

// Reads an object whose allowed keys are the rows of a table, and calls the reader of each key that is
// present. Reports other keys as errors. Returns false only if the value is not an object. `what` names the
// object in messages, for example "a resource".
template <class T, size_t N>
bool read_object(ParseContext& context, const JsonNode& node, std::string_view what,
                 const std::array<KeyRule<T>, N>& rules, T& out) {
    if (!expect(context, node, JsonKind::object)) return false;
    for (const JsonMember& member : node.members) {
        if (context.is_full()) break;
        const PointerScope scope(context, member.key);
        const KeyRule<T>* found = nullptr;
        for (const KeyRule<T>& rule : rules)
            if (rule.key == member.key) found = &rule;
        if (found != nullptr) {
            found->read(context, member.value, out);
            continue;
        }
        std::vector<std::string> allowed;
        for (const KeyRule<T>& rule : rules) allowed.emplace_back(rule.key);
        unknown_key(context, member, what, allowed);
    }
    return true;
}

// Adds the keys of a table of rules to the lists that grammar_tables() returns.
template <class T, size_t N>
void list_keys(std::vector<GrammarTable>& lists, std::string place, const std::array<KeyRule<T>, N>& rules) {
    GrammarTable& list = lists.emplace_back(GrammarTable{std::move(place), true, {}});
    for (const KeyRule<T>& rule : rules) list.words.emplace_back(rule.key);
}

template <class E, size_t N>
void list_choices(std::vector<GrammarTable>& lists, std::string place,
                  const std::array<Choice<E>, N>& choices) {
    lists.push_back({std::move(place), false, choice_names(std::span<const Choice<E>>(choices))});
}

// Reads an object that maps names to values: calls read(member) if check(context, what, name, place) is true.
template <class Check, class F>
void read_members(ParseContext& context, const JsonNode& node, std::string_view what, Check check, F read) {
    if (!expect(context, node, JsonKind::object)) return;
    for (const JsonMember& member : node.members) {
        if (context.is_full()) break;
        const PointerScope scope(context, member.key);
        if (check(context, what, member.key, member.key_loc)) read(member);
    }
}

// Reads an object that maps identifiers to values.
template <class F>
void read_named(ParseContext& context, const JsonNode& node, std::string_view what, F read) {
    read_members(context, node, what, check_identifier, read);
}

// Checks the name of a part of the graph. It may begin with the name of a module: "glass::cull".
bool check_part_name(ParseContext& context, std::string_view what, const std::string& name, SourceLoc loc);

// Reads a section of the graph: like read_named(), but the names are names of parts.
template <class F>
void read_parts(ParseContext& context, const JsonNode& node, std::string_view what, F read) {
    read_members(context, node, what, check_part_name, read);
}

// Readers for rows of a table: read the member `Member` of the object, and store the place of the value in
// the member `Loc`.
template <auto Read, auto Member, class T>
void read_member(ParseContext& context, const JsonNode& node, T& out) {
    Read(context, node, out.*Member);
}
template <auto Read, auto Member, auto Loc, class T>
void read_located(ParseContext& context, const JsonNode& node, T& out) {
    out.*Loc = node.loc;
    Read(context, node, out.*Member);
}

// Parsers for the sections of a graph and of a pass. Each parses one JSON value and stores the result in
// `graph` or `pass`.
void parse_params(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_debug(ParseContext& context, const JsonNode& node, GraphDesc& graph);
// Parses the section "tests". Must run after the sections "tiers", "params", "imports" and "resources",
// because tests refer to their names.
void parse_tests(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_resources(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_passes(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_groups(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_views(ParseContext& context, const JsonNode& node, GraphDesc& graph);
// Parse the keys "view", "views", "into" and "lowering" of a pass.
void parse_view(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_pass_views(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_into(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_lowering(ParseContext& context, const JsonNode& node, PassDesc& pass);
// Checks the keys of a pass that do not go together with "views". Call it after all keys are parsed.
void check_pass_views(ParseContext& context, const JsonNode& node, const PassDesc& pass);
// Checks names of groups against other sections of the graph, after all sections are parsed: "turns" must
// name an import, and no resource or pass of a group may have the same name as a resource or pass outside the
// group.
void check_groups(ParseContext& context, const JsonNode& root, const GraphDesc& graph);
void parse_inputs(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_outputs(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_sampler(ParseContext& context, const JsonNode& node, PortDesc& port);
void parse_resolves(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_indirect(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_indirect_draws(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_procedural_draws(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_depth(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_constants(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_repeat(ParseContext& context, const JsonNode& node, PassDesc& pass);
// Returns the names of the indices in the "repeat" of a pass or group, and those of `outer`.
[[nodiscard]] std::set<std::string, std::less<>> indices_of(const JsonNode& node,
                                                            const std::vector<RepeatDesc>& outer);
// Reads the indices of a repeat and appends them to `repeats`, which may already contain the indices of a
// group.
void read_repeat(ParseContext& context, const JsonNode& node, std::vector<RepeatDesc>& repeats);
// Checks that the limit graph.constants allows one more constant, parameter or size. If not, reports an error
// and returns false.
bool check_value_count(ParseContext& context, const GraphDesc& graph, SourceLoc loc);
// Reports an index of a repeat, such as "i", if its name is also the name of a constant, parameter or size,
// or a reserved word of expressions.
void check_indices(ParseContext& context, const GraphDesc& graph);
void parse_pass_params(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_state(ParseContext& context, const JsonNode& node, PassDesc& pass);
// Parses blending and write masks of the colour attachments. `blend` and `write_mask` may be null. The
// outputs in pass.out must already be parsed.
void parse_blend(ParseContext& context, const JsonNode* blend, const JsonNode* write_mask, PassDesc& pass);

// Functions that append the keys and words of one part of the grammar to the lists of grammar_tables().
void list_graph_grammar(std::vector<GrammarTable>& lists);
void list_param_grammar(std::vector<GrammarTable>& lists);
void list_resource_grammar(std::vector<GrammarTable>& lists);
void list_pass_grammar(std::vector<GrammarTable>& lists);
void list_group_grammar(std::vector<GrammarTable>& lists);
void list_view_grammar(std::vector<GrammarTable>& lists);
void list_port_grammar(std::vector<GrammarTable>& lists);
void list_sampler_grammar(std::vector<GrammarTable>& lists);
void list_state_grammar(std::vector<GrammarTable>& lists);
void list_blend_grammar(std::vector<GrammarTable>& lists);
void list_debug_grammar(std::vector<GrammarTable>& lists);
void list_test_grammar(std::vector<GrammarTable>& lists);

}  // namespace weft
