#include "weft/graph_builder.h"

#include <array>
#include <charconv>

#include "graph/builder/graph_object.h"
#include "graph/builder/json_text.h"

namespace weft {
namespace {

// Returns the shortest decimal text that is converted back to exactly this number.
std::string shortest_text(double value) {
    std::array<char, 32> digits;
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

}  // namespace

GraphValue::GraphValue(double value) : json_(shortest_text(value)) {}

GraphValue::GraphValue(const std::string& text) : json_(json_string(text)) {}

GraphValue::GraphValue(const std::vector<GraphValue>& items) {
    for (const GraphValue& item : items) json_ += (json_.empty() ? "[" : ", ") + item.json_;
    json_ += json_.empty() ? "[]" : "]";
}

GraphValue GraphValue::json(const std::string& text) {
    SourceMap sources;
    const Result<JsonNode> node = read_json_file(sources, {}, text, {});
    GraphValue value(false);
    // If the text is not valid JSON, it is stored unchanged. Then the stage that reads the graph reports the
    // error.
    value.json_ = node ? json_text(*node) : text;
    return value;
}

template <class Derived>
Derived GraphKeys<Derived>::set(const std::string& key, const GraphValue& value) const {
    object_->add(key, value.to_json());
    return Derived(*object_);
}

template <class Derived>
Derived GraphKeys<Derived>::set_in(const std::string& section, const std::string& key,
                                   const GraphValue& value) const {
    object_->section(section).add(key, value.to_json());
    return Derived(*object_);
}

template class GraphKeys<EntryBuilder>;
template class GraphKeys<ParamBuilder>;
template class GraphKeys<ResourceBuilder>;
template class GraphKeys<PassBuilder>;

GraphBuilder::GraphBuilder(const std::string& name) : name_(name), root_(std::make_unique<GraphObject>()) {
    set("version", 1).set("name", name);
}

GraphBuilder::~GraphBuilder() = default;
GraphBuilder::GraphBuilder(GraphBuilder&&) noexcept = default;
GraphBuilder& GraphBuilder::operator=(GraphBuilder&&) noexcept = default;

GraphBuilder& GraphBuilder::set(const std::string& key, const GraphValue& value) {
    root_->add(key, value.to_json());
    return *this;
}

GraphBuilder& GraphBuilder::set_json(const std::string& key, const std::string& text) {
    return set(key, GraphValue::json(text));
}

GraphBuilder& GraphBuilder::set_in(const std::string& section, const std::string& key,
                                   const GraphValue& value) {
    root_->section(section).add(key, value.to_json());
    return *this;
}

ParamBuilder GraphBuilder::param(const std::string& name, const GraphValue& default_value) {
    return ParamBuilder(root_->section("params").add_object(name)).set("default", default_value);
}

ResourceBuilder GraphBuilder::image(const std::string& name, const std::string& format) {
    return ResourceBuilder(root_->section("resources").add_object(name)).set("format", format);
}

ResourceBuilder GraphBuilder::buffer(const std::string& name, const std::string& type,
                                     const GraphValue& count) {
    return ResourceBuilder(root_->section("resources").add_object(name))
        .set("buffer", type)
        .set("count", count);
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
    return PassBuilder(root_->section("passes").add_object(name)).set("type", type);
}

EntryBuilder GraphBuilder::entry(const std::string& section, const std::string& name) {
    return EntryBuilder(root_->section(section).add_object(name));
}

std::string GraphBuilder::to_json() const {
    return graph_text(*root_);
}

}  // namespace weft
