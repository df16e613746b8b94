// Parses "repeat": { "i": "1..mips(hiz)-1", "j": "3..0 by -1" }, which repeats a pass for all values of its
// indices. The first index is the outer loop: here, "j" counts from 3 to 0 for each value of "i".
#include <algorithm>
#include <span>

#include "graph/parse/expression.h"
#include "graph/parse/module_scope.h"
#include "graph/parse/parse_context.h"
#include "graph/parse/reference.h"

namespace weft {
namespace {

constexpr const char* kRangeHelp =
    "write \"a..b\", which includes a and b and is empty if a > b; or \"a..b by -1\" to count down";

class RangeParser {
 public:
    RangeParser(ParseContext& context, const JsonNode& node)
        : context_(context), text_{node.string, node.loc} {}

    bool parse(RepeatDesc& repeat) {
        if (!expression(repeat.first) || !accept("..", "\"..\"") || !expression(repeat.last)) return false;
        skip_spaces();
        if (position_ == text_.text.size()) return true;
        if (!accept("by ", "\"by\" or the end") || !expression(repeat.step)) return false;
        skip_spaces();
        return position_ == text_.text.size() || fail("the end");
    }

 private:
    void skip_spaces() {
        while (position_ < text_.text.size() && text_.text[position_] == ' ') ++position_;
    }
    bool expression(Expr& out) {
        Result<Expr> parsed = parse_expression_at(text_, position_, context_.sources());
        if (!parsed) {
            context_.add(parsed.take_errors());
            return false;
        }
        out = std::move(*parsed);
        return context_.complete(out);
    }
    bool accept(std::string_view word, const std::string& wanted) {
        skip_spaces();
        if (text_.text.substr(position_, word.size()) != word) return fail(wanted);
        position_ += word.size();
        return true;
    }
    bool fail(const std::string& wanted) {
        const std::string found = position_ >= text_.text.size()
                                      ? "the range ends"
                                      : std::string("found '") + text_.text[position_] + "'";
        context_.error(text_.at(position_, 1), "W106", found + " where " + wanted + " was wanted",
                       kRangeHelp);
        return false;
    }

    ParseContext& context_;
    LocatedText text_;
    size_t position_ = 0;
};

const char* meaning_of(const GraphDesc& graph, const std::string& name) {
    if (graph.consts.contains(name)) return "a constant";
    if (graph.params.contains(name)) return "a parameter";
    if (graph.sizes.contains(name)) return "a size";
    return is_reserved_word(name) ? "a reserved word of expressions" : nullptr;
}

// Checks the names of the indices of one pass or group. `owner` is the key of the pass or group in the graph
// file.
void check_names(ParseContext& context, const GraphDesc& graph, std::string_view owner,
                 std::string_view module, std::span<const RepeatDesc> repeats) {
    const PointerScope owner_scope(context, owner);
    const PointerScope key_scope(context, "repeat");
    for (const RepeatDesc& repeat : repeats) {
        const PointerScope scope(context, repeat.index);
        const char* meaning = meaning_of(graph, name_in_module(graph, module, repeat.index));
        if (meaning == nullptr) continue;
        context.error(repeat.loc, "W109", "the index \"" + repeat.index + "\" is already " + meaning,
                      "choose another name for the index");
    }
}

// Checks the indices of a group, and the additional indices of its passes.
void check_group_indices(ParseContext& context, const GraphDesc& graph, const GroupDesc& group) {
    const std::string_view module = module_of(graph, group.name);
    check_names(context, graph, group.name, module, group.repeat);
    const PointerScope group_scope(context, group.name);
    const PointerScope section(context, "passes");
    const std::string prefix = name_in_group(group.name, "");
    for (auto at = graph.passes.lower_bound(prefix); at != graph.passes.end(); ++at) {
        const auto& [name, pass] = *at;
        if (pass.group != group.name) break;
        check_names(context, graph, name.substr(prefix.size()), module,
                    std::span(pass.repeat).subspan(group.repeat.size()));
    }
}

}  // namespace

void read_repeat(ParseContext& context, const JsonNode& node, std::vector<RepeatDesc>& repeats) {
    if (node.kind == JsonKind::object && node.members.empty())
        return context.error(node.loc, "W109", "the repeat has no index",
                             "add an index: \"repeat\": { \"i\": \"0..3\" }, or remove \"repeat\"");
    read_named(context, node, "an index", [&](const JsonMember& member) {
        if (!context.within(repeats.size() + 1, context.limits().repeat_indices, member.key_loc,
                            "indices in a repeat", "graph.repeatIndices", "combine several indices into one"))
            return;
        const auto has_name = [&](const RepeatDesc& other) { return other.index == member.key; };
        if (std::ranges::any_of(repeats, has_name))
            return context.error(member.key_loc, "W109",
                                 "the index \"" + member.key + "\" is already an index of the group",
                                 "choose another name for the index of the pass");
        RepeatDesc repeat;
        repeat.index = member.key;
        repeat.loc = member.key_loc;
        repeat.range_loc = member.value.loc;
        if (member.value.kind != JsonKind::string)
            return wrong_type(context, member.value, "a range in a string");
        if (RangeParser(context, member.value).parse(repeat)) repeats.push_back(std::move(repeat));
    });
}

std::set<std::string, std::less<>> indices_of(const JsonNode& node, const std::vector<RepeatDesc>& outer) {
    std::set<std::string, std::less<>> indices;
    for (const RepeatDesc& repeat : outer) indices.insert(repeat.index);
    if (const JsonNode* repeat = node.find("repeat"))
        for (const JsonMember& member : repeat->members) indices.insert(member.key);
    return indices;
}

void parse_repeat(ParseContext& context, const JsonNode& node, PassDesc& pass) {
    read_repeat(context, node, pass.repeat);
}

void check_indices(ParseContext& context, const GraphDesc& graph) {
    {
        const PointerScope section(context, "groups");
        for (const auto& [name, group] : graph.groups) check_group_indices(context, graph, group);
    }
    const PointerScope section(context, "passes");
    for (const auto& [name, pass] : graph.passes)
        if (pass.group.empty()) check_names(context, graph, name, pass.module, pass.repeat);
}

}  // namespace weft
