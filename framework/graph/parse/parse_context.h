// Purpose: state shared by all parts of the parser: the list of errors, and readers for single values.
// Internal to weft_graph. A reader that finds an invalid value reports it and leaves its target unchanged, so
// that parsing can continue and find other faults. Errors: W101 unknown key, W102 wrong type, W108 missing
// key, W109 bad value.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "graph/diagnostics/quoted_list.h"
#include "graph/parse/grammar_tables.h"
#include "weft/graph_desc.h"
#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

class ParseContext {
 public:
    static constexpr size_t kMaxErrors = 100;

    explicit ParseContext(const SourceMap& sources, const GraphLimits& limits = {})
        : sources_(sources), limits_(limits) {}

    // The reference is valid until the next error. Errors beyond a limit are dropped.
    Diagnostic& error(SourceLoc loc, std::string code, std::string message);
    void error(SourceLoc loc, std::string code, std::string message, std::string help);
    void add(Diagnostics errors);
    [[nodiscard]] const SourceMap& sources() const { return sources_; }
    [[nodiscard]] const GraphLimits& limits() const { return limits_; }
    // Returns false, reports W125 and ends parsing if `count` exceeds `limit`. `what` names the counted
    // things: "tiers".
    bool within(size_t count, uint64_t limit, SourceLoc loc, const std::string& what, const char* limit_name,
                const std::string& help);
    // Counts the parts of a parsed expression or reference; returns false and reports an error over the
    // limit.
    bool count_parts(const Expr& expression);
    bool count_parts(const RefDesc& ref);
    // True after so many faults or so much data that further parsing would only cost time.
    [[nodiscard]] bool is_full() const { return is_over_limit_ || errors_.size() >= kMaxErrors; }
    [[nodiscard]] bool has_errors() const { return !errors_.empty(); }
    [[nodiscard]] Diagnostics take_errors();  // in the order of places in the file

    void push(std::string_view key) { path_.emplace_back(key); }
    void pop() { path_.pop_back(); }

 private:
    [[nodiscard]] std::string pointer() const;

    const SourceMap& sources_;
    const GraphLimits limits_;
    size_t parts_ = 0;
    bool is_over_limit_ = false;
    Diagnostics errors_;
    Diagnostic dropped_;
    std::vector<std::string> path_;
};

// Adds one level to the JSON pointer during its lifetime.
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

// --- single values
// ---------------------------------------------------------------------------------------------
void wrong_type(ParseContext& context, const JsonNode& node, std::string_view wanted);
bool expect(ParseContext& context, const JsonNode& node, JsonKind wanted);
bool read_string(ParseContext& context, const JsonNode& node, std::string& out);
bool read_bool(ParseContext& context, const JsonNode& node, bool& out);
bool read_number(ParseContext& context, const JsonNode& node, double& out);
bool read_float(ParseContext& context, const JsonNode& node, float& out);
bool read_integer(ParseContext& context, const JsonNode& node, int64_t min, int64_t max, int64_t& out);
// An array of `count` numbers.
bool read_numbers(ParseContext& context, const JsonNode& node, std::span<double> out);
// A number or an expression in a string.
bool read_expression(ParseContext& context, const JsonNode& node, Expr& out);
// One number for all four channels, or an array of four.
void read_color(ParseContext& context, const JsonNode& node, std::optional<ColorDesc>& out);
// Like read_expression(), but also accepts true and false for 1 and 0.
bool read_switch(ParseContext& context, const JsonNode& node, Expr& out);
// A size or number: an expression, a number, or [width, height] of them.
bool read_size(ParseContext& context, const JsonNode& node, Expr& out);
// An array of names, with the place of each.
void read_names(ParseContext& context, const JsonNode& node, std::vector<std::string>& names,
                std::vector<SourceLoc>& locs);
bool check_identifier(ParseContext& context, std::string_view what, const std::string& name, SourceLoc loc);
// A reference in a string.
bool read_reference(ParseContext& context, const JsonNode& node, RefDesc& out);

void unknown_key(ParseContext& context, const JsonMember& member, std::string_view what,
                 const std::vector<std::string>& allowed);
void missing_key(ParseContext& context, SourceLoc loc, std::string_view what, std::string_view key,
                 std::string help);
void bad_choice(ParseContext& context, const JsonNode& node, const std::string& found,
                const std::vector<std::string>& allowed);

// --- composed values
// -------------------------------------------------------------------------------------------
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

// Reads the keys of an object as listed in a table; other keys are errors. `what` names the object: "a
// resource".
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

// The keys of a table, for grammar_tables().
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

// Calls read(member) for each entry of an object that maps names to values.
template <class F>
void read_named(ParseContext& context, const JsonNode& node, std::string_view what, F read) {
    if (!expect(context, node, JsonKind::object)) return;
    for (const JsonMember& member : node.members) {
        if (context.is_full()) break;
        const PointerScope scope(context, member.key);
        if (check_identifier(context, what, member.key, member.key_loc)) read(member);
    }
}

// --- the parts of a graph
// --------------------------------------------------------------------------------------
void parse_params(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_debug(ParseContext& context, const JsonNode& node, GraphDesc& graph);
// Reads graph.tiers, graph.params, graph.imports and graph.resources.
void parse_tests(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_resources(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_passes(ParseContext& context, const JsonNode& node, GraphDesc& graph);
void parse_inputs(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_outputs(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_resolves(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_indirect(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_indirect_draws(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_procedural_draws(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_depth(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_constants(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_repeat(ParseContext& context, const JsonNode& node, PassDesc& pass);
// Returns false and reports an error if there are more constants, parameters and sizes than the limit allows.
bool check_value_count(ParseContext& context, const GraphDesc& graph, SourceLoc loc);
// Checks the index names of repeats against each other and against all other names in expressions.
void check_indices(ParseContext& context, const GraphDesc& graph);
void parse_pass_params(ParseContext& context, const JsonNode& node, PassDesc& pass);
void parse_state(ParseContext& context, const JsonNode& node, PassDesc& pass);
// Blending and write masks of the colour attachments; either may be absent. Reads pass.out.
void parse_blend(ParseContext& context, const JsonNode* blend, const JsonNode* write_mask, PassDesc& pass);

// --- the words of each part
// -------------------------------------------------------------------------------------
void list_graph_words(std::vector<GrammarTable>& lists);
void list_param_words(std::vector<GrammarTable>& lists);
void list_resource_words(std::vector<GrammarTable>& lists);
void list_pass_words(std::vector<GrammarTable>& lists);
void list_port_words(std::vector<GrammarTable>& lists);
void list_state_words(std::vector<GrammarTable>& lists);
void list_blend_words(std::vector<GrammarTable>& lists);
void list_debug_words(std::vector<GrammarTable>& lists);
void list_test_words(std::vector<GrammarTable>& lists);

}  // namespace weft
