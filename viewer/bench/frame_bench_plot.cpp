// Draws the plot of `weft bench frame`: the frame times over the number of lights, without the passes that
// all graphs have in common.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "viewer/bench/frame_bench.h"

namespace weft::viewer {
namespace {

constexpr double kWidth = 720, kHeight = 440, kLeft = 60, kRight = 160, kTop = 30, kBottom = 45;
// Colours of the curves, which colour-blind readers can distinguish. Source: Okabe and Ito 2008, "Color
// Universal Design".
constexpr std::array kColors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

std::string line(double x1, double y1, double x2, double y2) {
    return "<path class=\"grid\" d=\"M" + number(x1) + " " + number(y1) + "L" + number(x2) + " " +
           number(y2) + "\"/>\n";
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" + text +
           "</text>\n";
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return out;
}

// Converts a number of lights and a time in ms into a position in the picture.
class Axes {
 public:
    explicit Axes(const FrameBench& bench) : bench_(bench), least_ms_(1e30) {
        for (size_t light = 0; light < bench.lights.size(); ++light)
            for (size_t graph = 0; graph < bench.graphs.size(); ++graph) {
                least_ms_ = std::min(least_ms_, median(light, graph));
                most_ms_ = std::max(most_ms_, median(light, graph));
            }
        double step = 1e-4;
        while (next(step) <= least_ms_) step = next(step);
        least_ms_ = step;
        while (step < most_ms_) step = next(step);
        most_ms_ = step > least_ms_ ? step : next(step);
    }
    [[nodiscard]] double median(size_t light, size_t graph) const {
        return std::max(spread_of(bench_.at(light, graph).frame_ms(bench_.graphs.size() == 1)).median, 1e-4);
    }
    [[nodiscard]] double x(double lights) const {
        const double first = bench_.lights.front(), last = std::max<double>(bench_.lights.back(), first * 2);
        return kLeft + (kWidth - kLeft - kRight) * std::log(lights / first) / std::log(last / first);
    }
    [[nodiscard]] double y(double ms) const {
        return kHeight - kBottom -
               (kHeight - kTop - kBottom) * std::log(ms / least_ms_) / std::log(most_ms_ / least_ms_);
    }
    [[nodiscard]] std::string grid() const {
        std::string text;
        for (const uint32_t lights : bench_.lights)
            text += line(x(lights), kTop, x(lights), kHeight - kBottom) +
                    label(x(lights), kHeight - kBottom + 16, "middle", std::to_string(lights));
        for (double ms = least_ms_; ms <= most_ms_ * 1.001; ms = next(ms))
            text +=
                line(kLeft, y(ms), kWidth - kRight, y(ms)) + label(kLeft - 6, y(ms) + 4, "end", number(ms));
        return text + label((kLeft + kWidth - kRight) / 2, kHeight - 8, "middle", "lights") +
               label(kLeft, kTop - 10, "end", "ms");
    }

 private:
    // Returns the next larger mark of the axis after `step`. The marks are 1, 2 and 5, times powers of ten.
    static double next(double step) {
        const double first = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
        return step * (first > 1.5 && first < 3 ? 2.5 : 2);
    }
    const FrameBench& bench_;
    double least_ms_, most_ms_ = 0;
};

}  // namespace

std::string bench_svg(const FrameBench& bench) {
    const Axes axes(bench);
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(kWidth) + " " +
                      number(kHeight) +
                      "\" font-family=\"sans-serif\" font-size=\"12\">\n<style>.grid{stroke:#ccc;fill:none}"
                      ".curve{fill:none;stroke-width:2}</style>\n<path fill=\"#fff\" d=\"M0 0H" +
                      number(kWidth) + "V" + number(kHeight) + "H0Z\"/>\n" + axes.grid();
    for (size_t graph = 0; graph < bench.graphs.size(); ++graph) {
        const std::string color = kColors.at(graph % kColors.size());
        std::string path, dots;
        for (size_t light = 0; light < bench.lights.size(); ++light) {
            const std::string x = number(axes.x(bench.lights[light])),
                              y = number(axes.y(axes.median(light, graph)));
            path += (path.empty() ? "M" : "L") + x + " " + y;
            dots += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"3\" fill=\"" + color + "\"/>\n";
        }
        svg += "<path class=\"curve\" stroke=\"" + color + "\" d=\"" + path + "\"/>\n" + dots;
        const double key_y = kTop + 10 + 18 * static_cast<double>(graph);
        svg += "<circle cx=\"" + number(kWidth - kRight + 20) + "\" cy=\"" + number(key_y) +
               "\" r=\"4\" fill=\"" + color + "\"/>\n" +
               label(kWidth - kRight + 30, key_y + 4, "start", escaped(bench.graphs[graph]));
    }
    return svg + "</svg>\n";
}

}  // namespace weft::viewer
