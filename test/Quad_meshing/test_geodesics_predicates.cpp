// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The predicates of windows against arithmetic of a hundred digits, on stored numbers for which the answer is a matter
// of the last digits. The same formulas in double are wrong on many of them, which is asserted too: else the numbers
// would test nothing.

#include <CGAL/Quad_meshing/Geodesics/internal/Turning_angle.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_merging.h>
#include <CGAL/Quad_meshing/Geodesics/internal/Window_predicates.h>

#include <CGAL/Random.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <vector>

namespace QM = CGAL::Quad_meshing::internal;
typedef boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                      boost::multiprecision::et_off>
  Number;
typedef QM::Window<double> Window;
typedef QM::Window_predicates<double> Predicates;
typedef QM::Window_comparisons<double> Comparisons;

CGAL::Random& random_numbers()
{
  static CGAL::Random random(5);
  return random;
}

double draw(double low, double high) { return random_numbers().get_double(low, high); }

// The number some units in the last place away.
double moved(double x, int units)
{
  const double to = units < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  for(int i = std::abs(units); i > 0; --i)
    x = std::nextafter(x, to);
  return x;
}

int sign(const Number& x)
{
  // no difference of the numbers here is that small unless it is zero
  return x > Number(1e-80) ? 1 : x < Number(-1e-80) ? -1 : 0;
}

Window circular(double x, double y, double sigma) { return Window{ 0., 1., x, y, sigma, 0, false, true, true, 0.f }; }

Window draw_window()
{
  if(random_numbers().get_int(0, 3) == 0)
  {
    const double x = draw(-1, 1);
    return Window{ 0., 1., x, std::sqrt(1 - x * x), draw(0, 30), 0, true, true, true, 0.f };
  }
  return circular(draw(-20, 20), draw(0, 20), draw(0, 30));
}

// The two parts of the distance.
Number rest(const Window& w, double t)
{
  const Number d = Number(t) - Number(w.x), y(w.y);
  return w.linear ? Number(Number(w.x) * Number(t)) : Number(sqrt(d * d + y * y));
}

int compare(const Window& v, const Window& w, double t, double slack)
{
  const Number difference = Number(v.sigma) + rest(v, t) - Number(w.sigma) - rest(w, t);
  const Number tie = Number(slack) * (abs(Number(w.sigma)) + abs(rest(w, t)));
  return sign(difference - tie) > 0 ? 1 : sign(difference + tie) < 0 ? -1 : 0;
}

// Nearly equal distances, and equal ones.
void test_distances()
{
  std::cout << "distances" << std::endl;
  int wrong = 0, answers[3] = { 0, 0, 0 };
  const auto check = [&](const Window& v, const Window& w, double t, double slack)
  {
    const double d = v.distance(t), e = w.distance(t), tie = slack * std::fabs(e);
    const int expected = compare(v, w, t, slack);
    assert(Comparisons::compare_distances(v, d, w, e, t, slack) == expected);
    wrong += (d - e < -tie ? -1 : d - e > tie ? 1 : 0) != expected;
    ++answers[expected + 1];
  };
  for(int i = 0; i < 10000; ++i)
  {
    Window v = draw_window(), w = draw_window();
    const double t = draw(0, 1), slack = i % 3 == 0 ? 0. : i % 3 == 1 ? 1e-14 : 1e-12;
    check(v, w, t, slack);
    v.sigma += w.distance(t) - v.distance(t) + random_numbers().get_int(-1, 2) * slack * w.distance(t);
    v.sigma = moved(v.sigma, random_numbers().get_int(-4, 5));
    check(v, w, t, slack);
    const Window tiny = circular(std::ldexp(v.x, -500), std::ldexp(v.y, -500), std::ldexp(v.sigma, -500));
    assert(Comparisons::compare_distances(tiny, tiny.distance(0), tiny, tiny.distance(0), 0, slack) == 0);
  }
  assert(wrong > 500 && answers[0] > 500 && answers[1] > 500 && answers[2] > 500);

  // integers with integer roots, and sources that lie symmetric
  for(int scale = -30; scale <= 30; ++scale)
  {
    const double s = std::ldexp(1., scale);
    const Window v = circular(-3 * s, 4 * s, 8 * s), w = circular(12 * s, 5 * s, 0),
                 line = Window{ 0., 1., 0.6, 0.8, 13 * s, 0, true, true, true, 0.f };
    for(const Window& other : { w, line, circular(3 * s, 4 * s, 8 * s) })
    {
      assert(Comparisons::compare_distances(v, v.distance(0), other, other.distance(0), 0, 0) == 0);
      Window longer = v, shorter = v;
      longer.sigma = moved(v.sigma, 1);
      shorter.sigma = moved(v.sigma, -1);
      assert(Comparisons::compare_distances(longer, v.distance(0), other, other.distance(0), 0, 0) == 1);
      assert(Comparisons::compare_distances(shorter, v.distance(0), other, other.distance(0), 0, 0) == -1);
    }
  }
}

