// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// The cost of the extraction, beside what it costs to read the triangle mesh from OFF text in memory and to copy it
// into flat arrays. The maps are exact: a cube, each side triangulated over random points and divided into k x k quads,
// with a random chart for each triangle.
//
//   bench_extraction [number of triangles, default 300000]

#include "extraction_meshes.h"

#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Timer.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>

int main(int argc, char* argv[])
{
  using namespace extraction_meshes;
  const int triangles = argc > 1 ? std::atoi(argv[1]) : 300000;
  if(triangles < 12)
  {
    std::fprintf(stderr, "bench_extraction: the number of triangles must be at least 12\n");
    return 2;
  }

  std::printf("%10s %10s | %10s %10s %10s | %10s %10s | %12s %12s\n", "triangles", "quads", "read s", "index s",
              "extract s", "x read", "x index", "ns/triangle", "ns/quad");
  for(int k : { 1, 8, 26, 80, 250, 500 })
  {
    Options o;
    o.k = k;
    o.inner_points = triangles / 12;
    o.edge_points = 30;
    o.denominator = 4096;
    const Mapped_mesh m = triangulated(coarse_cube(), o);

    std::stringstream text;
    CGAL::IO::write_OFF(text, m.mesh);
    CGAL::Timer reading, indexing, extracting;
    reading.start();
    Mesh copy;
    CGAL::IO::read_OFF(text, copy);
    reading.stop();

    // Each time is the smallest of three.
    double index_time = HUGE_VAL, extract_time = HUGE_VAL;
    CGAL::Quad_meshing::Quad_extraction_result r;
    for(int i = 0; i < 3; ++i)
    {
      indexing.reset();
      indexing.start();
      CGAL::Quad_meshing::internal::make_indexed_triangle_mesh(
        m.mesh, m.mesh.points(), get(boost::vertex_index, m.mesh), get(boost::face_index, m.mesh));
      indexing.stop();
      index_time = (std::min)(index_time, indexing.time());

      Mesh qm;
      extracting.reset();
      extracting.start();
      r = CGAL::Quad_meshing::extract_quad_mesh(m.mesh, m.uv, qm);
      extracting.stop();
      extract_time = (std::min)(extract_time, extracting.time());
    }
    if(r.status != CGAL::Quad_meshing::Quad_extraction_status::VALID)
    {
      std::printf("%s\n", r.message.c_str());
      return 1;
    }
    std::printf("%10d %10d | %10.3f %10.3f %10.3f | %10.2f %10.2f | %12.0f %12.0f\n",
                static_cast<int>(m.mesh.number_of_faces()), static_cast<int>(r.quads), reading.time(), index_time,
                extract_time, extract_time / reading.time(), extract_time / index_time,
                1e9 * extract_time / m.mesh.number_of_faces(), 1e9 * extract_time / r.quads);
  }
  return 0;
}
