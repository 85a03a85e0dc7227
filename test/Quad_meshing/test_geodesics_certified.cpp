// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Enclosures of distances against distances of a hundred digits, found by going through all sequences of faces.

#include "geodesics_meshes.h"
#include "test_cases.h"

#include <CGAL/Quad_meshing/Geodesics/certify_distances.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace geodesics_meshes;
namespace params = CGAL::parameters;
namespace QM = CGAL::Quad_meshing;
typedef Mesh::Vertex_index Vertex;
typedef CGAL::Interval_nt<> Interval;
typedef boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                      boost::multiprecision::et_off>
  Number;
typedef CGAL::Quad_meshing::internal::Certified_number Certified_number;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool contains(const Certified_number& x, const Number& value)
{
  return Number(x.lower()) <= value && value <= Number(x.upper());
}

// The arithmetic under the certificates, against a hundred digits: the intervals hold and are narrow.
void test_numbers()
{
  std::cout << "numbers" << std::endl;
  CGAL::Random random(11);
  for(int i = 0; i < 20000; ++i)
  {
    const auto draw = [&] { return std::ldexp(random.get_double(-1., 1.), random.get_int(-40, 40)); };
    const double a = draw(), b = draw(), c = draw();
    const Certified_number x = Certified_number(a) * Certified_number(b) + Certified_number(c),
                           y = Certified_number::difference(a, c);
    const Number u = Number(a) * Number(b) + Number(c), v = Number(a) - Number(c);
    assert(contains(x, u) && contains(y, v));
    assert(contains(x * y - x, u * v - u) && contains(x / y, u / v) && contains(abs(x), abs(u)));
    const Certified_number root = sqrt(x * x + y * y);
    assert(contains(root, sqrt(u * u + v * v)));
    // differences in which all digits of double cancel
    const Number rest = sqrt(u * u + v * v) - Number(root.high());
    const Certified_number difference = root - Certified_number(root.high());
    assert(contains(difference, rest));
    assert(difference.upper() - difference.lower() < 1e-24 * root.high());
  }
  assert((Certified_number(1) / (Certified_number(1) - Certified_number(1))).upper() == infinity);
}

// The distances from vertices by brute force: the shortest straight ways between any two vertices in all unfoldings,
// then the shortest chains of them. Knows nothing of saddles, and drops nothing but what is longer than a given length.
class Oracle
{
  const Mesh& m_tm;
  Number m_longest;
  std::vector<std::vector<Number>> m_straight;

  typedef Mesh::Halfedge_index Halfedge;

  Number squared(Vertex v, Vertex w) const
  {
    Number sum = 0;
    for(int c = 0; c < 3; ++c)
    {
      const Number d = Number(m_tm.point(v)[c]) - Number(m_tm.point(w)[c]);
      sum += d * d;
    }
    return sum;
  }

  void see(int from, Vertex v, const Number& d)
  {
    Number& known = m_straight[from][v];
    known = (std::min)(known, d);
  }

  // Rays from (x, -y) in the frame of h, which lies in its face, through [b0, b1].
  void go_on(int from, Halfedge h, const Number& x, const Number& y, const Number& b0, const Number& b1)
  {
    const Number tiny(1e-70);
    if(m_tm.is_border(h) || !(b1 - b0 > tiny))
      return;
    const Number nearest = (std::min)((std::max)(x, b0), b1) - x;
    if(nearest * nearest + y * y > m_longest * m_longest)
      return;
    const Vertex p = m_tm.source(h), q = m_tm.target(h), r = m_tm.target(m_tm.next(h));
    const Number pq = squared(p, q), pr = squared(p, r), qr = squared(q, r), l = sqrt(pq);
    const Number rx = (pq + pr - qr) / (2 * l), ry = sqrt((std::max)(Number(0), pr - rx * rx));
    const Number t = x + (rx - x) * y / (ry + y);
    if(t >= b0 - tiny && t <= b1 + tiny)
      see(from, r, sqrt((rx - x) * (rx - x) + (ry + y) * (ry + y)));
    // where the ray through b meets the edge from (ax, ay) to (bx, by), as a part of it
    const auto part = [&](const Number& b, const Number& ax, const Number& ay, const Number& bx, const Number& by)
    {
      const Number dx = b - x;
      return (y * (ax - b) - dx * ay) / (dx * (by - ay) - y * (bx - ax));
    };
    const auto pass = [&](Halfedge g, const Number& ax, const Number& ay, const Number& bx, const Number& by,
                          const Number& from_part, const Number& to_part)
    {
      // the opposite halfedge runs from (bx, by) to (ax, ay), and its face lies on its left
      const Number n = sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay)), ux = (ax - bx) / n, uy = (ay - by) / n;
      const Number dx = x - bx, dy = -y - by;
      go_on(from, m_tm.opposite(g), dx * ux + dy * uy, abs(dy * ux - dx * uy), n * (1 - to_part), n * (1 - from_part));
    };
    if(t < b1)
      pass(m_tm.next(h), l, 0, rx, ry, part(b1, l, 0, rx, ry), t > b0 ? Number(1) : part(b0, l, 0, rx, ry));
    if(t > b0)
      pass(m_tm.prev(h), rx, ry, 0, 0, t < b1 ? Number(0) : part(b1, rx, ry, 0, 0), part(b0, rx, ry, 0, 0));
  }

