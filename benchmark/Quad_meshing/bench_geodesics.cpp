// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Geodesic distances: time, windows and memory, exact and approximate, against CGAL's Surface_mesh_shortest_path.
//
//   bench_geodesics [--without-reference] MESH...        default: meshes of CGAL's data folder
//
// Each mesh is measured from one vertex and from its sharp edges (dihedral angle above 40 degrees). Memory is what the
// heap holds more at the end of the propagation than before it.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Quad_meshing/Geodesics/Geodesic_distance_field.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/Timer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Quad_meshing::Geodesic_distance_field<Mesh> Field;
typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh> > Shortest_path;

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

struct Measurement
{
  double seconds, megabytes, windows_per_edge;
};

// Of the constructor and the propagation together, as CGAL's class has no separate set-up either.
Measurement measure(const Mesh& tm, const std::function<void(Field&)>& add_sources, double error, std::vector<double>& distances)
{
  Measurement m;
  const double before = heap_megabytes();
  CGAL::Timer timer;
  timer.start();
  Field field(tm);
  add_sources(field);
  const auto result = field.propagate(params::relative_distance_error(error));
  m.seconds = timer.time();
  m.megabytes = heap_megabytes() - before;
  m.windows_per_edge = double(result.number_of_windows) / double(tm.number_of_edges());
  distances.clear();
  for(auto v : tm.vertices())
    distances.push_back(field.distance(v));
  return m;
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
  std::vector<std::string> filenames;
  for(int i = 1; i < argc; ++i)
  {
    if(std::strcmp(argv[i], "--without-reference") == 0)
      with_reference = false;
    else
      filenames.push_back(argv[i]);
  }
  if(filenames.empty())
    for(const char* name : { "eight", "pinion", "holes", "fandisk", "armadillo" })
      filenames.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));

  std::printf("%-22s %8s %7s | %8s %5s %7s | %8s %5s %8s | %9s %8s %7s %9s\n", "mesh", "faces", "source", "exact s", "w/e", "MB",
              "0.1% s", "w/e", "error", "CGAL s", "MB", "ratio", "differ");
  for(const std::string& filename : filenames)
  {
    Mesh tm;
    if(!CGAL::Quad_meshing::read_triangle_mesh(filename, tm))
    {
      std::printf("%s: skipped\n", filename.c_str());
      continue;
    }
    const std::string name = filename.substr(filename.find_last_of('/') + 1);
    std::vector<Mesh::Edge_index> sharp;
    auto is_sharp = tm.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
    CGAL::Polygon_mesh_processing::detect_sharp_edges(tm, 40, is_sharp);
    for(auto e : tm.edges())
      if(is_sharp[e])
        sharp.push_back(e);

    std::vector<double> exact, approximate, reference;
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
      const Measurement a = measure(tm, add_sources, 0, exact), b = measure(tm, add_sources, 1e-3, approximate);
      std::printf("%-22s %8d %7s | %8.3f %5.2f %7.1f | %8.3f %5.2f %8.1e", name.c_str(), int(tm.number_of_faces()),
                  from_edges ? "edges" : "vertex", a.seconds, a.windows_per_edge, a.megabytes, b.seconds, b.windows_per_edge,
                  largest_relative_difference(exact, approximate));
      if(!from_edges && with_reference)
      {
        const double before = heap_megabytes();
        CGAL::Timer timer;
        timer.start();
        Shortest_path shortest_path(tm);
        shortest_path.add_source_point(*tm.vertices().begin());
        shortest_path.build_sequence_tree();
        reference.clear();
        for(auto v : tm.vertices())
          reference.push_back(shortest_path.shortest_distance_to_source_points(v).first);
        const double seconds = timer.time();
        std::printf(" | %9.3f %8.1f %7.1f %9.1e", seconds, heap_megabytes() - before, seconds / a.seconds,
                    largest_relative_difference(exact, reference));
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  return 0;
}