// Windows that are just as long as the way over a vertex.
void test_ways()
{
  std::cout << "ways over vertices" << std::endl;
  int wrong = 0, longer = 0;
  for(int i = 0; i < 10000; ++i)
  {
    const Window w = draw_window();
    const double t = draw(0, 1), length = draw(1, 2), slack = i % 3 == 0 ? 0. : 1e-9;
    const double a = i % 2 == 0 ? t : length, from = i % 2 == 0 ? 0. : t;
    double d = w.distance(t) / (1 + slack) - (a - from);
    if(i % 5 == 0)
      d = -d; // sources may begin with a negative distance
    d = moved(d, random_numbers().get_int(-6, 7));
    const Number way = Number(a) - Number(from);
    const bool expected =
      sign(Number(w.sigma) + rest(w, t) - Number(d) - way - Number(slack) * (abs(Number(d)) + way)) > 0;
    assert(Comparisons::is_beyond(w, t, d, a, from, slack) == expected);
    wrong += (w.distance(t) > (d + (a - from)) * (1 + slack)) != expected;
    longer += expected;
    assert(!Predicates::is_longer_than_way(w, t, 1e300, a, from)); // a vertex that is not reached yet
  }
  assert(wrong > 100 && longer > 2500 && longer < 7500);
  assert(!Comparisons::is_beyond(circular(3, 4, 2), 0, 6, 1, 0, 0) &&
         Comparisons::is_beyond(circular(3, 4, moved(2, 1)), 0, 6, 1, 0, 0));
}

// Points on the ray through a place, or a rounding error beside it, from sources near and far.
void test_rays()
{
  std::cout << "rays" << std::endl;
  int wrong = 0, answers[3] = { 0, 0, 0 };
  for(int i = 0; i < 10000; ++i)
  {
    Window w = draw_window();
    const double far = std::pow(10., random_numbers().get_int(0, 13));
    if(!w.linear)
    {
      w.x *= far;
      w.y *= i % 2 == 0 ? far : 1.;
    }
    const double b = draw(0, 1), height = draw(0, 2), slack = i % 3 == 0 ? 0. : i % 3 == 1 ? 1e-11 : -1e-6;
    if(!(w.y > 0))
      continue;
    const double rise = w.linear ? w.x : b + slack - w.x;
    const double x = moved(b + slack + rise * height / w.y, random_numbers().get_int(-2, 3)),
                 y = i % 7 == 0 ? 0. : height;
    const Number place = Number(b) + Number(slack), cx(x), cy(y), wx(w.x), wy(w.y);
    const Number reached = w.linear ? Number(cx - cy * wx / wy) : Number(wx + (cx - wx) * wy / (cy + wy));
    const int expected = sign((reached - place) / (1 + abs(wx)));
    assert(Comparisons::is_right_of(w, x, y, b, slack) == (expected > 0) &&
           Comparisons::is_left_of(w, x, y, b, slack) == (expected < 0));
    const double t = w.place_of_ray(x, y);
    wrong += (t - b > slack) != (expected > 0) || (t - b < slack) != (expected < 0);
    ++answers[expected + 1];

    // the same as a side of the ray, for points on both sides of the edge
    for(const Number& h : { cy, Number(-0.5) })
    {
      const double py = static_cast<double>(h),
                   px = moved(b + (w.linear ? w.x : b - w.x) * py / w.y, random_numbers().get_int(-2, 3));
      const Number side = Number(w.y) * (Number(px) - Number(b)) -
                          (w.linear ? Number(w.x) : Number(Number(b) - Number(w.x))) * Number(py);
      assert(Comparisons::is_right_of_ray(w, px, py, b) == (sign(side) > 0));
    }
  }
  assert(wrong > 500 && answers[0] > 1000 && answers[2] > 1000);

  // small integers, where rays meet points
  for(int x = -5; x <= 5; ++x)
    for(int y = 1; y <= 5; ++y)
      for(int k = 0; k <= 3; ++k)
      {
        const Window w = circular(x, y, 0), line = Window{ 0., 1., double(x), double(y), 0., 0, true, true, true, 0.f };
        for(const Window& v : { w, line })
        {
          const int rise = v.linear ? x : 1 - x;
          const double px = 1 + k * rise, py = k * y, above = moved(px, 1), below = moved(px, -1);
          assert(!Comparisons::is_right_of(v, px, py, 1, 0) && !Comparisons::is_left_of(v, px, py, 1, 0));
          assert(Comparisons::is_right_of(v, above, py, 1, 0) && Comparisons::is_left_of(v, below, py, 1, 0));
          assert(!Comparisons::is_right_of_ray(v, px, py, 1) && Comparisons::is_right_of_ray(v, above, py, 1));
        }
      }
}