public:
  Oracle(const Mesh& tm, double longest)
    : m_tm(tm)
    , m_longest(longest)
    , m_straight(tm.number_of_vertices(), std::vector<Number>(tm.number_of_vertices(), Number(1e100)))
  {
    for(Halfedge h : tm.halfedges())
    {
      const Vertex v = tm.source(h), w = tm.target(h);
      see(v, w, sqrt(squared(v, w)));
      if(tm.is_border(h))
        continue;
      // out of the face of h over the edge opposite to v
      const Halfedge o = tm.opposite(tm.next(h));
      const Vertex p = tm.source(o), q = tm.target(o);
      const Number l = sqrt(squared(p, q)), x = (squared(p, q) + squared(p, v) - squared(q, v)) / (2 * l);
      go_on(v, o, x, sqrt((std::max)(Number(0), squared(p, v) - x * x)), 0, l);
    }
  }

  std::vector<Number> distances(const std::vector<std::pair<Vertex, double>>& sources) const
  {
    std::vector<Number> d(m_straight.size(), Number(1e100));
    for(const auto& s : sources)
      d[s.first] = (std::min)(d[s.first], Number(s.second));
    std::vector<bool> done(d.size(), false);
    for(std::size_t n = 0; n < d.size(); ++n)
    {
      std::size_t v = d.size();
      for(std::size_t w = 0; w < d.size(); ++w)
        if(!done[w] && (v == d.size() || d[w] < d[v]))
          v = w;
      done[v] = true;
      for(std::size_t w = 0; w < d.size(); ++w)
        d[w] = (std::min)(d[w], d[v] + m_straight[v][w]);
    }
    return d;
  }
};

template <typename Map>
void check_width(const Mesh& tm, const Field& field, const QM::Distance_certificate& certificate, const Map& enclosures)
{
  assert(certificate);
  double worst = 0;
  for(Vertex v : tm.vertices())
    if(field.is_reached(v))
      worst = (std::max)(worst, enclosures[v].sup() - enclosures[v].inf());
  assert(worst == certificate.largest_width);
}

