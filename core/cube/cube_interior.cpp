#include "core/cube/cube_interior.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

namespace isoloop {
namespace {

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

/// A double and a bound on its distance from the exact value; of magnitude at most about 1.
struct Rounded {
  static constexpr double unit = std::numeric_limits<double>::epsilon();
  static constexpr double underflow = 1e-300;

  double value = 0.0;
  double error = 0.0;
};

Rounded operator+(const Rounded& a, const Rounded& b) {
  const double sum = a.value + b.value;
  return {sum, a.error + b.error + Rounded::unit * std::abs(sum)};
}

Rounded operator-(const Rounded& a, const Rounded& b) { return a + Rounded{-b.value, b.error}; }

Rounded operator*(const Rounded& a, const Rounded& b) {
  const double product = a.value * b.value;
  return {product, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error +
                       Rounded::unit * std::abs(product) + Rounded::underflow};
}

/// The discriminant's degree in the levels: no polynomial here has a higher one.
constexpr std::size_t most_factors = 4;

/// By how much a level of 0 is raised, as a power of what the others are lowered by. More than
/// most_factors, or raising one level would weigh as much as lowering several does.
constexpr std::size_t zero_power = most_factors + 1;

/// A sum of by_power[k] e^k with an infinitesimal e > 0.
struct Infinitesimal {
  std::array<Integer, most_factors * zero_power + 1> by_power{};

