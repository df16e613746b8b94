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
// A call never replaces the key of an earlier call. If a pass, a resource or a key is added twice, the error
// is W003, as in a file.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace weft {

struct GraphObject;

// A value of a key: a boolean, a number, a string, a list such as {1, "output.x"}, or JSON text.
class GraphValue {
 public:
    template <std::same_as<bool> T>
    GraphValue(T value) : json_(value ? "true" : "false") {}
    template <std::integral T>
    requires(!std::same_as<T, bool>) GraphValue(T value) : json_(std::to_string(value)) {}
    GraphValue(double value);
    GraphValue(const char* text) : GraphValue(std::string(text)) {}
    GraphValue(const std::string& text);
    GraphValue(std::initializer_list<GraphValue> items) : GraphValue(std::vector<GraphValue>(items)) {}
    GraphValue(const std::vector<GraphValue>& items);
    // Makes a value from JSON text, for example {"cull": "none"}. A text with a fault is added unchanged, so
    // that the error names the place of the fault when the graph is loaded.
    [[nodiscard]] static GraphValue json(const std::string& text);

    // Returns the value as JSON text on one line.
    [[nodiscard]] const std::string& to_json() const { return json_; }

 private:
    std::string json_;
};

// An object of the graph, such as a pass, to which keys are added. The GraphBuilder owns the object. This
// class has only a pointer to the object, so copies of this class add keys to the same object. The pointer
// stays valid if the builder is moved, until the builder is destroyed. `Derived` is the class that the
// functions return.
template <class Derived>
class GraphKeys {
 public:
    explicit GraphKeys(GraphObject& object) : object_(&object) {}
    // Adds any key of the format by its name.
    Derived set(const std::string& key, const GraphValue& value) const;
    // Adds a key whose value is JSON text. See GraphValue::json().
    Derived set_json(const std::string& key, const std::string& text) const {
        return set(key, GraphValue::json(text));
    }
    // Adds a key to an object that is the value of `section`: set_in("state", "cull", "none").
    Derived set_in(const std::string& section, const std::string& key, const GraphValue& value) const;

 private:
    GraphObject* object_;
};

// An entry of a section that has no class of its own, such as a list of views, a group or a tier.
class EntryBuilder : public GraphKeys<EntryBuilder> {
 public:
    using GraphKeys::GraphKeys;
};

class ParamBuilder : public GraphKeys<ParamBuilder> {
 public:
    using GraphKeys::GraphKeys;
    ParamBuilder range(const GraphValue& least, const GraphValue& most) const {
        return set("range", {least, most});
    }
};

// An image or a buffer.
class ResourceBuilder : public GraphKeys<ResourceBuilder> {
 public:
    using GraphKeys::GraphKeys;
    ResourceBuilder size(const GraphValue& side) const { return set("size", side); }
    ResourceBuilder size(const GraphValue& width, const GraphValue& height) const {
        return set("size", {width, height});
    }
    ResourceBuilder mips(const GraphValue& count) const { return set("mips", count); }
    ResourceBuilder layers(const GraphValue& count) const { return set("layers", count); }
    ResourceBuilder history(uint32_t frames) const { return set("history", frames); }
    ResourceBuilder keep() const { return set("keep", true); }
};

// A pass of any type. The loader reports keys that do not fit the type.
class PassBuilder : public GraphKeys<PassBuilder> {
 public:
    using GraphKeys::GraphKeys;
    PassBuilder in(const std::string& port, const GraphValue& reference) const {
        return set_in("in", port, reference);
    }
    // The port has the name of the resource.
    PassBuilder in(const std::string& name) const { return in(name, name); }
    PassBuilder out(const std::string& port, const GraphValue& reference) const {
        return set_in("out", port, reference);
    }
    PassBuilder out(const std::string& name) const { return out(name, name); }
    PassBuilder depth(const GraphValue& reference) const { return set("depth", reference); }
    PassBuilder draws(const std::vector<GraphValue>& lists) const { return set("draws", lists); }
    PassBuilder view(const std::string& reference) const { return set("view", reference); }
    PassBuilder views(const std::string& list, const std::string& into) const {
        return set("views", list).set("into", into);
    }
    PassBuilder param(const std::string& name, const GraphValue& value) const {
        return set_in("params", name, value);
    }
    PassBuilder constant(const std::string& name, const GraphValue& value) const {
        return set_in("constants", name, value);
    }
    // Number of shader invocations.
    PassBuilder threads(const GraphValue& x, const GraphValue& y = 1, const GraphValue& z = 1) const {
        return set("threads", {x, y, z});
    }
    // Number of workgroups.
    PassBuilder groups(const GraphValue& x, const GraphValue& y = 1, const GraphValue& z = 1) const {
        return set("groups", {x, y, z});
    }
    PassBuilder clear(const GraphValue& color) const { return set("clear", color); }
    PassBuilder after(const std::vector<GraphValue>& passes) const { return set("after", passes); }
    PassBuilder repeat(const std::string& index, const std::string& range) const {
        return set_in("repeat", index, range);
    }
};

class GraphBuilder {
 public:
    explicit GraphBuilder(const std::string& name);
    ~GraphBuilder();
    GraphBuilder(GraphBuilder&&) noexcept;
    GraphBuilder& operator=(GraphBuilder&&) noexcept;

    // These three functions are as in GraphKeys: set_in("debug", "Depth", "depth").
    GraphBuilder& set(const std::string& key, const GraphValue& value);
    GraphBuilder& set_json(const std::string& key, const std::string& text);
    GraphBuilder& set_in(const std::string& section, const std::string& key, const GraphValue& value);

    GraphBuilder& include(const std::vector<GraphValue>& files) { return set("include", files); }
    GraphBuilder& import(const std::string& name, const std::string& kind) {
        return set_in("imports", name, kind);
    }
    GraphBuilder& constant(const std::string& name, const GraphValue& value) {
        return set_in("consts", name, value);
    }
    GraphBuilder& size(const std::string& name, const GraphValue& value) {
        return set_in("sizes", name, value);
    }
    ParamBuilder param(const std::string& name, const GraphValue& default_value);
    // `format` may contain alternatives: "rg16_snorm|rg16f".
    ResourceBuilder image(const std::string& name, const std::string& format);
    // `type` is the type of the elements, such as "u32".
    ResourceBuilder buffer(const std::string& name, const std::string& type, const GraphValue& count);
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
    std::string name_;
    // A pointer, so that the address of the object stays the same if the builder is moved.
    std::unique_ptr<GraphObject> root_;
};

}  // namespace weft
