// Tests the names that did_you_mean() suggests, by comparing with a search that computes every distance in
// full.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "weft/result.h"

namespace weft {
namespace {

// Returns the optimal string alignment distance. Fills the whole table of distances; did_you_mean() fills
// only a part of its table.
size_t full_distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<size_t>> table(a.size() + 1, std::vector<size_t>(b.size() + 1));
    for (size_t i = 0; i <= a.size(); ++i) {
        for (size_t j = 0; j <= b.size(); ++j) {
            size_t& least = table[i][j];
            least = i == 0 ? j : j == 0 ? i : table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            if (i > 0 && j > 0) least = std::min({least, table[i - 1][j] + 1, table[i][j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                least = std::min(least, table[i - 2][j - 2] + 1);
        }
    }
    return table[a.size()][b.size()];
}

std::vector<std::string> nearest_names(const std::string& name, const std::vector<std::string>& known) {
    std::vector<std::pair<size_t, std::string>> near;
    for (const std::string& candidate : known) {
        const size_t distance = full_distance(name, candidate);
        if (name.size() >= 3 && candidate.find(name) != std::string::npos)
            near.emplace_back(std::min(distance, candidate.size() - name.size()), candidate);
        else if (distance <= std::max<size_t>(1, name.size() / 3))
            near.emplace_back(distance, candidate);
    }
    std::ranges::sort(near);
    std::vector<std::string> names;
    for (size_t i = 0; i < std::min<size_t>(3, near.size()); ++i) names.push_back(near[i].second);
    return names;
}

// Makes a name of the letters a, b and c. So few letters give many similar names.
std::string random_name(std::mt19937& random, size_t most_bytes) {
    std::string name(1 + random() % most_bytes, 'a');
    for (char& c : name) c = static_cast<char>('a' + random() % 3);
    return name;
}

TEST(DidYouMean, SuggestsTheNearestNames) {
    size_t suggestions = 0;
    for (uint32_t seed = 1; seed <= 400; ++seed) {
        std::mt19937 random(seed);
        const size_t most_bytes = 1 + seed % 64;
        std::vector<std::string> known(1 + random() % 40);
        const std::string base = random_name(random, most_bytes);
        for (std::string& name : known) {
            name = random() % 2 == 0 ? random_name(random, most_bytes) : base;
            for (size_t n = random() % 5; n > 0; --n) name.insert(random() % (name.size() + 1), 1, 'b');
        }
        std::string wanted = seed % 5 == 0 ? random_name(random, most_bytes) : base;
        wanted[random() % wanted.size()] = 'd';
        if (wanted.size() > 2 && seed % 3 == 0) std::swap(wanted[0], wanted[1]);
        const std::vector<std::string> names = did_you_mean(wanted, known);
        EXPECT_EQ(names, nearest_names(wanted, known)) << "seed " << seed << ", name " << wanted;
        suggestions += names.size();
    }
    EXPECT_GT(suggestions, 400u) << "the names are too different to prove anything";
}

TEST(DidYouMean, SuggestsTheNearestOfManyNames) {
    std::vector<std::string> known;
    for (int i = 0; i < 5000; ++i) known.push_back("shadow_map_of_light_" + std::to_string(i));
    EXPECT_EQ(did_you_mean("shadow_mpa_of_light_4321", known),
              (std::vector<std::string>{"shadow_map_of_light_4321", "shadow_map_of_light_1321",
                                        "shadow_map_of_light_2321"}));
}

TEST(DidYouMean, SuggestsNothingForVeryLongNames) {
    EXPECT_EQ(did_you_mean(std::string(65, 'a'), {std::string(65, 'a')}), std::vector<std::string>());
    EXPECT_EQ(did_you_mean(std::string(64, 'a'), {std::string(129, 'a')}), std::vector<std::string>());
    EXPECT_EQ(did_you_mean(std::string(64, 'a'), {std::string(128, 'a')}).size(), 1u);
}

}  // namespace
}  // namespace weft