void test_against_brute_force()
{
  std::cout << "brute force" << std::endl;
  std::vector<Soup> soups = { perturbed(icosphere(1), 0.1, 1),
                              icosphere(0),
                              perturbed(cube(1), 0.1, 3),
                              cube(2),
                              perturbed(torus(6, 4), 0.05, 2),
                              l_prism(1),
                              perturbed(grid(3, 3), 0.05, 4),
                              grid(3, 3),
                              grid_with_hole(4, 4, 1, 3, 1, 3),
                              fan(8, 1.3, true),
                              mapped(perturbed(grid(3, 2), 0.02, 5),
                                     [](const Point_3& p) { return rotated(Point_3(1000 * p.x(), p.y(), p.z())); }),
                              mapped(perturbed(cube(1), 0.1, 6),
                                     [](const Point_3& p) { return Point_3(p.x() + 1000, 1e-3 * p.y(), p.z()); }) };
  for(unsigned int seed = 0; seed < 6; ++seed)
    soups.push_back(perturbed(icosphere(0), 0.4, 20 + seed));
  double widest = 0;
  for(const Soup& soup : soups)
  {
    Mesh tm = make_mesh(soup);
    auto enclosures = tm.add_property_map<Vertex, Interval>("v:enclosure").first;
    const Vertex a(0), b(static_cast<Mesh::size_type>(tm.number_of_vertices() - 1));
    Field field(tm);
    field.add_source(a);
    const double longest = field.propagate().maximum_distance * 1.000001;
    const Oracle oracle(tm, longest);
    for(int test = 0; test < 3; ++test)
    {
      std::vector<std::pair<Vertex, double>> sources(1, std::make_pair(test == 1 ? b : a, 0.));
      if(test == 2)
        sources.emplace_back(b, 0.25 * longest);
      field.clear();
      for(const auto& s : sources)
        field.add_source(s.first, s.second);
      if(field.propagate().maximum_distance > longest)
        continue; // the brute force did not go that far
      const auto certificate = QM::certify_distances(field, enclosures);
      check_width(tm, field, certificate, enclosures);
      const std::vector<Number> exact = oracle.distances(sources);
      for(Vertex v : tm.vertices())
        assert(Number(enclosures[v].inf()) <= exact[v] && exact[v] <= Number(enclosures[v].sup()));
      widest = (std::max)(widest, certificate.largest_relative_width);
    }
  }
  std::cout << "  relative width up to " << widest << std::endl;
  assert(widest < 1e-11);
}

// Curves as sources where the distance is known.
void test_known_distances()
{
  std::cout << "known distances" << std::endl;
  Mesh tm = make_mesh(uneven_square(12, 3));
  auto enclosures = tm.add_property_map<Vertex, Interval>("v:enclosure").first;
  Field field(tm);
  field.add_border_source();
  field.propagate();
  auto certificate = QM::certify_distances(field, enclosures);
  check_width(tm, field, certificate, enclosures);
  assert(certificate.largest_relative_width < 1e-11);
  for(Vertex v : tm.vertices())
  {
    const Point_3& p = tm.point(v);
    const Number exact =
      (std::min)({ Number(p.x()), Number(p.y()), Number(1) - Number(p.x()), Number(1) - Number(p.y()) });
    assert(Number(enclosures[v].inf()) <= exact && exact <= Number(enclosures[v].sup()));
  }

  // a polyline with a leg in the interior of faces, and a point in a face: what is added moves by rounding
  const Location p(Mesh::Face_index(60), { { 0.2, 0.3, 0.5 } }), q(Mesh::Face_index(60), { { 0.6, 0.3, 0.1 } }),
    r(Mesh::Face_index(200), { { 0.4, 0.4, 0.2 } });
  field.clear();
  field.add_polyline_source(std::vector<Location>{ p, q });
  field.add_source(r, 0.1);
  field.propagate();
  certificate = QM::certify_distances(field, enclosures);
  check_width(tm, field, certificate, enclosures);
  assert(certificate.largest_relative_width < 1e-10);
  for(Vertex v : tm.vertices())
  {
    const double d = (std::min)(distance_to_segment(tm.point(v), point(tm, p), point(tm, q)),
                                0.1 + distance(tm.point(v), point(tm, r)));
    assert(enclosures[v].inf() <= d + 1e-15 && d - 1e-15 <= enclosures[v].sup());
  }
}

