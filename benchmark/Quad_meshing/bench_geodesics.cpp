// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Geodesic distances: time, windows and memory, exact and approximate, against CGAL's Surface_mesh_shortest_path.
//
//   bench_geodesics [--without-reference] [--repeat N] [--subdivide LEVELS] MESH...
//
// Without meshes, those of CGAL's data folder are measured.
//
// Each mesh is measured from one vertex and from its sharp edges (dihedral angle above 40 degrees), and so is the mesh
// after each of LEVELS one-to-four subdivisions. Times are processor times, and contain what the system does for the
// programs, as giving out memory takes time. They are medians of N runs, in which the programs take turns; so are the
// ratios, how much longer CGAL's takes than ours, with windows and without. Memory is what the heap holds more at the
// end of the first propagation than before it. Windows are counted on all edges, after that. The columns v-only are for
// exact distances at the vertices, without windows kept, and `differ` is the largest relative difference to CGAL's
// distances.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Quad_meshing::Geodesic_distance_field<Mesh> Field;
typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Shortest_path;

namespace params = CGAL::parameters;

namespace {

double heap_megabytes()
{
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const auto info = mallinfo2();
  return double(info.uordblks + info.hblkhd) / 1e6;
#else
  return 0;
#endif
}

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Measurement
{
  double seconds, megabytes, windows_per_edge;
};

double median(std::vector<double> numbers)
{
  std::nth_element(numbers.begin(), numbers.begin() + numbers.size() / 2, numbers.end());
  return numbers[numbers.size() / 2];
}

// Some ways to compute distances, each measured `repeat` times. They take turns, as the speed of a machine changes
// while others work on it.
class Comparison
{
public:
  typedef std::function<Measurement()> Way;

  Comparison(int repeat, const std::vector<Way>& ways) : m_seconds(ways.size())
  {
    for(const Way& way : ways)
      m_first.push_back(way());
    for(std::size_t k = 0; k < ways.size(); ++k)
      m_seconds[k].push_back(m_first[k].seconds);
    for(int i = 1; i < repeat; ++i)
      for(std::size_t k = 0; k < ways.size(); ++k)
        m_seconds[k].push_back(ways[k]().seconds);
  }

  const Measurement& operator[](std::size_t way) const { return m_first[way]; }
  double seconds(std::size_t way) const { return median(m_seconds[way]); }

  // How much longer one takes than the other.
  double ratio(std::size_t way, std::size_t other) const
  {
    std::vector<double> ratios;
    for(std::size_t i = 0; i < m_seconds[way].size(); ++i)
      ratios.push_back(m_seconds[way][i] / m_seconds[other][i]);
    return median(ratios);
  }

private:
  std::vector<Measurement> m_first;
  std::vector<std::vector<double>> m_seconds;
};

// Of the constructor and the propagation together, as CGAL's class has no separate set-up either.
Measurement measure(const Mesh& tm, const std::function<void(Field&)>& add_sources, double error, bool keep_windows,
                    std::vector<double>& distances)
{
  Measurement m;
  const double before = heap_megabytes();
  const double start = processor_seconds();
  Field field(tm);
  add_sources(field);
  field.propagate(params::relative_distance_error(error).keep_windows(keep_windows));
  m.seconds = processor_seconds() - start;
  m.megabytes = heap_megabytes() - before;
  m.windows_per_edge = double(field.number_of_windows()) / double(tm.number_of_edges());
  distances.clear();
  for(auto v : tm.vertices())
    distances.push_back(field.distance(v));
  return m;
}

Measurement measure_reference(const Mesh& tm, std::vector<double>& distances)
{
  Measurement m;
  const double before = heap_megabytes();
  const double start = processor_seconds();
  Shortest_path shortest_path(tm);
  shortest_path.add_source_point(*tm.vertices().begin());
  shortest_path.build_sequence_tree();
  distances.clear();
  for(auto v : tm.vertices())
    distances.push_back(shortest_path.shortest_distance_to_source_points(v).first);
  m.seconds = processor_seconds() - start;
  m.megabytes = heap_megabytes() - before;
  m.windows_per_edge = 0;
  return m;
}

// Divides each triangle into four.
Mesh subdivided(const Mesh& tm)
{
  Mesh fine;
  fine.reserve(static_cast<Mesh::size_type>(tm.number_of_vertices() + tm.number_of_edges()),
               static_cast<Mesh::size_type>(2 * tm.number_of_edges() + 3 * tm.number_of_faces()),
               static_cast<Mesh::size_type>(4 * tm.number_of_faces()));
  for(auto v : tm.vertices())
    fine.add_vertex(tm.point(v));
  std::vector<Mesh::Vertex_index> middle(tm.number_of_edges());
  for(auto e : tm.edges())
    middle[e] = fine.add_vertex(CGAL::midpoint(tm.point(tm.vertex(e, 0)), tm.point(tm.vertex(e, 1))));
  for(auto f : tm.faces())
  {
    const auto h = tm.halfedge(f), n = tm.next(h), p = tm.prev(h);
    const auto a = middle[tm.edge(h)], b = middle[tm.edge(n)], c = middle[tm.edge(p)];
    fine.add_face(tm.source(h), a, c);
    fine.add_face(tm.source(n), b, a);
    fine.add_face(tm.source(p), c, b);
    fine.add_face(a, b, c);
  }
  return fine;
}

double largest_relative_difference(const std::vector<double>& a, const std::vector<double>& b)
{
  double worst = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    if(a[i] != b[i])
      worst = (std::max)(worst, std::fabs(a[i] - b[i]) / (std::max)(a[i], b[i]));
  return worst;
}

} // namespace

