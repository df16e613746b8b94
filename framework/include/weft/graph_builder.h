// Purpose: makes a graph in C++ instead of in a file. The builder collects the keys of the graph in the order
// of the calls and writes them as the text of a graph file. It checks nothing: read_graph(), parse_graph()
// and load_graph() report the faults of this text, with its lines and columns. docs/format.md describes all
// keys. Example:
//   GraphBuilder graph("fog");
//   graph.import("opaque", "drawlist").import("backbuffer", "output");
//   graph.param("reach", 12).range(1, 100);
//   graph.image("depth", "d32f");
//   graph.raster("surfaces", "surface").draws({"opaque"}).depth("depth");
//   graph.fullscreen("show", "fog.frag").in("depth").out("color", "backbuffer");
// A call never replaces what an earlier call added. If a pass, a resource or a key is added twice, the error
// is W003, as in a file.
#pragma once

#include <concepts>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace weft {

struct JsonNode;

// A value of a key: a boolean, a number, a string, a list such as {1, "output.x"}, or a JSON value.
class GraphValue {
 public:
    template <std::same_as<bool> T>
    GraphValue(T value) : GraphValue(Unquoted{}, value ? "true" : "false") {}
    template <std::integral T>
    requires(!std::same_as<T, bool>) GraphValue(T value) : GraphValue(Unquoted{}, std::to_string(value)) {}
    GraphValue(double value);
    GraphValue(const char* text) : GraphValue(std::string(text)) {}
    GraphValue(std::string text);
    GraphValue(std::initializer_list<GraphValue> items);
    // A value that was read from a file.
    explicit GraphValue(JsonNode node);
    // Reads a value from JSON text, for example {"cull": "none"}. A text with a fault is added unchanged, so
    // that the error appears at its place when the graph is loaded.
    [[nodiscard]] static GraphValue json(const std::string& text);

    [[nodiscard]] const JsonNode& node() const { return *node_; }

 private:
    struct Unquoted {};
    // A text that is written without quotes.
    GraphValue(Unquoted unquoted, std::string text);

    std::shared_ptr<const JsonNode> node_;
};

// An object of the graph to which keys are added. It stays valid as long as its GraphBuilder, also if the
// builder is moved.
class GraphObject {
 public:
    void add(const std::string& key, const GraphValue& value);
    // Adds a key to the object that is the value of `section`. Makes the section if it does not exist yet.
    void add_to(const std::string& section, const std::string& key, const GraphValue& value);
    // Adds an empty object to a section, and returns the new object.
    GraphObject add_object(const std::string& section, const std::string& key);

 private:
    friend class GraphBuilder;
    explicit GraphObject(JsonNode& root) : root_(&root) {}
    // The members may move in memory when others are added, so the object is found again by its indices.
    [[nodiscard]] JsonNode& node() const;
    [[nodiscard]] size_t section_index(const std::string& section);

    JsonNode* root_;
    std::vector<size_t> path_;  // The indices of the members that lead from the root to this object.
};

// Adds the functions set() and set_json() to the class `Derived`.
template <class Derived>
class GraphKeys {
 public:
    explicit GraphKeys(GraphObject object) : object_(std::move(object)) {}
    // Adds any key of the format by its name.
    Derived& set(const std::string& key, GraphValue value) {
        object_.add(key, std::move(value));
        return self();
    }
    // Adds a key whose value is JSON text. See GraphValue::json().
    Derived& set_json(const std::string& key, const std::string& text) {
        return set(key, GraphValue::json(text));
    }

    // Adds an entry to a section of this object: set_in("debug", "Depth", "depth").
    Derived& set_in(const std::string& section, const std::string& key, GraphValue value) {
        object_.add_to(section, key, std::move(value));
        return self();
    }

 protected:
    GraphObject object_;

 private:
    Derived& self() { return static_cast<Derived&>(*this); }
};

// An entry of a section that has no class of its own, such as a list of views, a group or a tier.
class EntryBuilder : public GraphKeys<EntryBuilder> {
 public:
    using GraphKeys::GraphKeys;
};

class ParamBuilder : public GraphKeys<ParamBuilder> {
 public:
    using GraphKeys::GraphKeys;
    ParamBuilder& range(GraphValue least, GraphValue most) {
        return set("range", {std::move(least), std::move(most)});
    }
};

