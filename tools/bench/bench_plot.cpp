#include "tools/bench/bench_plot.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tools/words/number_text.h"

namespace isoloop {
namespace {

constexpr double width = 800;
constexpr double height = 440;
constexpr double left = 64;
constexpr double right = width - 180;
constexpr double top = 20;
constexpr double bottom = height - 44;
constexpr std::size_t color_count = 8;

constexpr const char* style =
    "<style>text{font:13px sans-serif;fill:#222}.grid{stroke:#8884;fill:none}"
    ".linear{stroke:#888;stroke-dasharray:5 4;fill:none}"
    ".curve{fill:none;stroke-width:2}.back{fill:#fff}"
    ".c0{stroke:#1f77b4}.c1{stroke:#d62728}.c2{stroke:#2a8f3a}.c3{stroke:#9467bd}"
    ".c4{stroke:#c27a00}.c5{stroke:#0a8f8f}.c6{stroke:#b5488f}.c7{stroke:#666}"
    "@media(prefers-color-scheme:dark){text{fill:#ddd}.back{fill:#16181c}"
    ".c0{stroke:#6bb5ee}.c1{stroke:#ff7b72}.c2{stroke:#6cc97a}.c3{stroke:#c9a6f0}"
    ".c4{stroke:#f0b34a}.c5{stroke:#4fd0d0}.c6{stroke:#e88fc8}.c7{stroke:#aaa}}</style>\n";

struct Point {
  double voxels = 0.0;
  double seconds = 0.0;
};

struct Series {
  std::string volume{};
  std::vector<Point> points{};
};

/// By volume, on the least number of threads; voxels ascending.
std::vector<Series> series_of(const BenchRun& run) {
  int threads = 0;
  for (const BenchRow& row : run.rows)
    threads = threads == 0 ? row.threads : std::min(threads, row.threads);
  std::vector<Series> all;
  for (const BenchRow& row : run.rows) {
    const double seconds = row.median.whole.cpu_seconds;
    if (!row.failure.empty() || row.threads != threads || seconds <= 0.0) continue;
    const auto place = std::find_if(all.begin(), all.end(),
                                    [&](const Series& one) { return one.volume == row.volume; });
    Series& series = place == all.end() ? all.emplace_back(Series{row.volume, {}}) : *place;
    series.points.push_back({static_cast<double>(voxels_of(row.median)), seconds});
  }
  for (Series& series : all)
    std::sort(series.points.begin(), series.points.end(),
              [](const Point& a, const Point& b) { return a.voxels < b.voxels; });
  return all;
}

/// From figures to places in the picture; whole powers of ten at the ends.
struct Axes {
  double first_x = 5.0;  // powers of ten, voxels
  double last_x = 6.0;
  double first_y = -1.0;  // powers of ten, seconds
  double last_y = 0.0;

  double x(double voxels) const {
    return left + (right - left) * (std::log10(voxels) - first_x) / (last_x - first_x);
  }
  double y(double seconds) const {
    return bottom - (bottom - top) * (std::log10(seconds) - first_y) / (last_y - first_y);
  }
};

Axes axes_of(const std::vector<Series>& all) {
  Axes axes;
  bool is_first = true;
  for (const Series& series : all) {
    for (const Point& point : series.points) {
      const double x = std::log10(point.voxels);
      const double y = std::log10(point.seconds);
      axes.first_x = is_first ? std::floor(x) : std::min(axes.first_x, std::floor(x));
      axes.last_x = is_first ? std::ceil(x) : std::max(axes.last_x, std::ceil(x));
      axes.first_y = is_first ? std::floor(y) : std::min(axes.first_y, std::floor(y));
      axes.last_y = is_first ? std::ceil(y) : std::max(axes.last_y, std::ceil(y));
      is_first = false;
    }
  }
  axes.last_x = std::max(axes.last_x, axes.first_x + 1.0);
  axes.last_y = std::max(axes.last_y, axes.first_y + 1.0);
  return axes;
}

std::string number(double value) { return fixed_text(value, 1); }

std::string place(const Axes& axes, const Point& point) {
  return number(axes.x(point.voxels)) + ' ' + number(axes.y(point.seconds));
}

void write_text(std::ostream& out, const char* anchor, double x, double y,
                const std::string& text) {
  out << "<text text-anchor=\"" << anchor << "\" x=\"" << number(x) << "\" y=\"" << number(y)
      << "\">";
  for (const char c : text) {
    if (c == '<')
      out << "&lt;";
    else if (c == '&')
      out << "&amp;";
    else
      out << c;
  }
  out << "</text>\n";
}

void write_axes(std::ostream& out, const Axes& axes) {
  for (double power = axes.first_x; power <= axes.last_x; ++power) {
    const double x = axes.x(std::pow(10.0, power));
    out << "<path class=\"grid\" d=\"M" << number(x) << ' ' << number(top) << 'V' << number(bottom)
        << "\"/>";
    write_text(out, "middle", x, bottom + 18, "10^" + fixed_text(power, 0));
  }
  for (double power = axes.first_y; power <= axes.last_y; ++power) {
    const double y = axes.y(std::pow(10.0, power));
    out << "<path class=\"grid\" d=\"M" << number(left) << ' ' << number(y) << 'H' << number(right)
        << "\"/>";
    write_text(out, "end", left - 6, y + 4, shortest_text(std::pow(10.0, power)) + " s");
  }
  write_text(out, "middle", (left + right) / 2, height - 6, "voxels");
}

// Through the first point of the first line, as far as the axes go.
void write_linear(std::ostream& out, const Axes& axes, const Point& from) {
  const double room_x = std::pow(10.0, axes.last_x) / from.voxels;
  const double room_y = std::pow(10.0, axes.last_y) / from.seconds;
  const double factor = std::min(room_x, room_y);
  const Point to{from.voxels * factor, from.seconds * factor};
  out << "<path class=\"linear\" d=\"M" << place(axes, from) << 'L' << place(axes, to) << "\"/>\n";
}

void write_series(std::ostream& out, const Axes& axes, const Series& series,
                  std::size_t number_of) {
  const std::string color = std::string("c").append(std::to_string(number_of % color_count));
  out << "<path class=\"curve " << color << "\" d=\"";
  for (std::size_t i = 0; i < series.points.size(); ++i)
    out << (i == 0 ? 'M' : 'L') << place(axes, series.points[i]);
  out << "\"/>";
  for (const Point& point : series.points)
    out << "<circle class=\"curve " << color << "\" cx=\"" << number(axes.x(point.voxels))
        << "\" cy=\"" << number(axes.y(point.seconds)) << "\" r=\"3\"/>";
  const double y = top + 10 + 20 * static_cast<double>(number_of);
  out << "\n<path class=\"curve " << color << "\" d=\"M" << number(right + 16) << ' ' << number(y)
      << "h20\"/>";
  write_text(out, "start", right + 42, y + 4, series.volume);
}

}  // namespace

void write_bench_svg(std::ostream& out, const BenchRun& run) {
  const std::vector<Series> all = series_of(run);
  const Axes axes = axes_of(all);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << number(width) << ' '
      << number(height) << "\" role=\"img\">\n<title>CPU seconds over voxels</title>\n"
      << style << "<rect class=\"back\" width=\"100%\" height=\"100%\"/>\n";
  write_axes(out, axes);
  if (!all.empty()) write_linear(out, axes, all.front().points.front());
  for (std::size_t i = 0; i < all.size(); ++i) write_series(out, axes, all[i], i);
  out << "</svg>\n";
}

}  // namespace isoloop