int main(int argc, char* argv[])
{
  bool with_reference = true;
  int repeat = 1, levels = 0;
  std::vector<std::string> filenames;
  for(int i = 1; i < argc; ++i)
  {
    if(std::strcmp(argv[i], "--without-reference") == 0)
      with_reference = false;
    else if(std::strcmp(argv[i], "--repeat") == 0 && i + 1 < argc)
      repeat = (std::max)(1, std::atoi(argv[++i]));
    else if(std::strcmp(argv[i], "--subdivide") == 0 && i + 1 < argc)
      levels = std::atoi(argv[++i]);
    else
      filenames.push_back(argv[i]);
  }
  if(filenames.empty())
    for(const char* name :
        { "eight", "pinion", "holes", "elephant", "knot1", "cow", "dino", "anchor_dense", "fandisk", "armadillo" })
      filenames.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));

  std::printf("%-18s %8s %6s | %8s %5s %7s | %7s %7s | %7s %5s %7s | %7s %7s %6s %6s %8s %8s\n", "mesh", "faces",
              "source", "exact s", "w/e", "MB", "v-only", "MB", "0.1% s", "w/e", "error", "CGAL s", "MB", "ratio",
              "v-only", "differ", "v-only");
  for(const std::string& filename : filenames)
  {
    Mesh tm;
    if(!CGAL::Quad_meshing::read_triangle_mesh(filename, tm))
    {
      std::printf("%s: skipped\n", filename.c_str());
      continue;
    }
    const std::string name = filename.substr(filename.find_last_of('/') + 1);
    for(int level = 0; level <= levels; ++level)
    {
      if(level > 0)
        tm = subdivided(tm);
      std::vector<Mesh::Edge_index> sharp;
      auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
      CGAL::Polygon_mesh_processing::detect_sharp_edges(tm, 40, is_sharp);
      for(auto e : tm.edges())
        if(is_sharp[e])
          sharp.push_back(e);

      std::vector<double> exact, approximate, at_vertices, reference;
      for(bool from_edges : { false, true })
      {
        if(from_edges && sharp.empty())
          continue;
        const auto add_sources = [&](Field& field)
        {
          if(from_edges)
            field.add_edges_source(sharp);
          else
            field.add_source(*tm.vertices().begin());
        };
        const bool with_reference_here = with_reference && !from_edges;
        enum
        {
          EXACT,
          APPROXIMATE,
          AT_VERTICES,
          REFERENCE
        };
        std::vector<Comparison::Way> ways{ [&] { return measure(tm, add_sources, 0, true, exact); },
                                           [&] { return measure(tm, add_sources, 1e-3, true, approximate); },
                                           [&] { return measure(tm, add_sources, 0, false, at_vertices); } };
        if(with_reference_here)
          ways.push_back([&] { return measure_reference(tm, reference); });
        const Comparison c(repeat, ways);
        std::printf("%-18s %8d %6s | %8.3f %5.2f %7.1f | %7.3f %7.1f | %7.3f %5.2f %7.1e", name.c_str(),
                    int(tm.number_of_faces()), from_edges ? "edges" : "vertex", c.seconds(EXACT),
                    c[EXACT].windows_per_edge, c[EXACT].megabytes, c.seconds(AT_VERTICES), c[AT_VERTICES].megabytes,
                    c.seconds(APPROXIMATE), c[APPROXIMATE].windows_per_edge,
                    largest_relative_difference(exact, approximate));
        if(with_reference_here)
          std::printf(" | %7.3f %7.1f %6.1f %6.1f %8.1e %8.1e", c.seconds(REFERENCE), c[REFERENCE].megabytes,
                      c.ratio(REFERENCE, EXACT), c.ratio(REFERENCE, AT_VERTICES),
                      largest_relative_difference(exact, reference),
                      largest_relative_difference(at_vertices, reference));
        std::printf("\n");
        std::fflush(stdout);
      }
    }
  }
  return 0;
}