// An image or a buffer.
class ResourceBuilder : public GraphKeys<ResourceBuilder> {
 public:
    using GraphKeys::GraphKeys;
    ResourceBuilder& size(GraphValue side) { return set("size", std::move(side)); }
    ResourceBuilder& size(GraphValue width, GraphValue height) {
        return set("size", {std::move(width), std::move(height)});
    }
    ResourceBuilder& mips(GraphValue count) { return set("mips", std::move(count)); }
    ResourceBuilder& layers(GraphValue count) { return set("layers", std::move(count)); }
    ResourceBuilder& history(uint32_t frames) { return set("history", frames); }
    ResourceBuilder& keep() { return set("keep", true); }
};

// A pass of any type. The loader reports keys that do not fit the type.
class PassBuilder : public GraphKeys<PassBuilder> {
 public:
    using GraphKeys::GraphKeys;
    PassBuilder& in(const std::string& port, GraphValue reference) {
        return set_in("in", port, std::move(reference));
    }
    PassBuilder& in(const std::string& name) { return in(name, name); }  // The port has the resource's name.
    PassBuilder& out(const std::string& port, GraphValue reference) {
        return set_in("out", port, std::move(reference));
    }
    PassBuilder& out(const std::string& name) { return out(name, name); }
    PassBuilder& depth(GraphValue reference) { return set("depth", std::move(reference)); }
    PassBuilder& draws(std::initializer_list<GraphValue> lists) { return set("draws", lists); }
    PassBuilder& view(const std::string& reference) { return set("view", reference); }
    PassBuilder& views(const std::string& list, const std::string& into) {
        return set("views", list).set("into", into);
    }
    PassBuilder& param(const std::string& name, GraphValue value) {
        return set_in("params", name, std::move(value));
    }
    PassBuilder& constant(const std::string& name, GraphValue value) {
        return set_in("constants", name, std::move(value));
    }
    // Number of shader invocations.
    PassBuilder& threads(GraphValue x, GraphValue y = 1, GraphValue z = 1) {
        return set("threads", {std::move(x), std::move(y), std::move(z)});
    }
    // Number of workgroups.
    PassBuilder& groups(GraphValue x, GraphValue y = 1, GraphValue z = 1) {
        return set("groups", {std::move(x), std::move(y), std::move(z)});
    }
    PassBuilder& clear(GraphValue color) { return set("clear", std::move(color)); }
    PassBuilder& after(std::initializer_list<GraphValue> passes) { return set("after", passes); }
    PassBuilder& repeat(const std::string& index, const std::string& range) {
        return set_in("repeat", index, range);
    }
};

class GraphBuilder : public GraphKeys<GraphBuilder> {
 public:
    explicit GraphBuilder(std::string name);
    GraphBuilder(GraphBuilder&&) = default;
    GraphBuilder& operator=(GraphBuilder&&) = default;

    GraphBuilder& include(const std::string& file);
    GraphBuilder& import(const std::string& name, const std::string& kind) {
        return set_in("imports", name, kind);
    }
    GraphBuilder& constant(const std::string& name, GraphValue value) {
        return set_in("consts", name, std::move(value));
    }
    GraphBuilder& size(const std::string& name, GraphValue value) {
        return set_in("sizes", name, std::move(value));
    }
    ParamBuilder param(const std::string& name, GraphValue default_value);
    // `format` may contain alternatives: "rg16_snorm|rg16f".
    ResourceBuilder image(const std::string& name, const std::string& format);
    // `type` is the type of the elements, such as "u32".
    ResourceBuilder buffer(const std::string& name, const std::string& type, GraphValue count);
    PassBuilder compute(const std::string& name, const std::string& shader);
    PassBuilder fullscreen(const std::string& name, const std::string& shader);
    PassBuilder raster(const std::string& name, const std::string& shader);
    // A pass of another type, such as "copy" or the name of a C++ pass.
    PassBuilder pass(const std::string& name, const std::string& type);
    // An entry of any section: entry("views", "mirror").
    EntryBuilder entry(const std::string& section, const std::string& name);

    // Returns the text of the graph file.
    [[nodiscard]] std::string to_json() const;
    // Returns a name for the graph in messages, such as "fog (made in C++)". Use it as the name of the file
    // in MemoryFiles.
    [[nodiscard]] std::string file_name() const { return name_ + " (made in C++)"; }

 private:
    GraphBuilder(std::string name, std::shared_ptr<JsonNode> root);

    std::string name_;
    std::shared_ptr<JsonNode> root_;
};

}  // namespace weft
