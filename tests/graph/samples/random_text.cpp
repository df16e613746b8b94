#include "tests/graph/samples/random_text.h"

#include "tests/graph/samples/random_text_faults.h"

namespace weft::test {
namespace {

class TextGenerator : public RandomTextFaults {
 public:
    using RandomTextFaults::RandomTextFaults;

    RandomText run() {
        make();
        shuffle();
        return {text_of(model_, false), text_of(model_, true), params_, omitted_};
    }

    FaultyText run_with_fault() {
        make();
        const RandomFault fault = plant();
        shuffle();
        return {text_of(model_, false), params_, fault.code, fault.how};
    }

 private:
    void make() {
        add_parameters();
        fill();
        const uint32_t pieces = between(4, 16);
        if (chance(65)) remember();
        for (uint32_t i = 0; i < pieces; ++i) add_piece();
        fold();
        if (chance(40)) present();
        add_after();
    }

    void add_piece() {
        using Piece = void (TextGenerator::*)();
        struct Share {
            uint32_t weight;
            Piece piece;
        };
        constexpr Share kPieces[] = {
            {12, &TextGenerator::mix},           {8, &TextGenerator::draw},
            {9, &TextGenerator::update},         {6, &TextGenerator::blend},
            {4, &TextGenerator::overwrite},      {6, &TextGenerator::alternatives},
            {5, &TextGenerator::scene},          {4, &TextGenerator::wipe},
            {4, &TextGenerator::copy},           {3, &TextGenerator::stretch},
            {6, &TextGenerator::buffers},        {1, &TextGenerator::read_back},
            {6, &TextGenerator::pyramid},        {3, &TextGenerator::rounds},
            {3, &TextGenerator::bounce},         {3, &TextGenerator::staircase},
            {2, &TextGenerator::remember},       {2, &TextGenerator::recall},
            {6, &TextGenerator::keep},           {4, &TextGenerator::frame_slices},
            {3, &TextGenerator::overwrite_part}, {2, &TextGenerator::views},
            {6, &TextGenerator::view_list},      {4, &TextGenerator::buffer_views},
            {4, &TextGenerator::arrays},         {5, &TextGenerator::indirect},
            {3, &TextGenerator::scene_buffer},   {4, &TextGenerator::file},
        };
        uint32_t total = 0;
        for (const Share& share : kPieces) total += share.weight;
        uint32_t roll = below(total);
        for (const Share& share : kPieces) {
            if (roll < share.weight) return (this->*share.piece)();
            roll -= share.weight;
        }
    }

    // Takes most of the colour images that no pass has read so far (at most 24), and combines them into the
    // final result. The other unread images stay unused, so that their passes are culled.
    void fold() {
        std::vector<size_t> loose = values_that(
            [&](size_t v) { return kind_of(v) == ValueKind::color && !model_.values[v].read && chance(75); });
        size_t result = plain_color();
        loose.push_back(result);
        for (size_t i = 0; i < loose.size() && i < 24; i += 2) {
            add_pass("fold", "compute", "mix_3.comp");
            const size_t two = i + 1 < loose.size() ? loose[i + 1] : loose.front();
            TextPort a = input("a", result, kNone, false), b = input("b", loose[i], kNone, true),
                     c = input("c", two, kNone, true);
            model_.passes.back().in = {std::move(a), std::move(b), std::move(c)};
            result = add_value(new_image("fold"));
            write("dst", result);
        }
        result_ = result;
        add_pass("result", "readback", nullptr).in = {{"src", last_version(result), {}, false, {}}};
    }

    void present() {
        add_pass("present", "fullscreen", "draw_1.frag");
        TextPort a = input("a", result_, kNone, false);
        model_.passes.back().in = {std::move(a)};
        model_.passes.back().out = {said("color", "backbuffer")};
    }

    void add_after() {
        const auto count = static_cast<uint32_t>(model_.passes.size());
        for (uint32_t i = below(4); i > 0; --i) {
            const uint32_t to = 1 + below(count - 1), from = below(to);
            std::vector<size_t>& after = model_.passes[to].after;
            if (std::find(after.begin(), after.end(), from) == after.end()) after.push_back(from);
        }
    }

    void shuffle() {
        for (size_t i = 0; i < model_.passes.size(); ++i) model_.shuffled.push_back(i);
        for (size_t i = model_.shuffled.size(); i > 1; --i)
            std::swap(model_.shuffled[i - 1], model_.shuffled[below(static_cast<uint32_t>(i))]);
    }

    size_t result_ = kNone;
};

}  // namespace

RandomText random_text(uint32_t seed, const DeviceProfile& profile) {
    return TextGenerator(seed, profile).run();
}

FaultyText random_faulty_text(uint32_t seed, const DeviceProfile& profile) {
    return TextGenerator(seed, profile).run_with_fault();
}

}  // namespace weft::test