  int sign() const {
    for (const Integer& factor : by_power)
      if (factor.sign() != 0) return factor.sign();
    return 0;
  }
};

Infinitesimal operator+(Infinitesimal a, const Infinitesimal& b) {
  for (std::size_t k = 0; k < a.by_power.size(); ++k) a.by_power[k] += b.by_power[k];
  return a;
}

Infinitesimal operator-(Infinitesimal a, const Infinitesimal& b) {
  for (std::size_t k = 0; k < a.by_power.size(); ++k) a.by_power[k] -= b.by_power[k];
  return a;
}

Infinitesimal operator*(const Infinitesimal& a, const Infinitesimal& b) {
  Infinitesimal product;
  for (std::size_t i = 0; i < a.by_power.size(); ++i) {
    if (a.by_power[i].is_zero()) continue;
    for (std::size_t k = 0; i + k < a.by_power.size(); ++k)
      if (!b.by_power[k].is_zero()) product.by_power[i + k] += a.by_power[i] * b.by_power[k];
  }
  return product;
}

/// The levels times a power of two that brings the largest to about 1.
std::array<Rounded, 8> scaled_levels(const CornerLevels& levels) {
  double largest = 0.0;
  for (const double level : levels) largest = std::max(largest, std::abs(level));
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::array<Rounded, 8> scaled;
  for (int c = 0; c < 8; ++c) scaled[c] = {std::ldexp(levels[c], -exponent), Rounded::underflow};
  return scaled;
}

/// The levels times a power of two that makes them whole.
std::array<Integer, 8> whole_levels(const CornerLevels& levels) {
  constexpr int digits = std::numeric_limits<double>::digits;
  std::array<int, 8> exponent{};
  std::array<double, 8> mantissa{};
  int least = std::numeric_limits<int>::max();
  for (int c = 0; c < 8; ++c) {
    mantissa[c] = std::ldexp(std::frexp(levels[c], &exponent[c]), digits);
    if (levels[c] != 0.0) least = std::min(least, exponent[c]);
  }
  std::array<Integer, 8> whole;
  for (int c = 0; c < 8; ++c)
    if (levels[c] != 0.0)
      whole[c] = Integer(static_cast<std::int64_t>(mantissa[c])) << (exponent[c] - least);
  return whole;
}

/// The levels as the rule for ties has them: all but those that are 0 lowered by next to nothing,
/// and those that are 0 raised by next to nothing of that.
std::array<Infinitesimal, 8> moved_levels(const CornerLevels& levels) {
  const std::array<Integer, 8> exact = whole_levels(levels);
  std::array<Infinitesimal, 8> moved;
  for (int c = 0; c < 8; ++c) {
    const bool is_zero = levels[c] == 0.0;
    moved[c].by_power[0] = exact[c];
    moved[c].by_power[is_zero ? zero_power : 1] = is_zero ? 1 : -1;
  }
  return moved;
}

/// Sign of polynomial(levels), exact: by integers where doubles cannot tell. Where it is 0, that
/// at moved_levels(). The polynomial must be homogeneous, of degree most_factors at most.
template <class Polynomial>
int sign_of(const CornerLevels& levels, const Polynomial& polynomial) {
  const Rounded value = polynomial(scaled_levels(levels));
  if (std::abs(value.value) > 2 * value.error) return value.value > 0 ? 1 : -1;
  const int sign = Integer(polynomial(whole_levels(levels))).sign();
  return sign != 0 ? sign : polynomial(moved_levels(levels)).sign();
}

/// Corners of the four edges along `axis` in ring order, at their lower ends.
std::array<int, 4> edge_ring(int axis) {
  const auto [b, c] = cross_axes(axis);
  return {0, 1 << b, 1 << b | 1 << c, 1 << c};
}

/// q in the form first (1 - t)^2 + middle t (1 - t) + last t^2.
template <class Number>
struct Quadratic {
  Number first;
  Number middle;
  Number last;
};

template <class Number>
Quadratic<Number> saddle_quadratic(const std::array<Number, 8>& f, int axis) {
  const auto [a, b, c, d] = edge_ring(axis);
  const int up = 1 << axis;
  return {f[a] * f[c] - f[b] * f[d],
          f[a] * f[c | up] + f[a | up] * f[c] - f[b] * f[d | up] - f[b | up] * f[d],
          f[a | up] * f[c | up] - f[b | up] * f[d | up]};
}

/// Sign of q at an end of the axis: on an ambiguous face as the face was decided.
int sign_on_face(const CornerLevels& levels, int axis, bool upper) {
  std::array<double, 4> ring{};
  unsigned inside = 0;
  for (unsigned i = 0; i < 4; ++i) {
    ring[i] = levels[edge_ring(axis)[i] | (upper ? 1 << axis : 0)];
    inside |= (ring[i] >= 0 ? 1U : 0U) << i;
  }
  if (is_ambiguous(inside)) return inside_is_joined(ring) == (ring[0] >= 0) ? 1 : -1;
  return sign_of(levels, [&](const auto& f) {
    const auto q = saddle_quadratic(f, axis);
    return upper ? q.last : q.first;
  });
}

/// Of the sides, the one whose two edges along the axis q's sign joins midway between its roots;
/// none where the interpolant vanishes there altogether.
std::optional<Side> joined_side(const CornerLevels& levels, int axis, int end_sign) {
  const int edge = edge_ring(axis)[end_sign < 0 ? 0 : 1];
  const int up = 1 << axis;
  const int sign = sign_of(levels, [&](const auto& f) {
    const auto q = saddle_quadratic(f, axis);
    return f[edge] * (q.last + q.last - q.middle) + f[edge | up] * (q.first + q.first - q.middle);
  });
  if (sign == 0) return std::nullopt;
  return sign == end_sign ? Side::inside : Side::outside;
}

/// Whole numbers as doubles of magnitude 1 or less, all times the same power of two.
Quadratic<double> scaled_down(const Quadratic<Integer>& q) {
  unsigned bits = 0;
  for (const Integer& number : {q.first, q.middle, q.last})
    if (!number.is_zero()) bits = std::max(bits, static_cast<unsigned>(msb(abs(number))) + 1);
  constexpr unsigned kept = std::numeric_limits<double>::digits;
  const unsigned dropped = bits > kept ? bits - kept : 0;
  const auto scaled = [&](const Integer& number) {
    const double magnitude = Integer(abs(number) >> dropped).convert_to<double>();
    return std::ldexp(number.sign() < 0 ? -magnitude : magnitude,
                      static_cast<int>(dropped) - static_cast<int>(bits));
  };
  return {scaled(q.first), scaled(q.middle), scaled(q.last)};
}

/// q times a positive number, as the levels move to where they are: where q vanishes altogether,
/// what it is like next to nothing before.
Quadratic<double> limit_quadratic(const CornerLevels& levels, int axis) {
  constexpr double clearly = 1e6;
  const auto rounded = saddle_quadratic(scaled_levels(levels), axis);
  for (const Rounded& factor : {rounded.first, rounded.middle, rounded.last})
    if (std::abs(factor.value) > clearly * factor.error)
      return {rounded.first.value, rounded.middle.value, rounded.last.value};
  const auto q = saddle_quadratic(moved_levels(levels), axis);
  std::size_t power = 0;
  const auto vanishes_at = [&](std::size_t k) {
    return q.first.by_power[k].is_zero() && q.middle.by_power[k].is_zero() &&
           q.last.by_power[k].is_zero();
  };
  while (power + 1 < q.first.by_power.size() && vanishes_at(power)) ++power;
  return scaled_down({q.first.by_power[power], q.middle.by_power[power], q.last.by_power[power]});
}

/// The roots of q, ascending, as shares of the cube's edge along the axis.
std::array<double, 2> roots_of(const Quadratic<double>& q) {
  const double first = std::abs(q.first);
  const double last = std::abs(q.last);
  const double reach =
      std::abs(q.middle) + std::sqrt(std::max(0.0, q.middle * q.middle - 4 * q.first * q.last));
  if (reach == 0.0) {  // a double root, at an end unless q vanishes altogether
    const double root = first > last ? 1.0 : last > first ? 0.0 : 0.5;
    return {root, root};
  }
  return {2 * first / (2 * first + reach), reach / (2 * last + reach)};
}

/// Along each axis the roots of q, ascending, as shares of the cube's edge.
std::array<std::array<double, 2>, 3> tunnel_roots(const CornerLevels& levels) {
  std::array<std::array<double, 2>, 3> roots{};
  for (int axis = 0; axis < 3; ++axis) roots[axis] = roots_of(limit_quadratic(levels, axis));
  return roots;
}

/// That corner of the box between the roots which lies towards a corner of the cube.
Vec3 box_corner(const std::array<std::array<double, 2>, 3>& roots, int corner) {
  return {roots[0][corner & 1], roots[1][corner >> 1 & 1], roots[2][corner >> 2 & 1]};
}

/// The interpolant's value, in units of about the largest level.
double interpolate(const CornerLevels& levels, const Vec3& point) {
  const std::array<Rounded, 8> scaled = scaled_levels(levels);
  double sum = 0.0;
  for (int c = 0; c < 8; ++c) {
    double weight = 1.0;
    for (int a = 0; a < 3; ++a) weight *= (c >> a & 1) != 0 ? point[a] : 1 - point[a];
    sum += weight * scaled[c].value;
  }
  return sum;
}

}  // namespace

std::optional<Side> interior_tunnel(const CornerLevels& levels) {
  std::array<int, 3> end_sign{};
  for (int axis = 0; axis < 3; ++axis) {
    end_sign[axis] = sign_on_face(levels, axis, false);
    if (end_sign[axis] == 0 || sign_on_face(levels, axis, true) != end_sign[axis])
      return std::nullopt;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int middle =
        sign_of(levels, [&](const auto& f) { return saddle_quadratic(f, axis).middle; });
    if (middle != -end_sign[axis]) return std::nullopt;
  }
  const int discriminant = sign_of(levels, [](const auto& f) {
    const auto q = saddle_quadratic(f, 0);
    const auto product = q.first * q.last;
    const auto twice = product + product;
    return q.middle * q.middle - (twice + twice);
  });
  if (discriminant < 0) return std::nullopt;
  const std::optional<Side> side = joined_side(levels, 0, end_sign[0]);
  return discriminant == 0 && side == Side::inside ? std::nullopt : side;
}

std::optional<int> tunnel_hub(const CubeCut& cut, const CornerLevels& levels) {
  if (cut.hubs.count == 0) return std::nullopt;
  const std::optional<Side> side = interior_tunnel(levels);
  if (!side) return std::nullopt;
  std::optional<int> found;
  double largest = -1.0;
  for (const int hub : cut.hubs) {
    if ((levels[hub] >= 0) != (*side == Side::inside)) continue;
    const double here = std::abs(interpolate(levels, box_corner(tunnel_roots(levels), hub)));
    if (here <= largest) continue;
    largest = here;
    found = hub;
  }
  return found;
}

DecidedCube decide_cube(const CornerLevels& levels, bool tunnels) {
  DecidedCube cube;
  for (unsigned c = 0; c < 8; ++c)
    if (levels[c] >= 0.0) cube.inside |= static_cast<std::uint8_t>(1U << c);
  const auto level_at = [&](int corner) { return levels[static_cast<std::size_t>(corner)]; };
  cube.joined = static_cast<std::uint8_t>(decide_faces(cube.inside, level_at).joined);
  const CubeCut& plain = cube_cut(cube.inside, cube.joined, false);
  const std::optional<int> hub = tunnels ? tunnel_hub(plain, levels) : std::nullopt;
  cube.cut = hub ? &tunnel_cut(cube.inside, cube.joined, false, *hub).cut : &plain;
  return cube;
}

std::array<Vec3, ring_size> tunnel_ring(const CornerLevels& levels, int hub, double least_share) {
  auto roots = tunnel_roots(levels);
  for (auto& [low, high] : roots) {
    const double middle = std::clamp((low + high) / 2, 2 * least_share, 1 - 2 * least_share);
    low = std::clamp(low, least_share, middle - least_share);
    high = std::clamp(high, middle + least_share, 1 - least_share);
  }
  std::array<Vec3, ring_size> ring{};
  for (int a = 0; a < ring_size; ++a) ring[a] = box_corner(roots, hub ^ 1 << a);
  return ring;
}

}  // namespace isoloop
