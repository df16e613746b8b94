// Changes the text of shipped graphs as a typing mistake would: misspelt keys, swapped values, removed
// passes, numbers out of range, missing braces and quotes, swapped names, duplicated lines. Each seed gives
// one mutant.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "weft/source.h"

namespace weft::test {

struct Mutant {
    uint32_t seed = 0;
    std::string root;  // the graph to load, relative to the source folder: "graphs/taa.json"
    std::string file;  // the changed file: the graph, or an included file
    std::string text;  // text of `file`
    std::string how;   // description of the change
};

class GraphMutants {
 public:
    GraphMutants();

    [[nodiscard]] Mutant make(uint32_t seed) const;
    // Returns the mutant's text instead of its file; other files are unchanged.
    [[nodiscard]] static FileReader reader_of(const Mutant& mutant);
    [[nodiscard]] static std::string path_of(const std::string& file);
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

 private:
    std::vector<std::string> files_;            // files of all shipped graphs
    std::map<std::string, std::string> texts_;  // index: file
    std::vector<std::string> values_;           // strings that occur in these files, with their quotes
};

}  // namespace weft::test
