// Copyright (c) 2026 The Quad_meshing authors.
//
// This file is part of Quad_meshing, a package in the style of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quad_meshing authors

// Materials of an OBJ file reach the quads: their borders are chains of quad edges, and each quad has the material of
// the triangle below it.

#include <CGAL/Quad_meshing/IO/Attributes_on_mesh.h>
#include <CGAL/Quad_meshing/IO/find_attribute_borders.h>
#include <CGAL/Quad_meshing/IO/read_mesh_attributes.h>
#include <CGAL/Quad_meshing/IO/read_triangle_mesh.h>
#include <CGAL/Quad_meshing/IO/write_obj.h>
#include <CGAL/Quad_meshing/Quad_mesh/transfer_values.h>
#include <CGAL/Quad_meshing/quadrangulate.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace QM = CGAL::Quad_meshing;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "two_materials.obj";
  if(argc == 1) // a square of two materials
    std::ofstream(filename) << "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nusemtl wood\nf 1 2 5 4\n"
                            << "usemtl steel\nf 2 3 6 5\n";
  Mesh tm;
  QM::Mesh_attributes attributes;
  const QM::Mesh_reading_result reading = QM::read_triangle_mesh(filename, tm);
  if(!reading || !QM::read_mesh_attributes(filename, attributes))
  {
    std::cerr << filename << ": " << reading.message << std::endl;
    return EXIT_FAILURE;
  }
  const QM::Attributes_on_mesh<Mesh> on_mesh(tm, reading, attributes);
  auto is_border = tm.add_property_map<Mesh::Edge_index, bool>("e:is_border", false).first;
  const QM::Attribute_borders borders = QM::find_attribute_borders(tm, on_mesh, is_border);
  std::cout << borders.materials << " edges between materials" << std::endl;

  Mesh qm;
  const QM::Quadrangulation_result result =
    QM::quadrangulate(tm, qm, CGAL::parameters::edge_is_curve_map(is_border).target_number_of_quads(400));
  std::cout << result.message << std::endl;

  auto material = tm.add_property_map<Mesh::Face_index, int>("f:material", -1).first;
  for(Mesh::Face_index f : tm.faces())
    material[f] = on_mesh.name(f, attributes.materials);
  auto quad_material = qm.add_property_map<Mesh::Face_index, int>("f:material", -1).first;
  QM::transfer_face_values(tm, material, qm, quad_material);

  QM::Obj_content<Mesh> content;
  content.materials.names = attributes.materials.names;
  content.materials.number = [&](Mesh::Face_index f) { return quad_material[f]; };
  content.material_libraries = attributes.material_libraries;
  std::ofstream out("quads_with_materials.obj");
  QM::write_obj(out, qm, content);
  return result.is_valid() ? EXIT_SUCCESS : EXIT_FAILURE;
}
