// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Maps the sides of a triangulated unit cube to the integer grid, extracts the quad mesh and prints where
// the irregular vertices lie.
//
//   extract_example [quads along an edge of the cube, default 5] [output.off]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Quad_meshing/Extraction/extract_quad_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef std::pair<Mesh::Face_index, std::array<double, 3>> Face_location;

namespace QM = CGAL::Quad_meshing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const int k = argc > 1 ? std::atoi(argv[1]) : 5;
  if(k < 1 || k > 2000)
  {
    std::cerr << "extract_example: the number of quads along an edge must be from 1 to 2000" << std::endl;
    return 2;
  }

  Mesh cube;
  CGAL::make_hexahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0), Kernel::Point_3(1, 1, 0),
                        Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 1, 1), Kernel::Point_3(0, 0, 1),
                        Kernel::Point_3(1, 0, 1), Kernel::Point_3(1, 1, 1), cube);
  PMP::triangulate_faces(cube);

  // The chart of a face drops the coordinate along its normal. For normals that point to the negative
  // side the two others change places, so that the image keeps its orientation.
  auto uv = cube.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  for(Mesh::Face_index f : cube.faces())
  {
    const Kernel::Vector_3 n = PMP::compute_face_normal(f, cube);
    int axis = 0;
    while(std::fabs(n[axis]) < 0.5)
      ++axis;
    for(Mesh::Halfedge_index h : CGAL::halfedges_around_face(cube.halfedge(f), cube))
    {
      const Kernel::Point_3& p = cube.point(cube.target(h));
      const double a = k * p[(axis + 1) % 3], b = k * p[(axis + 2) % 3];
      uv[h] = n[axis] > 0 ? Kernel::Point_2(a, b) : Kernel::Point_2(b, a);
    }
  }

  Mesh quads;
  auto location = quads.add_property_map<Mesh::Vertex_index, Face_location>("v:location").first;
  const QM::Quad_extraction_result result =
    QM::extract_quad_mesh(cube, uv, quads, CGAL::parameters::face_location_map(location));

  std::cout << result.message << std::endl;
  for(Mesh::Vertex_index v : quads.vertices())
    if(quads.degree(v) != 4)
      std::cout << "valence " << quads.degree(v) << " at " << quads.point(v) << ", in face " << location[v].first
                << std::endl;
  if(argc > 2 && !CGAL::IO::write_polygon_mesh(argv[2], quads))
  {
    std::cerr << "extract_example: cannot write " << argv[2] << std::endl;
    return 2;
  }
  return result.status == QM::Quad_extraction_status::VALID ? 0 : 1;
}
