#include "tools/reports/scan_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/scan/plateau.h"
#include "tools/words/number_text.h"

namespace isoloop {
namespace {

constexpr double width = 800;
constexpr double height = 360;
constexpr double left = 64;
constexpr double right = width - 16;
constexpr double top = 40;
constexpr double bottom = height - 44;

constexpr const char* style =
    "<style>text{font:13px sans-serif;fill:#222}.axis{stroke:#888;fill:none}"
    ".grid{stroke:#8884;fill:none}.plateau{fill:#8883}.proposed{stroke:#222;stroke-dasharray:5 4}"
    ".b0{stroke:#1f77b4}.b1{stroke:#d62728}.b2{stroke:#9467bd}"
    ".curve{fill:none;stroke-width:2}.back{fill:#fff}"
    "@media(prefers-color-scheme:dark){text{fill:#ddd}.back{fill:#16181c}.proposed{stroke:#ddd}"
    ".b0{stroke:#6bb5ee}.b1{stroke:#ff7b72}.b2{stroke:#c9a6f0}}</style>\n";

/// From values to places in the picture.
struct Axes {
  double first = 0.0;  // iso values
  double last = 1.0;
  double most = 1.0;  // count

  double x(double iso) const {
    return left + (right - left) * (last > first ? (iso - first) / (last - first) : 0.5);
  }
  double y(std::int64_t count) const {
    return bottom - (bottom - top) * std::log1p(static_cast<double>(count)) / std::log1p(most);
  }
};

std::string number(double value) { return fixed_text(value, 1); }

std::string place(const Axes& axes, double iso, std::int64_t count) {
  return number(axes.x(iso)) + ' ' + number(axes.y(count));
}

// A count holds from its own iso value to the next one.
void write_curve(std::ostream& out, const Scan& scan, const Axes& axes, const char* name,
                 std::int64_t Betti::*count) {
  out << "<path class=\"curve " << name << "\" d=\"";
  const std::vector<ScanRow>& rows = scan.rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::int64_t n = rows[i].betti.*count;
    if (i > 0 && rows[i - 1].betti.*count == n && i + 1 < rows.size()) continue;
    if (i == 0) {
      out << 'M' << place(axes, rows[i].iso, n);
    } else {
      out << 'L' << place(axes, rows[i].iso, rows[i - 1].betti.*count) << 'L'
          << place(axes, rows[i].iso, n);
    }
  }
  out << "\"/>\n";
}

// 1, 2 or 5 times a power of ten.
double round_step(double span, int ticks) {
  const double raw = span / ticks;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power) return factor * power;
  return 10 * power;
}

void write_axes(std::ostream& out, InsideRule inside, const Axes& axes) {
  std::int64_t before = -1;
  for (std::int64_t n = 0; static_cast<double>(n) <= axes.most; n = n == 0 ? 1 : 10 * n) {
    if (before >= 0 && axes.y(before) - axes.y(n) < 14) continue;
    before = n;
    out << "<path class=\"grid\" d=\"M" << number(left) << ' ' << number(axes.y(n)) << 'H'
        << number(right) << "\"/><text text-anchor=\"end\" x=\"" << number(left - 6) << "\" y=\""
        << number(axes.y(n) + 4) << "\">" << n << "</text>\n";
  }
  out << "<path class=\"axis\" d=\"M" << number(left) << ' ' << number(top) << 'V' << number(bottom)
      << 'H' << number(right) << "\"/>\n";
  const double span = axes.last - axes.first;
  if (span > 0) {
    const double step = round_step(span, 8);
    for (double tick = std::ceil(axes.first / step); tick * step <= axes.last; ++tick)
      out << "<path class=\"axis\" d=\"M" << number(axes.x(tick * step)) << ' ' << number(bottom)
          << "v5\"/><text text-anchor=\"middle\" x=\"" << number(axes.x(tick * step)) << "\" y=\""
          << number(bottom + 19) << "\">" << shortest_text(static_cast<float>(tick * step))
          << "</text>\n";
  }
  out << "<text text-anchor=\"middle\" x=\"" << number((left + right) / 2) << "\" y=\""
      << number(height - 6) << "\">iso value (inside is "
      << (inside == InsideRule::above ? "at or above" : "at or below") << ")</text>\n";
}

void write_legend(std::ostream& out) {
  const std::array<std::array<const char*, 2>, 3> names{
      {{"b0", "b0 components"}, {"b1", "b1 tunnels"}, {"b2", "b2 cavities"}}};
  double x = left + 8;
  for (const auto& [name, text] : names) {
    out << "<path class=\"curve " << name << "\" d=\"M" << number(x) << " 20h24\"/><text x=\""
        << number(x + 30) << "\" y=\"24\">" << text << "</text>\n";
    x += 150;
  }
}

}  // namespace

void write_scan_svg(std::ostream& out, const Scan& scan, InsideRule inside) {
  Axes axes{scan.rows.front().iso, scan.rows.back().iso, 1.0};
  for (const ScanRow& row : scan.rows)
    axes.most = std::max(axes.most,
                         static_cast<double>(std::max({row.betti.b0, row.betti.b1, row.betti.b2})));
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << number(width) << ' '
      << number(height) << "\" role=\"img\">\n<title>Components, tunnels and cavities over the iso "
      << "value</title>\n"
      << style << "<rect class=\"back\" width=\"100%\" height=\"100%\"/>\n";
  for (const std::size_t i : stablest_plateaus(scan.plateaus)) {
    const double from = axes.x(scan.rows[scan.plateaus[i].first].iso);
    const double to = axes.x(scan.rows[scan.plateaus[i].last].iso);
    out << "<rect class=\"plateau\" x=\"" << number(from) << "\" y=\"" << number(top)
        << "\" width=\"" << number(to - from) << "\" height=\"" << number(bottom - top) << "\"/>\n";
  }
  write_axes(out, inside, axes);
  write_legend(out);
  write_curve(out, scan, axes, "b0", &Betti::b0);
  write_curve(out, scan, axes, "b1", &Betti::b1);
  write_curve(out, scan, axes, "b2", &Betti::b2);
  if (scan.proposed) {
    const double iso = scan.rows[*scan.proposed].iso;
    out << "<path class=\"proposed\" d=\"M" << number(axes.x(iso)) << ' ' << number(top) << 'V'
        << number(bottom) << "\"/><text x=\"" << number(std::min(axes.x(iso) + 5, right - 90))
        << "\" y=\"" << number(top + 14) << "\">proposed " << shortest_text(iso) << "</text>\n";
  }
  out << "</svg>\n";
}

}  // namespace isoloop