// The points in which the segment pq meets the edges of a mesh in the plane z = 0, in their order, between those of its
// ends.
std::vector<Location> traced(const Mesh& tm, const Point_3& p, const Point_3& q)
{
  std::vector<std::pair<double, Location>> found;
  const auto side = [&](const Point_3& x)
  { return (q.x() - p.x()) * (x.y() - p.y()) - (q.y() - p.y()) * (x.x() - p.x()); };
  for(auto e : tm.edges())
  {
    auto h = tm.halfedge(e);
    if(tm.is_border(h))
      h = tm.opposite(h);
    const Point_3 &a = tm.point(tm.source(h)), &b = tm.point(tm.target(h));
    const double s = side(a) / (side(a) - side(b));
    if(!(side(a) * side(b) < 0))
      continue;
    const Point_3 x = a + s * (b - a);
    const double t = ((x - p) * (q - p)) / ((q - p) * (q - p));
    if(!(0 < t && t < 1))
      continue;
    Location l(tm.face(h), { { 0, 0, 0 } });
    auto g = tm.halfedge(l.first);
    for(int k = 0; k < 3; ++k, g = tm.next(g))
      if(g == h)
      {
        l.second[k] = 1 - s;
        l.second[(k + 1) % 3] = s;
      }
    found.emplace_back(t, l);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Location> points;
  for(const auto& f : found)
    points.push_back(f.second);
  return points;
}

// Polylines that cross many faces are certified as closely as points are.
void test_crossing_polylines()
{
  std::cout << "polylines across faces" << std::endl;
  double widest = 0;
  for(unsigned int seed = 1; seed <= 12; ++seed)
  {
    Mesh tm = make_mesh(seed % 2 == 0 ? grid(8, 8) : uneven_square(8, seed));
    auto enclosures = tm.add_property_map<Vertex, Interval>("v:enclosure").first;
    const double angle = 0.5 * seed;
    const CGAL::Vector_3<Mesh::Point::R> d(0.37 * std::cos(angle), 0.37 * std::sin(angle), 0);
    const Point_3 middle(0.511, 0.487, 0);
    const std::vector<Location> points = traced(tm, middle - d, middle + d);
    assert(points.size() > 4);
    Field field(tm);
    assert(field.add_polyline_source(points) != Field::no_source());
    field.propagate();
    const auto certificate = QM::certify_distances(field, enclosures);
    check_width(tm, field, certificate, enclosures);
    widest = (std::max)(widest, certificate.largest_width);
    const Point_3 first = point(tm, points.front()), last = point(tm, points.back());
    for(Vertex v : tm.vertices())
    {
      const double exact = distance_to_segment(tm.point(v), first, last);
      assert(enclosures[v].inf() <= exact + 1e-14 && exact - 1e-14 <= enclosures[v].sup());
    }
  }
  std::cout << "  width up to " << widest << std::endl;
  assert(widest < 1e-11);
}

// What is wrong or missing in a field makes enclosures wide, never wrong.
void test_bad_fields()
{
  std::cout << "fields with errors" << std::endl;
  Mesh tm = make_mesh(perturbed(torus(24, 12), 0.02, 8));
  auto enclosures = tm.add_property_map<Vertex, Interval>("v:enclosure").first;
  Field exact(tm), field(tm);
  exact.add_source(Vertex(3));
  field.add_source(Vertex(3));
  exact.propagate();
  const auto holds = [&]
  {
    for(Vertex v : tm.vertices())
      assert(enclosures[v].inf() <= exact.distance(v) * (1 + 1e-13) &&
             exact.distance(v) * (1 - 1e-13) <= enclosures[v].sup());
  };
  assert(QM::certify_distances(exact, enclosures).largest_relative_width < 1e-10);
  holds();
  field.propagate(params::relative_distance_error(1e-2));
  assert(QM::certify_distances(field, enclosures).largest_relative_width > 1e-4);
  holds();
  field.propagate(params::distance_limit(0.5));
  QM::certify_distances(field, enclosures);
  for(Vertex v : tm.vertices())
    assert(!field.is_reached(v) ||
           (enclosures[v].inf() <= exact.distance(v) && exact.distance(v) <= enclosures[v].sup() * (1 + 1e-13)));
  field.propagate(params::keep_windows(false));
  assert(!QM::certify_distances(field, enclosures));
  holds();
  struct Stopper : QM::Default_visitor
  {
    int calls = 0;
    bool go_further() { return ++calls < 3; }
  };
  Stopper stopper;
  assert(!QM::certify_distances(exact, enclosures, params::visitor(std::ref(stopper))));
  holds();

  // components without a source, doubled points, faces without area
  Mesh two = make_mesh(two_components(3, 2));
  auto e = two.add_property_map<Vertex, Interval>("v:enclosure").first;
  Field part(two);
  part.add_source(Vertex(0));
  part.propagate();
  assert(QM::certify_distances(part, e).largest_relative_width < 1e-11);
  for(Vertex v : two.vertices())
    assert(part.is_reached(v) ? e[v].sup() < infinity : e[v].inf() == infinity);
  Soup soup = grid(4, 4);
  const Triangle t = soup.triangles[5];
  const std::size_t doubled = soup.points.size();
  soup.points.push_back(soup.points[t[1]]);
  soup.triangles[5] = { { t[0], doubled, t[2] } };
  soup.triangles.push_back({ { t[0], t[1], doubled } });
  soup.triangles.push_back({ { doubled, t[1], t[2] } });
  Mesh degenerate = make_mesh(soup);
  auto d = degenerate.add_property_map<Vertex, Interval>("v:enclosure").first;
  Field flat(degenerate);
  flat.add_source(Vertex(0));
  flat.propagate();
  assert(QM::certify_distances(flat, d));
  for(Vertex v : degenerate.vertices())
  {
    const double known = distance(degenerate.point(Vertex(0)), degenerate.point(v));
    assert(d[v].inf() <= known * (1 + 1e-15) && known * (1 - 1e-15) <= d[v].sup());
  }
}

// The number type asks for enclosures.
void test_interval_field()
{
  std::cout << "fields of intervals" << std::endl;
  const Mesh tm = make_mesh(perturbed(icosphere(2), 0.05, 4));
  QM::Geodesic_distance_field<Mesh, Interval> field(tm);
  Field plain(tm);
  field.add_source(Vertex(7));
  plain.add_source(Vertex(7));
  assert(field.propagate() && plain.propagate() && field.certificate());
  for(Vertex v : tm.vertices())
  {
    const Interval d = field.distance_value(v);
    assert(d.inf() <= plain.distance(v) * (1 + 1e-13) && plain.distance(v) <= d.sup() * (1 + 1e-13));
    assert(d.sup() - d.inf() <= 1e-11 * d.sup() && field.distance(v) == plain.distance(v));
  }
}

// What was once wrong, too little for the distances of vertices to show it: shadows of saddles so shallow that they
// passed for rounding, and ridges between two sources of one distance up to rounding.
void test_narrow_windows()
{
  std::cout << "narrow windows" << std::endl;
  std::vector<Soup> soups;
  const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6; };
  for(double height : { 0., 1e-6, 1e-4 })
    soups.push_back(mapped(grid(24, 24),
                           [&](const Point_3& p)
                           {
                             const Point_3 q =
                               rotated(Point_3(p.x(), p.y(), height * std::sin(40 * p.x()) * std::sin(50 * p.y())));
                             return Point_3(rounded(q.x()), rounded(q.y()), rounded(q.z()));
                           }));
  for(double frequency : { 12., 17., 25. })
    soups.push_back(mapped(
      grid(24, 24),
      [&](const Point_3& p) {
        return Point_3(p.x(), p.y(), 0.1 * std::cos(frequency * (p.x() - 0.5)) * std::cos(frequency * (p.y() - 0.5)));
      }));
  for(const Soup& soup : soups)
  {
    Mesh tm = make_mesh(soup);
    auto enclosures = tm.add_property_map<Vertex, Interval>("v:enclosure").first;
    for(int source : { 0, 12, 312 })
    {
      Field field(tm);
      field.add_source(Vertex(source));
      field.propagate();
      const auto certificate = QM::certify_distances(field, enclosures);
      assert(certificate && certificate.largest_relative_width < 3e-11);
    }
  }
}