// Intervals and gaps as wide as their slack.
void test_widths()
{
  std::cout << "widths" << std::endl;
  int wrong = 0;
  for(int i = 0; i < 10000; ++i)
  {
    // every other slack is about as large as the numbers are, where the difference has digits to lose
    const int digits_less = random_numbers().get_int(0, 2) * random_numbers().get_int(0, 60);
    const double slack = std::ldexp(draw(0.5, 1), -digits_less), a = draw(-1, 1),
                 b = moved(a + slack, random_numbers().get_int(-1, 2));
    const bool expected = Number(b) - Number(a) > Number(slack);
    assert(Comparisons::is_wider(a, b, slack) == expected);
    wrong += (b - a > slack) != expected;

    const Window w = draw_window();
    const double gap = w.largest_gap(b, 1), end = moved(b + gap, random_numbers().get_int(-1, 2));
    assert(Predicates::is_closed_gap(w, b, end, b, 1) == (Number(end) - Number(b) <= Number(gap)));
    assert(Predicates::is_closed_gap(w, b, b, b, 1) && !Predicates::is_closed_gap(w, b, b + 2e-4, b, 1));

    Window v = w;
    const double scale = w.linear ? 1. : std::fabs(w.b1 - w.x) + w.y,
                 close = QM::Window_tolerances<double>::source() * scale;
    v.x = moved(w.x + close, random_numbers().get_int(-1, 2));
    assert(Predicates::have_same_source(w, v) == (Number(v.x) - Number(w.x) <= Number(close)));
  }
  assert(wrong > 100);
}

// Corners around a vertex that close up to the last digit, and with it.
void test_angles()
{
  std::cout << "angles" << std::endl;
  const Number pi = acos(Number(-1));
  int wrong = 0, answers[2] = { 0, 0 }, doubts = 0;
  for(int i = 0; i < 3000; ++i)
  {
    const int n = random_numbers().get_int(3, 12), half_turns = i % 2 + 1;
    const double slack = i % 3 == 0 ? 0. : i % 3 == 1 ? 1e-14 : -1e-6;
    std::vector<QM::Turning_angle::Vector> corners;
    double angle = 0;
    for(int k = 0; k + 1 < n; ++k)
    {
      const double a = draw(0, 1.9 * half_turns / n), l = std::ldexp(draw(0.5, 1), random_numbers().get_int(-20, 20));
      corners.push_back(QM::Turning_angle::Vector{ l * std::cos(a), l * std::sin(a) });
      angle += a;
    }
    const double last = half_turns * std::acos(-1.) + (i % 4 == 0 ? 0. : slack) - angle;
    if(!(last > 0) || last > std::acos(-1.))
      continue;
    corners.push_back(QM::Turning_angle::Vector{ moved(std::cos(last), random_numbers().get_int(-3, 4)),
                                                 moved(std::sin(last), random_numbers().get_int(-3, 4)) });
    if(corners.back().y < 0)
      continue;
    QM::Turning_angle sum;
    Number exact = 0;
    double plain = 0;
    for(const auto& c : corners)
    {
      sum.add(c.x, c.y);
      exact += atan2(Number(c.y), Number(c.x));
      plain += std::atan2(c.y, c.x);
    }
    const bool expected = exact > half_turns * pi + atan(Number(slack));
    assert(QM::Turning_angle::exceeds_exactly(corners, half_turns, slack) == expected);
    assert(sum.exceeds(half_turns, slack,
                       [&]
                       {
                         ++doubts;
                         return expected;
                       }) == expected);
    wrong += (plain > half_turns * std::acos(-1.) + slack) != expected;
    ++answers[expected];
  }
  assert(wrong > 100 && doubts > 100 && answers[0] > 500 && answers[1] > 500);

  // right angles, straight ones and none
  typedef QM::Turning_angle::Vector V;
  for(const std::vector<V>& corners :
      { std::vector<V>{ { 0, 3 }, { 0, 1 }, { 0, 5 }, { 0, 2 } }, std::vector<V>{ { -2, 0 }, { -7, 0 } },
        std::vector<V>{ { -1, 0 }, { 3, 0 }, { 0, 1 }, { 0, 1 } },
        std::vector<V>{ { 1, 3 }, { 3, 1 }, { -5, 0 }, { 0, 4 } } })
  {
    QM::Turning_angle sum;
    for(const V& c : corners)
      sum.add(c.x, c.y);
    const auto exactly = [&](int n, double slack)
    { return sum.exceeds(n, slack, [&] { return QM::Turning_angle::exceeds_exactly(corners, n, slack); }); };
    assert(exactly(1, 0) && !exactly(2, 0) && !exactly(2, 1e-14) && exactly(2, -1e-14) && !exactly(3, 0));
  }
}

