#include "weft/graph_builder.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "graph/builder/graph_text.h"
#include "weft/syntax/json_doc.h"

namespace weft {
namespace {

JsonNode empty_node(JsonKind kind) {
    JsonNode node;
    node.kind = kind;
    return node;
}

// The text of a number is written without quotes.
JsonNode text_node(JsonKind kind, std::string text) {
    JsonNode node = empty_node(kind);
    node.string = std::move(text);
    return node;
}

// Returns the shortest text that is read as exactly this number.
std::string shortest_text(double value) {
    std::array<char, 32> digits;
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

}  // namespace

GraphValue::GraphValue(JsonNode node) : node_(std::make_shared<const JsonNode>(std::move(node))) {}

GraphValue::GraphValue(Unquoted, std::string text)
    : GraphValue(text_node(JsonKind::number, std::move(text))) {}

GraphValue::GraphValue(std::string text) : GraphValue(text_node(JsonKind::string, std::move(text))) {}

GraphValue::GraphValue(double value) : GraphValue(Unquoted{}, shortest_text(value)) {}

GraphValue::GraphValue(std::initializer_list<GraphValue> items) {
    JsonNode list = empty_node(JsonKind::array);
    for (const GraphValue& item : items) list.items.push_back(item.node());
    node_ = std::make_shared<const JsonNode>(std::move(list));
}

GraphValue GraphValue::json(const std::string& text) {
    SourceMap sources;
    Result<JsonNode> node = read_json_file(sources, {}, text, {});
    if (node) return GraphValue(std::move(*node));
    // The text is written as it is. So the reader of the graph finds the fault again.
    return {Unquoted{}, text};
}

JsonNode& GraphObject::node() const {
    JsonNode* node = root_;
    for (const size_t index : path_) node = &node->members[index].value;
    return *node;
}

size_t GraphObject::section_index(const std::string& section) {
    std::vector<JsonMember>& members = node().members;
    const auto found = std::ranges::find_if(members, [&](const JsonMember& member) {
        return member.key == section && member.value.kind == JsonKind::object;
    });
    if (found == members.end()) {
        members.push_back({section, {}, empty_node(JsonKind::object)});
        return members.size() - 1;
    }
    return static_cast<size_t>(found - members.begin());
}

void GraphObject::add(const std::string& key, const GraphValue& value) {
    node().members.push_back({key, {}, value.node()});
}

void GraphObject::add_to(const std::string& section, const std::string& key, const GraphValue& value) {
    const size_t index = section_index(section);
    node().members[index].value.members.push_back({key, {}, value.node()});
}

GraphObject GraphObject::add_object(const std::string& section, const std::string& key) {
    GraphObject object = *this;
    object.path_.push_back(section_index(section));
    std::vector<JsonMember>& members = object.node().members;
    members.push_back({key, {}, empty_node(JsonKind::object)});
    object.path_.push_back(members.size() - 1);
    return object;
}

GraphBuilder::GraphBuilder(std::string name)
    : GraphBuilder(std::move(name), std::make_shared<JsonNode>(empty_node(JsonKind::object))) {}

GraphBuilder::GraphBuilder(std::string name, std::shared_ptr<JsonNode> root)
    : GraphKeys(GraphObject(*root)), name_(std::move(name)), root_(std::move(root)) {
    set("version", 1);
    set("name", name_);
}

GraphBuilder& GraphBuilder::include(const std::string& file) {
    for (JsonMember& member : root_->members)
        if (member.key == "include" && member.value.kind == JsonKind::array) {
            member.value.items.push_back(GraphValue(file).node());
            return *this;
        }
    return set("include", {file});
}

ParamBuilder GraphBuilder::param(const std::string& name, GraphValue default_value) {
    return ParamBuilder(object_.add_object("params", name)).set("default", std::move(default_value));
}

ResourceBuilder GraphBuilder::image(const std::string& name, const std::string& format) {
    return ResourceBuilder(object_.add_object("resources", name)).set("format", format);
}

ResourceBuilder GraphBuilder::buffer(const std::string& name, const std::string& type, GraphValue count) {
    return ResourceBuilder(object_.add_object("resources", name))
        .set("buffer", type)
        .set("count", std::move(count));
}

PassBuilder GraphBuilder::compute(const std::string& name, const std::string& shader) {
    return pass(name, "compute").set("shader", shader);
}

PassBuilder GraphBuilder::fullscreen(const std::string& name, const std::string& shader) {
    return pass(name, "fullscreen").set("shader", shader);
}

PassBuilder GraphBuilder::raster(const std::string& name, const std::string& shader) {
    return pass(name, "raster").set("shader", shader);
}

PassBuilder GraphBuilder::pass(const std::string& name, const std::string& type) {
    return PassBuilder(object_.add_object("passes", name)).set("type", type);
}

EntryBuilder GraphBuilder::entry(const std::string& section, const std::string& name) {
    return EntryBuilder(object_.add_object(section, name));
}

std::string GraphBuilder::to_json() const {
    return graph_text(*root_);
}

}  // namespace weft