// Real meshes, where CGAL's data folder is installed.
void test_real_meshes()
{
  std::cout << "real meshes" << std::endl;
  for(const char* name : { "eight", "pinion", "couplingdown", "elephant", "anchor_dense", "fandisk" })
  {
    Mesh tm;
    if(!CGAL::IO::read_polygon_mesh(CGAL::data_file_path(std::string("meshes/") + name + ".off"), tm))
      continue;
    auto enclosures = tm.add_property_map<Vertex, Interval>("v:enclosure").first;
    Field field(tm);
    field.add_source(Vertex(0));
    field.propagate();
    const auto certificate = QM::certify_distances(field, enclosures);
    std::cout << "  " << name << ": relative width up to " << certificate.largest_relative_width << std::endl;
    assert(certificate && certificate.largest_relative_width < 1e-9);
  }
}

int main(int argc, char** argv)
{
  return run_cases(argc, argv,
                   { { "numbers", test_numbers },
                     { "against_brute_force", test_against_brute_force },
                     { "known_distances", test_known_distances },
                     { "crossing_polylines", test_crossing_polylines },
                     { "bad_fields", test_bad_fields },
                     { "interval_field", test_interval_field },
                     { "narrow_windows", test_narrow_windows },
                     { "real_meshes", test_real_meshes } });
}