// Whether a merged window keeps the distances at the ends of both, and differs in between by no more than its error.
bool stands_for(const Window& merged, const Window& l, const Window& r)
{
  const double rounding = 1e-13;
  bool is_right = merged.b0 == l.b0 && merged.b1 == r.b1 &&
                  std::abs(merged.distance(l.b0) - l.distance(l.b0)) < rounding &&
                  std::abs(merged.distance(r.b1) - r.distance(r.b1)) < rounding;
  const int samples = 50;
  for(int i = 0; i <= samples; ++i)
    for(const Window* w : { &l, &r })
    {
      const double t = w->b0 + (w->b1 - w->b0) * i / samples;
      is_right = is_right && std::abs(merged.distance(t) - w->distance(t)) <= merged.error + rounding;
    }
  return is_right;
}

// Neighbors are merged into a window that keeps the distances at the ends, unless its error were too large. Straight
// fronts whose rays part are not: between them there is something else.
void test_merging()
{
  int linear_merges = 0, circular_merges = 0;
  for(int i = 0; i < 1000; ++i)
  {
    const double x = draw(-0.6, 0.6), turn = draw(0.01, 0.3), b = draw(0.3, 0.7), distance = draw(3, 9);
    auto linear = [](double b0, double b1, double x, double sigma)
    { return Window{ b0, b1, x, std::sqrt(1 - x * x), sigma, 0, true, true, true, 0.f }; };
    const Window l = linear(0, b, x, distance);
    auto neighbor = [&](double slope) { return linear(b, 1, slope, l.distance(b) - slope * b); };
    Window merged;
    const double any = 1; // a relative error
    assert(!QM::merge_windows(l, neighbor(x + turn), any, merged));
    assert(QM::merge_windows(l, neighbor(x - turn), any, merged) && stands_for(merged, l, neighbor(x - turn)));
    assert(merged.error > 0 && !QM::merge_windows(l, neighbor(x - turn), 0.9 * merged.error / distance, merged));
    ++linear_merges;

    // The second source lies on the ray of the first one to the place where both meet, as behind a saddle.
    const double sx = draw(-1, 2), sy = draw(1, 3), s = draw(0.05, 0.6);
    Window first = circular(sx, sy, distance), second = circular(sx + s * (b - sx), (1 - s) * sy, 0);
    first.b1 = second.b0 = b;
    second.sigma = first.distance(b) - second.distance(b);
    if(QM::merge_windows(first, second, any, merged))
    {
      assert(stands_for(merged, first, second));
      ++circular_merges;
    }
  }
  std::cout << linear_merges << " linear and " << circular_merges << " circular windows merged" << std::endl;
  assert(circular_merges > 100);
}

int main()
{
  test_distances();
  test_ways();
  test_rays();
  test_widths();
  test_angles();
  test_merging();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
