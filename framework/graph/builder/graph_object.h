// Purpose: the objects that a GraphBuilder collects, as a tree that the builder owns.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace weft {

struct GraphMember;

// The keys of an object in the order in which they were added.
struct GraphObject {
    std::vector<GraphMember> members;

    void add(const std::string& key, const std::string& json);
    // Adds an empty object and returns it. Its address does not change when other members are added.
    GraphObject& add_object(const std::string& key);
    // Returns the object that is the value of `key`. Adds it if there is none.
    GraphObject& section(const std::string& key);
};

struct GraphMember {
    std::string key;
    std::string json;                     // The text of the value.
    std::unique_ptr<GraphObject> object;  // The value, if it is an object that can get keys; otherwise null.
};

// Writes each key of the graph, of its sections, and of the entries of sections on a line of its own, so that
// the line of an error shows the faulty key. Deeper values are on one line.
[[nodiscard]] std::string graph_text(const GraphObject& root);

}  // namespace weft
